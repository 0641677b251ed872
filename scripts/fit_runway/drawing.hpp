// SPDX-License-Identifier: MIT
// The shuttle as it is to be seen, and small polygons on the screen.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <vector>

inline constexpr int kLeft = 370, kBottom = 253, kColumns = 70, kLines = 15;
inline constexpr int kCells = kColumns * kLines;

// The picture that is wanted; a letter is a grey.
inline constexpr std::array<const char*, kLines> kDrawing{
    "............................................TTtt......................",
    "...........................................TTTtt......................",
    "..........................................TTTTtt......................",
    ".........................................TTTTTtt......................",
    "........................................TTTTTtt.......................",
    "...............WWWW....................WTTTTTttW......................",
    ".............GGWWWWWW..............WWWWWTTTTTttWW.....................",
    "............WGGWWWWWWRRRRRRRRRRRRRRWWWWWWWWwwwwDD.....................",
    "..........WWWWWWWWWWWBBBBBBBBBBBBBBWWWWWWWWWwwDDD.....................",
    ".........wWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWwwwwDDD....................",
    "..........wwwwwwwwwwwwwwwwwUUUUUUUUUUwwwwwwwwwwwDDD...................",
    "............Dw.KKKKKKKKKKKKKUUUUUUUUUUUUUUUUUUUUUUUUU.................",
    "...........DDD..............KUUUUUUUUUUUUUUUUUUUUUUUUUUUUU............",
    "..............................kUUUUUUUUUUUUUUUUUUUUUUUUUUUU...........",
    "................................kkkkUUUUUUUUUUUUUUUUUUUUUUUUUU........"};
inline const std::map<char, int> kGreys{{'W', 235}, {'T', 225}, {'U', 210}, {'w', 195},
                                        {'t', 180}, {'R', 165}, {'B', 95},  {'k', 60},
                                        {'D', 55},  {'K', 40},  {'G', 20}};

struct Corner {
    int x, y;
    friend auto operator<=>(const Corner&, const Corner&) = default;
};
using Outline = std::vector<Corner>;  // counter-clockwise
struct Row {
    int y, left, right;
};

inline const Outline kApron{{385, 207}, {508, 249}, {460, 279}, {406, 279}};

// The rule of machine/host/polygon_renderer.hpp.
inline std::vector<Row> rows_of(const Outline& outline) {
    const auto count = outline.size();
    const auto [low, high] = std::ranges::minmax_element(outline, {}, &Corner::y);
    std::size_t first_left = count, first_right = count;
    for (std::size_t i = 0; i < count; ++i) {
        if (outline[i].y != high->y)
            continue;
        if (first_left == count || outline[i].x < outline[first_left].x)
            first_left = i;
        if (first_right == count || outline[i].x > outline[first_right].x)
            first_right = i;
    }
    const auto side = [&](std::size_t& from, std::size_t step, int y) {
        while (outline[from].y != y && outline[(from + step) % count].y >= y)
            from = (from + step) % count;
        const auto& a = outline[from];
        const auto& b = outline[(from + step) % count];
        if (a.y == y)
            return a.x;
        return (a.x * 65536 + 32768 + 2 * (a.y - y) * ((b.x - a.x) * 32768 / (a.y - b.y))) >> 16;
    };
    std::vector<Row> rows;
    for (int y = high->y; y >= low->y; --y) {
        const int left = side(first_left, 1, y);
        rows.push_back({y, left, std::max(left, side(first_right, count - 1, y))});
    }
    return rows;
}

inline bool is_strictly_convex(const Outline& outline) {
    const auto count = outline.size();
    if (count < 3)
        return count == 1 || outline[0] != outline[1];
    for (std::size_t i = 0; i < count; ++i) {
        const auto& a = outline[i];
        const auto& b = outline[(i + 1) % count];
        const auto& c = outline[(i + 2) % count];
        if ((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x) <= 0)
            return false;
    }
    return true;
}

inline int cell_of(int x, int y) {
    return (y - kBottom) * kColumns + x - kLeft;
}

inline char drawn_at(int cell) {
    return kDrawing[static_cast<std::size_t>(kLines - 1 - cell / kColumns)][cell % kColumns];
}

inline bool is_in_drawing(const std::vector<Row>& rows) {
    return std::ranges::all_of(rows, [](const Row& row) {
        if (row.y < kBottom || row.y >= kBottom + kLines || row.left < kLeft ||
            row.right >= kLeft + kColumns)
            return false;
        for (int x = row.left; x <= row.right; ++x)
            if (drawn_at(cell_of(x, row.y)) == '.')
                return false;
        return true;
    });
}
