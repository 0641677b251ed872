// SPDX-License-Identifier: MIT
#include "machine/config/load.hpp"

#include "machine/config/field.hpp"
#include "machine/config/value.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::config {

namespace {

// Walks the document beside the table of keys.
class Reader {
  public:
    Reader(const Locator& locator, MachineDescription& machine)
        : locator_(locator), machine_(machine), fields_(machine_fields()) {}

    void read_section(const Value& section, const std::string& prefix) {
        if (section.kind != Value::Kind::mapping) {
            refuse(section.where, prefix, {},
                   fmt::format("{} where a mapping belongs", kind_name(section.kind)),
                   "keys: " + fmt::format("{}", fmt::join(names_under(prefix), ", ")));
        }
        for (const Entry& entry : section.entries) {
            const std::string path = prefix.empty() ? entry.key : prefix + "." + entry.key;
            if (const Field* field = find(path)) {
                read_field(*field, entry.value);
            } else if (!names_under(path).empty()) {
                read_section(entry.value, path);
            } else {
                refuse_key(entry, prefix, path);
            }
        }
    }

    // Whether some machine can have a value there.
    void check_path(const std::vector<std::string>& path, const Position& where) const {
        std::string at;
        for (const std::string& name : path) {
            const std::string above = std::exchange(at, at.empty() ? name : at + "." + name);
            if (const Field* field = find(above); field != nullptr) {
                if (!field->expected.starts_with("a mapping")) {
                    refuse(where, at, {}, fmt::format("'{}' is not inside a mapping", name),
                           field->expected);
                }
                return;  // what it may hold depends on the machine
            }
            if (find(at) == nullptr && names_under(at).empty()) {
                refuse_key({name, where, {}}, above, at);
            }
        }
    }

    void check_required(const Position& where) const {
        for (const Field& field : fields_) {
            const bool idle = field.path == "nodes.program" && !machine_.has_program();
            if (field.required && !idle && !machine_.written.contains(field.path)) {
                refuse(where, field.path, {}, "missing", field.expected);
            }
        }
    }

  private:
    const Field* find(const std::string& path) const {
        const auto found = std::find_if(fields_.begin(), fields_.end(),
                                        [&](const Field& field) { return field.path == path; });
        return found == fields_.end() ? nullptr : &*found;
    }

    // The keys one level below `prefix`; none when it is not a section.
    std::vector<std::string> names_under(const std::string& prefix) const {
        const std::string start = prefix.empty() ? "" : prefix + ".";
        std::vector<std::string> names;
        for (const Field& field : fields_) {
            if (field.path.starts_with(start)) {
                const std::string rest = field.path.substr(start.size());
                const std::string name = rest.substr(0, rest.find('.'));
                if (std::find(names.begin(), names.end(), name) == names.end()) {
                    names.push_back(name);
                }
            }
        }
        return names;
    }

    void read_field(const Field& field, const Value& value) {
        machine_.written[field.path] = value.where;
        try {
            field.read(machine_, value, locator_);
        } catch (const std::invalid_argument& problem) {
            const std::string text = value.kind == Value::Kind::scalar ? value.text : std::string();
            refuse(value.where, field.path, text, problem.what(), field.expected,
                   nearest(field, text));
        }
    }

    // For choices, the rows' "one of a, b, c" holds the valid names.
    static std::string nearest(const Field& field, const std::string& text) {
        constexpr std::string_view kChoice = "one of ";
        if (!field.expected.starts_with(kChoice)) {
            return {};
        }
        std::vector<std::string> names;
        std::string rest = field.expected.substr(kChoice.size());
        for (std::size_t comma = rest.find(", "); comma != std::string::npos;
             comma = rest.find(", ")) {
            names.push_back(rest.substr(0, comma));
            rest.erase(0, comma + 2);
        }
        names.push_back(rest);
        return nearest_name(text, names);
    }

    [[noreturn]] void refuse_key(const Entry& entry, const std::string& prefix,
                                 const std::string& path) const {
        const std::vector<std::string> names = names_under(prefix);
        refuse(entry.where, path, {}, "unknown key",
               fmt::format("one of {}", fmt::join(names, ", ")), nearest_name(entry.key, names));
    }

    const Locator& locator_;
    MachineDescription& machine_;
    const std::vector<Field> fields_;
};

// `scene: file` is replaced by what the file holds, so that overrides can reach into it.
void include_scene(Value& root, const Locator& locator) {
    Value* scene = root.find("scene");
    if (scene == nullptr || scene->kind != Value::Kind::scalar) {
        return;
    }
    const auto path = locator.find(scene->text, scene->where.source, locator.configs());
    if (!path) {
        refuse(scene->where, "scene", scene->text,
               "no such file (looked in " +
                   Locator::places(scene->where.source, locator.configs()) + ")",
               "a scene file such as scenes/teapot.yaml, or a mapping");
    }
    *scene = parse_yaml_file(*path);
    if (scene->kind != Value::Kind::mapping) {
        refuse(scene->where, "scene", {},
               fmt::format("{} where a mapping belongs", kind_name(scene->kind)),
               "the keys of a scene");
    }
}

void check_together(const MachineDescription& machine) {
    const auto at_least = [&machine](const std::string& key, Duration value, Duration least) {
        if (value < least) {
            throw machine.error(key, format_duration(value), "too short",
                                "at least " + format_duration(least));
        }
    };
    at_least("links.latency", machine.links.latency, Duration::picoseconds(2));
    at_least("fabric.latency", machine.fabric.latency, Duration::picoseconds(2));
    at_least("supervisor.latency", machine.supervisor.latency, Duration::picoseconds(2));
    at_least("run.max_time", machine.run.max_time, Duration::picoseconds(1));
    if (machine.array.visible_lines > machine.array.lines) {
        throw machine.error("array.visible_lines", std::to_string(machine.array.visible_lines),
                            "more than a picture has scanlines",
                            fmt::format("at most {}, array.lines", machine.array.lines));
    }
    if (!machine.scene && machine.run.frames != 1) {
        throw machine.error("run.frames", std::to_string(machine.run.frames),
                            "more than one frame without a scene", "1, or a scene to draw");
    }
}

MachineDescription read_tree(Value root, const std::string& source,
                             std::span<const Override> overrides, const Locator& locator) {
    for (const Override& change : overrides) {
        if (change.path.front() == "scene" && change.path.size() > 1) {
            include_scene(root, locator);
        }
        apply_override(root, change);
    }
    if (root.kind == Value::Kind::mapping) {
        include_scene(root, locator);
    }
    MachineDescription machine;
    machine.source = source;
    Reader reader(locator, machine);
    reader.read_section(root, {});
    reader.check_required(root.where);
    check_together(machine);
    return machine;
}

}  // namespace

ConfigError MachineDescription::error(const std::string& key, const std::string& value,
                                      const std::string& what, const std::string& expected,
                                      const std::string& nearest) const {
    const auto found = written.find(key);
    const Position where = found == written.end() ? Position{source, 0, 0} : found->second;
    return ConfigError({where, key, value, what, expected, nearest});
}

MachineDescription load_machine(const std::string& file, std::span<const Override> overrides,
                                const Locator& locator) {
    const auto found = locator.find(file, ".", locator.configs());
    const std::string path = found && !std::filesystem::exists(file) ? found->string() : file;
    return read_tree(parse_yaml_file(path), path, overrides, locator);
}

void check_key(const std::vector<std::string>& path, const Position& where) {
    MachineDescription ignored;
    const Locator nowhere{std::filesystem::path()};
    Reader(nowhere, ignored).check_path(path, where);
}

void check_override(const Override& change, const Locator& locator) {
    Value root;
    root.kind = Value::Kind::mapping;
    if (change.path.front() == "topology" && change.path.size() > 1) {
        // A topology without a kind is refused whatever else it has.
        Override kind = make_override("topology.kind", "any", {});
        apply_override(root, kind);
    }
    apply_override(root, change);
    include_scene(root, locator);
    MachineDescription ignored;
    Reader(locator, ignored).read_section(root, {});
}

MachineDescription read_machine(std::string_view text, const std::string& source,
                                std::span<const Override> overrides, const Locator& locator) {
    return read_tree(parse_yaml(text, source), source, overrides, locator);
}

}  // namespace rasterloom::config
