// SPDX-License-Identifier: MIT
#include "machine/emulation/princeton_screen.hpp"

#include "machine/emulation/node_memory.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom {

host::TriangleView program_view(const isa::Image& image) {
    host::TriangleView view;
    const auto columns = static_cast<int>(require_symbol(image, "screen_columns"));
    const auto rows = static_cast<int>(require_symbol(image, "screen_rows"));
    view.focal = std::min(view.focal * columns / view.width, view.focal * rows / view.height);
    view.width = columns;
    view.height = rows;
    return view;
}

bool has_frame_buffers(const isa::Image& image) {
    return image.symbol("video").value_or(1) != 0;
}

ColumnMap columns_as_lanes(std::int64_t lanes, std::int64_t columns) {
    ColumnMap map(static_cast<std::size_t>(lanes));
    const auto width = static_cast<std::size_t>(std::min(lanes, columns));
    for (std::size_t lane = 0; lane < width; ++lane)
        map[lane] = static_cast<std::uint16_t>(lane);
    return map;
}

ColumnMap columns_of_map(const topology::RegionMap& map) {
    ColumnMap columns(map.regions());
    for (topology::RegionIndex lane = 0; lane < map.regions(); ++lane) {
        const auto& rectangles = map.rectangles_of(lane);
        if (rectangles.empty())
            continue;
        const topology::PixelBox& box = rectangles.front();
        if (rectangles.size() > 1 || box.x0 != box.x1 || box.y0 != 0 || box.y1 != map.height() - 1)
            throw std::invalid_argument(
                fmt::format("the screen map gives lane {} {} ({},{}) ({},{}), expected one whole "
                            "column of {} rows, or nothing",
                            lane, rectangles.size() > 1 ? "more than" : "a rectangle", box.x0,
                            box.y0, box.x1, box.y1, map.height()));
        columns[lane] = static_cast<std::uint16_t>(box.x0);
    }
    return columns;
}

// Sort-middle's sparse ring: all the way round, and each lane looks for its own column.
bool takes_any_columns(const isa::Image& image) {
    return !image.symbol("kRegion") && image.symbol("sort_first").value_or(0) == 0 &&
           require_symbol(image, "dense") == 0 && require_symbol(image, "stride") <= 1;
}

void check_columns(const ColumnMap& map, std::int64_t lanes, std::int64_t columns) {
    if (static_cast<std::int64_t>(map.size()) != lanes)
        throw std::invalid_argument(
            fmt::format("a screen map of {} lanes, expected {}", map.size(), lanes));
    const auto width = static_cast<std::size_t>(std::min(lanes, columns));
    std::vector<int> owners(width, 0);
    for (std::size_t lane = 0; lane < map.size(); ++lane)
        if (const auto column = map[lane]) {
            if (*column >= width)
                throw std::invalid_argument(
                    fmt::format("the screen map gives column {} to lane {}, expected 0 to {}",
                                *column, lane, width - 1));
            ++owners[*column];
        }
    for (std::size_t column = 0; column < width; ++column)
        if (owners[column] != 1)
            throw std::invalid_argument(
                fmt::format("the screen map gives column {} to {} lanes, expected one", column,
                            owners[column]));
}

}  // namespace rasterloom
