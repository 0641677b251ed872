// SPDX-License-Identifier: MIT
// The statistics of Parks 1982, appendix C, for one processor and a frame or several, and what its
// program's sections cost; taken from the run itself.
//
// The thesis' formula: Gt a polygon, Vt a vertex, St a segment, Pt a pixel (2.7). Its appendix
// charges every polygon one segment at least: with heights [0]=85 and 357 segments, figure 15's
// interlace processor 3 is charged for 442 (C.6).
#pragma once

#include "machine/node/message.hpp"
#include "machine/observe/appendix_c/distribution.hpp"
#include "machine/observe/appendix_c/pixel_fit.hpp"

#include <array>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace rasterloom::observe {

// Parts of the program, from tap to tap. `digest` is the share of a processor that works polygons
// out for others, too (the thesis' "further research"); `other` is what belongs to no polygon: the
// program's beginning, the end of a frame.
enum class Section : std::uint8_t { polygon, vertex, segment, pixel, digest, other };
inline constexpr int kSections = 6;

struct AppendixC {
    Distribution vertices;  // v: vertices a polygon
    Distribution heights;   // y: assigned lines a polygon, 0 included
    Distribution lengths;   // l: assigned pixels a segment, 0 included
    Distribution depth;     // D: polygons that cover an assigned pixel
    Distribution areas;     // assigned pixels a polygon

    std::int64_t digested = 0;                     // polygons worked out for all, drawn here or not
    std::int64_t edges = 0;                        // set up by the program, on either side
    std::int64_t drawn = 0;                        // pixels that passed the depth test
    std::array<std::int64_t, kSections> cycles{};  // executed; stalls are none
    PixelFit pixel_fit;

    std::int64_t polygons() const { return vertices.points(); }
    std::int64_t vertex_count() const { return vertices.sum(); }
    std::int64_t segments() const { return heights.sum(); }
    std::int64_t pixels() const { return areas.sum(); }
    // As the thesis charges them.
    std::int64_t charged_segments() const { return segments() + heights.count(0); }
    std::int64_t in(Section section) const { return cycles[static_cast<std::size_t>(section)]; }
    // Of the sections that the formula speaks of, and of digesting.
    std::int64_t scene_cycles() const { return all_cycles() - in(Section::other); }
    std::int64_t all_cycles() const {
        return std::accumulate(cycles.begin(), cycles.end(), std::int64_t{0});
    }

    void add(const AppendixC& other);
};

// Cycles a polygon, vertex, segment and pixel.
struct ItemCosts {
    double polygon = 0;
    double vertex = 0;
    double segment = 0;
    double pixel = 0;
};
inline constexpr ItemCosts kThesisCosts{139, 319.3, 158, 21};

// The thesis' formula with its own costs, as it charges them.
double formula_cycles(const AppendixC& statistics);
// Polygons, vertices, segments and pixels times their costs, no segment charged that is none.
double predicted_cycles(const AppendixC& statistics, const ItemCosts& costs);
// Against the emulated cycles: 0.02 is 2 % too many. 0 when nothing was executed.
double error_of(double cycles, const AppendixC& statistics);
// The program's own: each section's cycles over its items; 0 for none.
ItemCosts own_costs(const AppendixC& statistics);

struct AppendixCNode {
    NodeIndex node = 0;
    std::string name;
    std::vector<AppendixC> frames;

    AppendixC all() const;
};

struct AppendixCReport {
    std::string machine;
    std::vector<AppendixCNode> nodes;
    std::int64_t frames = 0;

    AppendixC all() const;
};

}  // namespace rasterloom::observe
