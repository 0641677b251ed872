// SPDX-License-Identifier: MIT
// The options by which commands take a mesh, and how it stands before the viewer.
#pragma once

#include "machine/host/mesh.hpp"

#include <string>

#include <CLI/CLI.hpp>

namespace rasterloom::cli {

struct MeshOptions {
    std::string mesh;
    std::string object;
    std::string up = "y";
    std::string front = "z";
    double turn = 0;  // degrees
    double tilt = 0;  // degrees
};

// --mesh FILE and --object NAME, for a group of which the user gives one.
void add_mesh_sources(CLI::App& group, MeshOptions& options);
// --up, --front, --turn, --tilt.
void add_mesh_stance(CLI::App& command, MeshOptions& options);

// In the unit sphere, turned and tilted. Throws what load_mesh, make_scene_object and orient throw.
host::Mesh make_mesh(const MeshOptions& options);

}  // namespace rasterloom::cli
