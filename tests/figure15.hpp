// SPDX-License-Identifier: MIT
// Parks 1982, appendix C.1: how many polygons of figure 15's scene have so many vertices, and so
// many lines.
#pragma once

#include <cstdint>
#include <map>

namespace rasterloom {

inline std::map<std::int64_t, std::int64_t> figure15_vertices() {
    return {{1, 2}, {2, 54}, {3, 153}, {4, 34}, {5, 4}, {6, 1}};
}

inline std::map<std::int64_t, std::int64_t> figure15_heights() {
    return {{1, 31}, {2, 95}, {3, 68}, {4, 23}, {5, 7},   {6, 11},
            {11, 2}, {14, 4}, {15, 4}, {73, 1}, {280, 1}, {302, 1}};
}

}  // namespace rasterloom
