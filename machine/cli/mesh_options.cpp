// SPDX-License-Identifier: MIT
#include "machine/cli/mesh_options.hpp"

#include "machine/host/mesh_file.hpp"
#include "machine/host/scenes.hpp"

namespace rasterloom::cli {

namespace {

host::Mesh upright_mesh(const MeshOptions& options) {
    if (options.mesh.empty()) {
        return host::make_scene_object(options.object);
    }
    host::Mesh mesh = host::load_mesh(options.mesh, host::Polygons::as_in_file);
    host::orient(mesh, {host::parse_axis(options.up), host::parse_axis(options.front)});
    return mesh;
}

}  // namespace

void add_mesh_sources(CLI::App& group, MeshOptions& options) {
    group.add_option("--mesh", options.mesh, "A file of polygons")->type_name("FILE");
    group.add_option("--object", options.object, "A built-in object (rasterloom list scenes)")
        ->type_name("NAME");
}

void add_mesh_stance(CLI::App& command, MeshOptions& options) {
    const auto add = [&command](const char* name, auto& value, const char* summary) {
        command.add_option(name, value, summary)->capture_default_str();
    };
    add("--up", options.up, "The axis of a mesh that points up");
    add("--front", options.front, "The axis of a mesh that points at the viewer");
    add("--turn", options.turn, "Turn the object about its upright axis, degrees");
    add("--tilt", options.tilt, "Lean it towards the viewer, degrees");
}

host::Mesh make_mesh(const MeshOptions& options) {
    host::Mesh mesh = upright_mesh(options);
    host::turn(mesh, options.turn);
    host::tilt(mesh, options.tilt);
    host::fit_to_sphere(mesh);
    return mesh;
}

}  // namespace rasterloom::cli
