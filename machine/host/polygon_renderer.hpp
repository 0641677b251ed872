// SPDX-License-Identifier: MIT
// The reference renderer of Parks' machines: draws screen polygons by the tiler's sampling rule, in
// closed form, a pixel at a time, without any machine.
//
// The rule. The left side of a polygon runs counter-clockwise from the leftmost of its topmost
// vertices, the right side clockwise from the rightmost of them. On line y, from the top down to
// the lowest vertex, a side stands
//     at its first vertex on that line, if it has one there (exactly that vertex' x, z, s);
//     else on its edge from a, the last vertex above the line, to b, the next one (below it).
// With n = a.y - b.y and k = a.y - y, in lines, each of x, z and s there is
//     full:    (v_a * 2^16 + 2^15 + 2 * k * q) >> 16,  q = (v_b - v_a) * 2^15 / n
//     thesis:  v_a + k * q,                            q = (v_b - v_a) / n
// where / cuts towards zero and >> rounds down. So with xl, zl, sl and xr, zr, sr: the pixels from
// xl to max(xl, xr) are covered; with n = xr - xl and k = x - xl the depth and shade of pixel x
// follow from (zl, zr) and (sl, sr) by the same formulas (n = 0: zl and sl). A covered pixel is
// drawn when its depth is less than what stands there; at first that is kClearedDepth. The grey
// level is shade / kShadeUnit, rounded down.
//
// Parts (machine/fabric/polygon_part.hpp) are drawn on their rows only, as the whole polygon is
// there.
#pragma once

#include "machine/fabric/polygon.hpp"
#include "machine/host/picture.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rasterloom::host {

enum class Precision : std::uint8_t { full, thesis };

struct PolygonRenderOptions {
    int width = 512;
    int height = 512;
    int background = 0;  // grey level
    Precision precision = Precision::full;
};

struct DepthPicture {
    Picture picture;                   // row 0 is the top line, y = height - 1
    std::vector<std::int16_t> depth;   // likewise
    std::vector<std::uint32_t> drawn;  // [pixel]: polygons that cover it (depth complexity)
};

// Polygons as machine/fabric/polygon.hpp demands; what lies beside the picture is left out.
DepthPicture render_polygons(std::span<const Polygon> polygons,
                             const PolygonRenderOptions& options);

}  // namespace rasterloom::host
