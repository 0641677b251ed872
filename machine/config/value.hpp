// SPDX-License-Identifier: MIT
// A YAML document as a tree of values that know where they were written. yaml-cpp parses; this tree
// adds positions of keys, refuses what a configuration has no use for (duplicate keys, anchors,
// several documents), and takes overrides.
#pragma once

#include "machine/config/error.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::config {

struct Entry;

struct Value {
    enum class Kind : std::uint8_t { null, scalar, sequence, mapping };

    Kind kind = Kind::null;
    Position where;
    std::string text;            // scalar
    std::vector<Value> items;    // sequence
    std::vector<Entry> entries;  // mapping, in the order written

    const Value* find(std::string_view key) const;
    Value* find(std::string_view key);
};

struct Entry {
    std::string key;
    Position where;  // of the key
    Value value;
};

std::string_view kind_name(Value::Kind kind);  // "nothing", "a value", "a list", "a mapping"

// Throws ConfigError. An empty document is an error: a configuration says something.
Value parse_yaml(std::string_view text, const std::string& source);
Value parse_yaml_file(const std::filesystem::path& path);

// One "--set a.b=value". The value is YAML ("[1, 0, 0]").
struct Override {
    std::vector<std::string> path;
    Value value;
};
// "a.b" in its parts. Throws when one of them is empty.
std::vector<std::string> split_path(std::string_view text, const Position& where);
Override parse_override(std::string_view text);
// A scalar given by an option of its own, such as --frames 3; `option` names it in messages.
Override make_override(std::string_view path, std::string_view text, const std::string& option);

// Puts the override's value in the tree, making the mappings on the way. Throws when the way leads
// through a value.
void apply_override(Value& root, const Override& change);

}  // namespace rasterloom::config
