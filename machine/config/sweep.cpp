// SPDX-License-Identifier: MIT
#include "machine/config/sweep.hpp"

#include "machine/config/load.hpp"
#include "machine/config/yaml_text.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::config {

namespace {

constexpr std::size_t kMostPoints = 1'000'000;

void refuse_kind(const Value& value, const std::string& key, const std::string& expected) {
    refuse(value.where, key, {}, fmt::format("{} where a list belongs", kind_name(value.kind)),
           expected);
}

// A list, or one value in place of a list of one.
std::vector<Value> items_of(const Value& value, const std::string& key) {
    if (value.kind == Value::Kind::null) {
        refuse_kind(value, key, "a list of values");
    }
    if (value.kind != Value::Kind::sequence) {
        return {value};
    }
    if (value.items.empty()) {
        refuse(value.where, key, {}, "an empty list: the sweep has no points",
               "one value or several");
    }
    return value.items;
}

void refuse_repetition(const std::vector<Value>& items, const std::string& key) {
    std::set<std::string> seen;
    for (const Value& item : items) {
        const std::string text = yaml_text(item);
        if (!seen.insert(text).second) {
            refuse(item.where, key, text, "written twice", "each value once");
        }
    }
}

std::vector<Value> file_names(const Value& value, const std::string& key) {
    std::vector<Value> items = items_of(value, key);
    for (const Value& item : items) {
        if (item.kind != Value::Kind::scalar || item.text.empty()) {
            refuse(item.where, key, {},
                   fmt::format("{} where a file's name belongs", kind_name(item.kind)),
                   "the name of a YAML file");
        }
    }
    refuse_repetition(items, key);
    return items;
}

// The lines of the file that say the same as an override of `key`.
void refuse_key_of_its_own(const std::string& key, const Position& where) {
    constexpr std::array<std::pair<std::string_view, const char*>, 3> kElsewhere{
        std::pair{"scene", "scenes: [FILE, ...], or keys such as scene.object"},
        std::pair{"run.frames", "frames: N"},
        std::pair{"run.threads", "--workers: points run side by side, each on one thread"}};
    for (const auto& [name, instead] : kElsewhere) {
        if (key == name) {
            refuse(where, key, {}, "cannot be varied", instead);
        }
    }
}

class SweepReader {
  public:
    SweepReader(SweepDescription& sweep, const Locator& locator)
        : sweep_(sweep), locator_(locator) {}

    void read(const Value& root) {
        if (root.kind != Value::Kind::mapping) {
            refuse(root.where, {}, {},
                   fmt::format("{} where a mapping belongs", kind_name(root.kind)),
                   "keys: configs, scenes, vary, frames, out");
        }
        for (const Entry& entry : root.entries) {
            read_entry(entry);
        }
        if (sweep_.configs.empty()) {
            refuse(root.where, "configs", {}, "missing: the sweep has no points",
                   "configs: [FILE, ...]");
        }
        std::sort(sweep_.parameters.begin(), sweep_.parameters.end(),
                  [](const auto& a, const auto& b) { return a.key < b.key; });
        check_size(root.where);
    }

  private:
    void read_entry(const Entry& entry) {
        const Value& value = entry.value;
        if (entry.key == "configs") {
            sweep_.configs = file_names(value, "configs");
        } else if (entry.key == "scenes") {
            for (const Value& name : file_names(value, "scenes")) {
                sweep_.scenes.push_back(checked({{"scene"}, name}));
            }
        } else if (entry.key == "vary") {
            read_parameters(value);
        } else if (entry.key == "frames") {
            sweep_.frames = checked({{"run", "frames"}, value});
        } else if (entry.key == "out") {
            if (value.kind != Value::Kind::scalar || value.text.empty()) {
                refuse(value.where, "out", {}, "no name", "a folder");
            }
            sweep_.out = value.text;
        } else {
            const std::vector<std::string> keys{"configs", "scenes", "vary", "frames", "out"};
            refuse(entry.where, entry.key, {}, "unknown key",
                   fmt::format("one of {}", fmt::join(keys, ", ")), nearest_name(entry.key, keys));
        }
    }

    void read_parameters(const Value& vary) {
        if (vary.kind != Value::Kind::mapping) {
            refuse(vary.where, "vary", {},
                   fmt::format("{} where a mapping belongs", kind_name(vary.kind)),
                   "keys with lists of values, such as { links.time_per_byte: [1us, 2us] }");
        }
        for (const Entry& entry : vary.entries) {
            refuse_key_of_its_own(entry.key, entry.where);
            SweepParameter parameter{entry.key, {}};
            const std::vector<std::string> path = split_path(entry.key, entry.where);
            const std::vector<Value> items = items_of(entry.value, entry.key);
            // The key before its values, so that a wrong key is what is complained of.
            check_key(path, entry.where);
            refuse_repetition(items, entry.key);
            for (const Value& item : items) {
                parameter.values.push_back(checked({path, item}));
            }
            sweep_.parameters.push_back(std::move(parameter));
        }
    }

    Override checked(Override change) const {
        check_override(change, locator_);
        return change;
    }

    void check_size(const Position& where) const {
        std::size_t points = sweep_.configs.size() * std::max<std::size_t>(1, sweep_.scenes.size());
        for (const SweepParameter& parameter : sweep_.parameters) {
            if (points <= kMostPoints) {  // else the product might not fit
                points *= parameter.values.size();
            }
        }
        if (points > kMostPoints) {
            refuse(where, {}, {}, "too many points", fmt::format("at most {}", kMostPoints));
        }
    }

    SweepDescription& sweep_;
    const Locator& locator_;
};

SweepDescription read_tree(const Value& root, const std::string& source, const Locator& locator) {
    SweepDescription sweep;
    sweep.source = source;
    SweepReader(sweep, locator).read(root);
    return sweep;
}

}  // namespace

std::size_t SweepDescription::size() const {
    std::size_t points = configs.size() * std::max<std::size_t>(1, scenes.size());
    for (const SweepParameter& parameter : parameters) {
        points *= parameter.values.size();
    }
    return points;
}

SweepPoint SweepDescription::point(std::size_t index) const {
    // The last parameter changes fastest.
    std::vector<const Override*> chosen(parameters.size());
    for (std::size_t i = parameters.size(); i-- > 0;) {
        const std::vector<Override>& values = parameters[i].values;
        chosen[i] = &values[index % values.size()];
        index /= values.size();
    }
    SweepPoint point;
    const auto add = [&point](const std::string& name, const Override& change) {
        point.overrides.push_back(change);
        point.key += fmt::format(" {}={}", name, yaml_text(change.value));
    };
    const std::size_t scene_count = std::max<std::size_t>(1, scenes.size());
    point.config = configs[index / scene_count];
    point.key = "config=" + yaml_text(point.config);
    if (!scenes.empty()) {
        const Override& scene = scenes[index % scene_count];
        point.scene = scene.value.text;
        add("scene", scene);
    }
    if (frames) {
        add("frames", *frames);
    }
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const Value& value = chosen[i]->value;
        // A column of its own holds it: no quotes.
        point.values.push_back(value.kind == Value::Kind::scalar ? value.text : yaml_text(value));
        add(parameters[i].key, *chosen[i]);
    }
    return point;
}

SweepDescription load_sweep(const std::string& file, const Locator& locator) {
    const auto found = locator.find(file, ".", locator.configs());
    const std::string path = found && !std::filesystem::exists(file) ? found->string() : file;
    return read_tree(parse_yaml_file(path), path, locator);
}

SweepDescription read_sweep(std::string_view text, const std::string& source,
                            const Locator& locator) {
    return read_tree(parse_yaml(text, source), source, locator);
}

MachineDescription load_point(const SweepPoint& point, const Locator& locator) {
    const Value& config = point.config;
    const auto path = locator.find(config.text, config.where.source, locator.configs());
    if (!path) {
        refuse(config.where, "configs", config.text,
               "no such file (looked in " +
                   Locator::places(config.where.source, locator.configs()) + ")",
               "the configuration of a machine");
    }
    std::vector<Override> overrides = point.overrides;
    overrides.push_back(make_override("run.threads", "1", "sweep"));
    return load_machine(path->string(), overrides, locator);
}

}  // namespace rasterloom::config
