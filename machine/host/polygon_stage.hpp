// SPDX-License-Identifier: MIT
// Meshes lit and put on the stage, for the machines that draw polygons.
#pragma once

#include "machine/host/mesh.hpp"
#include "machine/host/polygon_setup.hpp"
#include "machine/host/surface.hpp"
#include "machine/host/view.hpp"

#include <vector>

#include <glm/vec3.hpp>

namespace rasterloom::host {

// Grey = brightness * (ambient + (1 - ambient) * max(0, n . light)), as in view.hpp.
struct PolygonLighting {
    glm::dvec3 light{-0.7, 0.3, 0.65};  // direction towards it, any length but zero
    double ambient = 0.15;              // 0 to 1
    double brightness = 255;            // 0 to 255: the level of a surface that faces the light
    NormalStyle normals = NormalStyle::smooth;  // `face`: one level a polygon
    double crease_cosine = 0.766044443118978;   // of 40 degrees: sharper edges stay sharp
};

// The mesh's polygons in its own order and coordinates, non-convex ones as triangles. Where a
// neighbour is wound the other way the majority of the connected piece decides (surface.hpp).
// Degenerate polygons are left out. Throws std::invalid_argument for what mesh.hpp's check()
// refuses, and for a light that makes no sense.
std::vector<StagePolygon> stage_polygons(Mesh mesh, const PolygonLighting& lighting = {});

struct PolygonShading {
    NormalStyle normals = NormalStyle::smooth;
    double crease_cosine = 0.766044443118978;
};

// Likewise of a mesh turned, lit and placed as the view says: what make_lens(view) sees. Throws
// std::invalid_argument for a view that makes no sense, too.
std::vector<StagePolygon> stage_in_view(Mesh mesh, const View& view,
                                        const PolygonShading& shading = {});

// The same object, rotation, place and light as on the geodesic machine (view.hpp): pixels lie
// where they lie there, depths are those of polygon_setup.hpp. What comes nearer to the viewer than
// 1/64 of the vanishing distance is cut off.
std::vector<Polygon> screen_polygons(const Mesh& mesh, const View& view,
                                     const PolygonShading& shading = {},
                                     PolygonSetupStatistics* statistics = nullptr);

}  // namespace rasterloom::host
