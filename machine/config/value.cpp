// SPDX-License-Identifier: MIT
#include "machine/config/value.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

namespace rasterloom::config {

namespace {

constexpr int kDeepestNesting = 32;

// Builds the tree from the parser's events. Keys and values of a mapping arrive alternately.
class TreeBuilder final : public YAML::EventHandler {
  public:
    explicit TreeBuilder(std::string source) : source_(std::move(source)) {}

    Value take() { return std::move(root_); }

    void OnDocumentStart(const YAML::Mark&) override {}
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        add({Value::Kind::null, position(mark), {}, {}, {}}, anchor);
    }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { refuse_anchor(position(mark)); }
    void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  const std::string& text) override {
        add({Value::Kind::scalar, position(mark), text, {}, {}}, anchor);
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override {
        open(Value::Kind::sequence, mark, anchor);
    }
    void OnSequenceEnd() override { close(); }
    void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override {
        open(Value::Kind::mapping, mark, anchor);
    }
    void OnMapEnd() override { close(); }

  private:
    struct Level {
        Value value;
        std::string key;  // of a mapping: the key whose value comes next
        Position key_where;
        bool has_key = false;
    };

    Position position(const YAML::Mark& mark) const {
        return {source_, mark.line + 1, mark.column + 1};
    }

    [[noreturn]] static void refuse_anchor(const Position& where) {
        refuse(where, {}, {}, "anchors and aliases are not part of a configuration",
               "the value written out");
    }

    void open(Value::Kind kind, const YAML::Mark& mark, YAML::anchor_t anchor) {
        const Position where = position(mark);
        if (anchor != 0) {
            refuse_anchor(where);
        }
        if (levels_.size() >= kDeepestNesting) {
            refuse(where, {}, {}, "nested too deeply",
                   fmt::format("at most {} levels", kDeepestNesting));
        }
        levels_.push_back({{kind, where, {}, {}, {}}, {}, {}, false});
    }

    void close() {
        Value finished = std::move(levels_.back().value);
        levels_.pop_back();
        add(std::move(finished), 0);
    }

    void add(Value value, YAML::anchor_t anchor) {
        if (anchor != 0) {
            refuse_anchor(value.where);
        }
        if (levels_.empty()) {
            root_ = std::move(value);
            return;
        }
        Level& level = levels_.back();
        if (level.value.kind == Value::Kind::sequence) {
            level.value.items.push_back(std::move(value));
        } else if (!level.has_key) {
            begin_entry(level, value);
        } else {
            level.value.entries.push_back({level.key, level.key_where, std::move(value)});
            level.has_key = false;
        }
    }

    static void begin_entry(Level& level, const Value& key) {
        if (key.kind != Value::Kind::scalar) {
            refuse(key.where, {}, {}, fmt::format("{} where a key belongs", kind_name(key.kind)),
                   "a name");
        }
        if (const auto& entries = level.value.entries;
            std::any_of(entries.begin(), entries.end(),
                        [&](const Entry& entry) { return entry.key == key.text; })) {
            refuse(key.where, key.text, {}, "written twice", "each key once");
        }
        level.key = key.text;
        level.key_where = key.where;
        level.has_key = true;
    }

    std::string source_;
    std::vector<Level> levels_;
    Value root_;
};

// Overrides have no lines: their whole tree bears the override's name.
void place_at(Value& value, const Position& where) {
    value.where = where;
    for (Value& item : value.items) {
        place_at(item, where);
    }
    for (Entry& entry : value.entries) {
        entry.where = where;
        place_at(entry.value, where);
    }
}

}  // namespace

const Value* Value::find(std::string_view key) const {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const Entry& entry) { return entry.key == key; });
    return found == entries.end() ? nullptr : &found->value;
}

Value* Value::find(std::string_view key) {
    return const_cast<Value*>(static_cast<const Value*>(this)->find(key));
}

std::string_view kind_name(Value::Kind kind) {
    switch (kind) {
        case Value::Kind::null:
            return "nothing";
        case Value::Kind::scalar:
            return "a value";
        case Value::Kind::sequence:
            return "a list";
        case Value::Kind::mapping:
            return "a mapping";
    }
    return "nothing";
}

Value parse_yaml(std::string_view text, const std::string& source) {
    std::istringstream stream{std::string(text)};
    try {
        YAML::Parser parser(stream);
        TreeBuilder builder(source);
        if (!parser.HandleNextDocument(builder)) {
            refuse({source, 1, 1}, {}, {}, "the file is empty", "a configuration");
        }
        TreeBuilder rest(source);
        if (parser.HandleNextDocument(rest)) {
            refuse(rest.take().where, {}, {}, "a second document begins",
                   "one configuration a file");
        }
        return builder.take();
    } catch (const YAML::Exception& error) {
        const int line = std::max(error.mark.line, 0) + 1;
        const int column = std::max(error.mark.column, 0) + 1;
        refuse({source, line, column}, {}, {}, "not valid YAML: " + error.msg, {});
    }
}

Value parse_yaml_file(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        refuse({path.string(), 0, 0}, {}, {}, "is a directory", "a YAML file");
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        refuse({path.string(), 0, 0}, {}, {}, "cannot be read: no such file, or not permitted",
               "a YAML file");
    }
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    return parse_yaml(text, path.string());
}

std::vector<std::string> split_path(std::string_view text, const Position& where) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    for (std::size_t dot = 0; dot != std::string_view::npos; begin = dot + 1) {
        dot = text.find('.', begin);
        parts.emplace_back(text.substr(begin, dot == std::string_view::npos ? dot : dot - begin));
        if (parts.back().empty()) {
            refuse(where, {}, {}, "an empty name in the key", "names joined by dots");
        }
    }
    return parts;
}

Override parse_override(std::string_view text) {
    const std::size_t equals = text.find('=');
    const std::string_view key = text.substr(0, equals);
    const Position where{fmt::format("--set {}", key), 0, 0};
    if (equals == std::string_view::npos || key.empty()) {
        refuse(where, {}, {}, "an override without a value",
               "key=value, such as links.time_per_byte=2us");
    }
    Override change{split_path(key, where), {}};
    const std::string_view written = text.substr(equals + 1);
    if (written.empty()) {
        refuse(where, {}, {}, "an override without a value", "key=value");
    }
    change.value = parse_yaml(written, where.source);
    place_at(change.value, where);
    return change;
}

Override make_override(std::string_view path, std::string_view text, const std::string& option) {
    const Position where{option, 0, 0};
    Override change{split_path(path, where), {}};
    change.value.kind = Value::Kind::scalar;
    change.value.where = where;
    change.value.text = text;
    return change;
}

void apply_override(Value& root, const Override& change) {
    Value* at = &root;
    for (const std::string& name : change.path) {
        if (at->kind != Value::Kind::mapping) {
            refuse(change.value.where, {}, {}, fmt::format("'{}' is not inside a mapping", name),
                   "the key of a mapping in the file");
        }
        Value* next = at->find(name);
        if (next == nullptr) {
            Value fresh;
            fresh.kind = Value::Kind::mapping;
            fresh.where = change.value.where;
            at->entries.push_back({name, change.value.where, std::move(fresh)});
            next = &at->entries.back().value;
        }
        at = next;
    }
    *at = change.value;
}

}  // namespace rasterloom::config
