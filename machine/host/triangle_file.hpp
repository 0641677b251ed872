// SPDX-License-Identifier: MIT
// Screen triangles as text, one a line in the order they are drawn in (*.triangles):
//
//     # x y z grey of each vertex, and u v of each if the triangle has a texture
//     10.5 20 1200 96    35 80.25 3000 200    60 20 1200 96.5
//     10.5 20 1200 96    35 80.25 3000 200    60 20 1200 96.5    0 0  0.25 0.5  1 0
//
// x from the screen's left edge, y from its top: pixels to the nearest 1/16, -32767 to 32767, whole
// numbers are pixels' centres; z 0 (nearest) to 32766, to the nearest whole number; grey level 0 to
// 255, to the nearest 1/128; u and v, shares of a texture's width from its left and of its height
// from its top, 0 to 1, to the nearest 1/65536 below 1; without them all are 0. Blank lines and
// comments ('#') count for nothing. The order of a triangle's vertices says which side is seen
// (screen_triangle.hpp): counter-clockwise shows the front. Triangles that show their back, have no
// area or lie off the screen may be in the file and are not drawn.
#pragma once

#include "machine/host/screen_triangle.hpp"

#include <filesystem>
#include <istream>
#include <span>
#include <string>
#include <vector>

namespace rasterloom::host {

inline constexpr std::size_t kMostTriangles = std::size_t{1} << 24;

// 1 to kMostTriangles triangles. Throw topology::TextFileError, with file, line and column, for a
// malformed file; `name` stands for the file in messages.
std::vector<ScreenTriangle> read_triangles(std::istream& in, const std::string& name);
std::vector<ScreenTriangle> load_triangles(const std::filesystem::path& path);

// Reads back as it was. Throws std::runtime_error, naming the file, when it cannot be written;
// nothing half-written stays.
void save_triangles(const std::filesystem::path& path, std::span<const ScreenTriangle> triangles);
std::string triangles_as_text(std::span<const ScreenTriangle> triangles);

}  // namespace rasterloom::host
