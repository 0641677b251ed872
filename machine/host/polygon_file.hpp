// SPDX-License-Identifier: MIT
// Screen polygons as text, one frame a file (*.polygons):
//
//     # a comment, to the end of the line
//     polygon
//         0   0  1200  96        x y z grey: x from the left edge, y from the bottom, whole pixels;
//       511   0  1200  96.5      z 0 (nearest) to 32766; grey level 0 to 255, to the nearest 1/128
//       256 400  3000  200
//     polygon
//       ...
//
// Vertices run counter-clockwise with y upwards. Blank lines and spaces at either end count for
// nothing. What a reader makes of a polygon that the machines could not draw:
//     a vertex where its predecessor stands      left out
//     all vertices in one line, back and forth   the line between its ends
//     not convex                                 divided into triangles
//     more than kMaxPolygonVertices              divided along diagonals, up to 500
// and an error otherwise: coordinates off the screen, depths, grey levels out of range, clockwise,
// an outline that crosses itself, no vertex.
#pragma once

#include "machine/fabric/polygon.hpp"

#include <filesystem>
#include <istream>
#include <span>
#include <string>
#include <vector>

namespace rasterloom::host {

// At least one polygon, all as check_polygons demands. Throws std::runtime_error with file, line,
// what stands there and what was expected.
std::vector<Polygon> load_polygons(const std::filesystem::path& path, int width, int height);

// Likewise; `name` stands for the file in messages.
std::vector<Polygon> read_polygons(std::istream& stream, const std::string& name, int width,
                                   int height);

// Reads back as it was. Throws std::runtime_error, naming the file, when it cannot be written;
// nothing half-written stays.
void save_polygons(const std::filesystem::path& path, std::span<const Polygon> polygons);
std::string polygons_as_text(std::span<const Polygon> polygons);

}  // namespace rasterloom::host
