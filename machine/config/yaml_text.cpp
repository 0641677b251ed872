// SPDX-License-Identifier: MIT
#include "machine/config/yaml_text.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace rasterloom::config {

std::string yaml_scalar(std::string_view text) {
    const bool plain =
        !text.empty() && text != "null" && text != "~" &&
        std::all_of(text.begin(), text.end(), [](char c) {
            const auto byte = static_cast<unsigned char>(c);
            return std::isalnum(byte) || c == '_' || c == '/' || c == '.' || c == '+';
        });
    if (plain) {
        return std::string(text);
    }
    std::string quoted = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            quoted += '\\';
            quoted += c;
        } else if (byte < 0x20 || byte == 0x7f) {
            quoted += fmt::format("\\x{:02x}", byte);
        } else {
            quoted += c;
        }
    }
    return quoted + "\"";
}

std::string yaml_text(const Value& value) {
    // With a dash: in this use no reader can take it for a list's.
    const auto is_plain = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
               std::string_view("_/.+-").find(c) != std::string_view::npos;
    };
    std::vector<std::string> parts;
    switch (value.kind) {
        case Value::Kind::null:
            return "null";
        case Value::Kind::scalar:
            return value.text.find('-') != std::string::npos &&
                           std::all_of(value.text.begin(), value.text.end(), is_plain)
                       ? value.text
                       : yaml_scalar(value.text);
        case Value::Kind::sequence:
            for (const Value& item : value.items) {
                parts.push_back(yaml_text(item));
            }
            return fmt::format("[{}]", fmt::join(parts, ", "));
        case Value::Kind::mapping:
            for (const Entry& entry : value.entries) {
                parts.push_back(
                    fmt::format("{}: {}", yaml_scalar(entry.key), yaml_text(entry.value)));
            }
            return fmt::format("{{{}}}", fmt::join(parts, ", "));
    }
    return {};
}

}  // namespace rasterloom::config
