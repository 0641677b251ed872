// SPDX-License-Identifier: MIT
// What Parks 1982 publishes of figure 15 in appendix C, as targets for a search.
#pragma once

#include "drawing.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// A histogram and what it should be, from `from` to `to`; nothing is asked of other values.
class Target {
  public:
    Target() = default;
    // `wanted` as "value:count value:count".
    Target(double weight, int from, int to, const std::string& wanted)
        : weight_(weight), from_(from), to_(to) {
        std::istringstream text(wanted);
        std::size_t value = 0;
        char colon = 0;
        for (int count = 0; text >> value >> colon >> count;)
            missing_[value] = count;
    }
    // What others contribute.
    void discount(int value) {
        if (auto& count = missing_[clamp(value)]; count > 0)
            --count;
    }
    // Returns by how much the error grows.
    double add(int value, int times) {
        auto& count = missing_[clamp(value)];
        const int before = std::abs(count);
        count -= times;
        return value < from_ || value > to_ ? 0 : weight_ * (std::abs(count) - before);
    }
    int wrong() const {
        int sum = 0;
        for (int value = from_; value <= to_; ++value)
            sum += std::abs(missing_[clamp(value)]);
        return sum;
    }

  private:
    static std::size_t clamp(int value) { return static_cast<std::size_t>(std::min(value, 127)); }

    double weight_ = 0;
    int from_ = 1, to_ = 0;
    std::array<int, 128> missing_{};
};

// One processor's pixels: a part of the screen, and every step-th line and column of it.
struct Processor {
    const char* name;
    int left, right, bottom, top;
    int x_step, x_phase, y_step, y_phase;
    Target lengths, heights, depth, corners;

    bool has_line(int y) const { return y >= bottom && y <= top && y % y_step == y_phase; }
    bool has(int x, int y) const {
        return has_line(y) && x >= left && x <= right && x % x_step == x_phase;
    }
    int columns(const Row& row) const {
        const auto up_to = [&](int x) { return (x - x_phase + x_step) / x_step; };
        const int from = std::max(row.left, left), to = std::min(row.right, right);
        return from > to ? 0 : up_to(to) - up_to(from - 1);
    }
    bool reaches(const Row& row) const {
        return row.y >= bottom && row.y <= top && row.left <= right && row.right >= left;
    }
};

// clang-format off
// Appendix C without ground and runway; the apron is taken off later. Processor 6's 21 points are
// what splitter4's processor 1 has beyond splitter16's processor 7.
inline std::vector<Processor> appendix_c() {
    return {
        {"uniprocessor", 0, 511, 0, 511, 1, 0, 1, 0,
         {8, 1, 120, "1:462 2:155 3:64 4:28 5:23 6:2 7:4 8:2 9:1 10:3 11:6 12:6 13:4 29:1"},
         {},
         {6, 3, 120, "3:35 4:42 5:31 6:68 7:22 8:21 9:24 10:22 11:10 12:8 13:4 14:2 16:2 17:1 19:1"},
         {}},
        {"splitter16 6", 256, 383, 128, 255, 1, 0, 1, 0,
         {2, 1, 120, "1:21"},
         {3, 1, 20, "1:21"},
         {},
         {}},
        {"splitter16 7", 384, 511, 128, 255, 1, 0, 1, 0,
         {2, 1, 120, "1:37 2:7 3:9 4:14 5:7 6:1 7:2 8:2 9:1 10:3 11:4 12:2 13:2"},
         {3, 1, 20, "1:20 2:18 3:10"},
         {2, 3, 120, "3:17 4:27 5:2 6:20 7:5 8:5 9:6 10:4 11:1 12:1"},
         {1.5, 1, 9, "2:17 3:29 4:2"}},
        {"interlace4 2", 0, 511, 0, 511, 2, 0, 2, 1,
         {0.7, 0, 8, "0:112 1:222 2:48 3:10 4:1 5:1 6:2 7:2 8:1"},
         {2, 0, 20, "0:14 1:134 2:71 3:16 6:2 7:4 8:4"},
         {0.5, 3, 120, "3:11 4:15 5:2 6:14 7:3 8:2 9:5 10:10 11:1 12:4 13:2 16:1 19:1"},
         {}},
        {"interlace16 3", 0, 511, 0, 511, 4, 3, 4, 0,
         {0.7, 0, 4, "0:84 1:100 2:2 3:6 4:3"},
         {2, 0, 20, "0:85 1:137 2:13 3:10"},
         {0.5, 3, 120, "5:2 6:7 7:2 8:1 9:3 10:4 11:1 13:1"},
         {}},
        {"interlace16 8", 0, 511, 0, 511, 4, 0, 4, 2,
         {0.7, 0, 4, "0:79 1:80 2:4 3:4 4:1"},
         {2, 0, 20, "0:104 1:131 2:2 4:8"},
         {0.5, 3, 120, "3:1 4:4 5:1 6:6 7:2 8:2 10:4"},
         {}},
        {"hybrid16 1.3", 256, 511, 0, 255, 2, 1, 2, 1,
         {0.7, 0, 6, "0:23 1:31 2:12 3:8 4:1 5:2 6:3"},
         {2, 0, 20, "0:2 1:57 2:10"},
         {0.5, 3, 120, "3:6 4:11 5:2 6:2 7:2 8:1 9:2 11:2 12:1"},
         {}}};
}
// clang-format on

// Corners and lines of `number` polygons: C.1's two histograms, combined as seems natural.
struct Kind {
    int corners, lines, number;
};
inline constexpr std::array kKinds{
    Kind{1, 1, 2},  Kind{2, 1, 29}, Kind{2, 2, 20}, Kind{3, 2, 70}, Kind{4, 2, 5}, Kind{2, 3, 5},
    Kind{3, 3, 50}, Kind{4, 3, 12}, Kind{5, 3, 1},  Kind{3, 4, 15}, Kind{4, 4, 6}, Kind{5, 4, 2},
    Kind{3, 5, 4},  Kind{4, 5, 3},  Kind{3, 6, 6},  Kind{4, 6, 4},  Kind{5, 6, 1}, Kind{3, 11, 2},
    Kind{3, 14, 3}, Kind{4, 14, 1}, Kind{3, 15, 3}, Kind{4, 15, 1}};
