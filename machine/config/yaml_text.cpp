// SPDX-License-Identifier: MIT
#include "machine/config/yaml_text.hpp"

#include <algorithm>
#include <cctype>

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

}  // namespace rasterloom::config
