// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace rasterloom::observe {

// A text as a field of a CSV file. Names come from the user's files.
inline std::string csv_text(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) {
        return text;
    }
    std::string quoted(1, '"');
    for (const char c : text) {
        quoted += c;
        if (c == '"') {
            quoted += c;
        }
    }
    quoted += '"';
    return quoted;
}

}  // namespace rasterloom::observe
