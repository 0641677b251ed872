// SPDX-License-Identifier: MIT
// Meshes from files in any format that assimp reads (OBJ, PLY, STL, OFF, glTF, ...).
#pragma once

#include "machine/host/mesh.hpp"

#include <filesystem>

namespace rasterloom::host {

enum class Polygons { triangulated, as_in_file };

// Vertices in the file's own coordinates. `as_in_file` keeps convex polygons with more than three
// corners whole. Throws std::runtime_error that names the file and what is wrong with it: missing,
// not a mesh, no polygons, coordinates that are not finite, indices out of range.
Mesh load_mesh(const std::filesystem::path& path, Polygons polygons = Polygons::triangulated);

}  // namespace rasterloom::host
