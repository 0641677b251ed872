// SPDX-License-Identifier: MIT
// Damage for readers of files to survive.
#pragma once

#include <random>
#include <string>
#include <string_view>

namespace rasterloom {

// A few bytes replaced, removed, inserted or repeated.
inline std::string damaged(std::string_view whole, std::mt19937& random) {
    std::string text(whole);
    const auto below = [&random](std::size_t n) { return n == 0 ? 0 : random() % n; };
    for (auto times = 1 + below(4); times > 0 && !text.empty(); --times) {
        const auto at = below(text.size());
        switch (below(4)) {
            case 0:
                text[at] = static_cast<char>(below(256));
                break;
            case 1:
                text.erase(at, 1 + below(20));
                break;
            case 2:
                text.insert(at, 1, static_cast<char>(below(256)));
                break;
            default:
                text.insert(at, text.substr(below(text.size()), below(30)));
        }
    }
    return text;
}

}  // namespace rasterloom
