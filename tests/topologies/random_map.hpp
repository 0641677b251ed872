// SPDX-License-Identifier: MIT
// Screens divided at random, for properties.
#pragma once

#include "topologies/region_map.hpp"

#include <algorithm>
#include <vector>

#include <rapidcheck.h>

namespace rasterloom::topology {

// Each region has none, one or several rectangles: the screen is cut in two again and again.
inline std::vector<RegionMap::Share> random_shares(int width, int height, RegionIndex regions) {
    std::vector<PixelBox> boxes{{0, 0, width - 1, height - 1}};
    for (int cuts = *rc::gen::inRange(0, 12); cuts > 0; --cuts) {
        PixelBox& box = boxes[*rc::gen::inRange<std::size_t>(0, boxes.size())];
        PixelBox rest = box;
        if (*rc::gen::arbitrary<bool>() && box.x0 < box.x1)
            rest.x0 = 1 + (box.x1 = *rc::gen::inRange(box.x0, box.x1));
        else if (box.y0 < box.y1)
            rest.y0 = 1 + (box.y1 = *rc::gen::inRange(box.y0, box.y1));
        else
            continue;
        boxes.push_back(rest);
    }
    std::vector<RegionMap::Share> shares;
    for (const PixelBox& box : boxes)
        shares.push_back({*rc::gen::inRange<RegionIndex>(0, regions), box, shares.size() + 1});
    return shares;
}

inline PixelBox random_pixel_box(int width, int height) {
    const auto ordered = [](int size) {
        return std::minmax({*rc::gen::inRange(0, size), *rc::gen::inRange(0, size)});
    };
    const auto [x0, x1] = ordered(width);
    const auto [y0, y1] = ordered(height);
    return {x0, y0, x1, y1};
}

}  // namespace rasterloom::topology
