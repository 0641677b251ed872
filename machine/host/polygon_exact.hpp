// SPDX-License-Identifier: MIT
// The sampling rule of polygon_renderer.hpp in real numbers: what the tilers' fixed point comes
// near to.
//
// The sides of a polygon stand at the real x, z and s of their edges; a line's pixels run from the
// nearest to the left side's x (halves up) to the nearest to the right one's; depth and shade go
// evenly from the left side's to the right side's over them and are rounded (halves up) at the end.
#pragma once

#include "machine/fabric/polygon.hpp"
#include "machine/host/polygon_renderer.hpp"

#include <span>
#include <vector>

namespace rasterloom::host {

struct ExactSegment {
    struct End {
        double x = 0, z = 0, shade = 0;  // each correctly rounded to double
    };
    int y = 0;
    End left, right;
};

// From the top line down to the lowest.
std::vector<ExactSegment> exact_segments(const Polygon& polygon);

// options.precision counts for nothing.
DepthPicture render_exact(std::span<const Polygon> polygons, const PolygonRenderOptions& options);

}  // namespace rasterloom::host
