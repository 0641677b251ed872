// SPDX-License-Identifier: MIT
#include "machine/emulation/object.hpp"

#include "machine/host/mesh_file.hpp"
#include "machine/host/polygon_scenes.hpp"
#include "machine/host/scenes.hpp"

#include <exception>
#include <string>
#include <vector>

namespace rasterloom::emulation {

namespace {

host::Mesh read_mesh(const config::SceneDescription& scene) {
    host::Mesh mesh = host::load_mesh(*scene.mesh);
    host::orient(mesh, {host::parse_axis(scene.up), host::parse_axis(scene.front)});
    host::fit_to_sphere(mesh, scene.size);
    return mesh;
}

std::string nearest_object(const std::string& name) {
    std::vector<std::string> names;
    for (const host::SceneObject& object : host::scene_objects()) {
        names.emplace_back(object.name);
    }
    for (const host::PolygonScene& scene : host::polygon_scenes()) {
        names.emplace_back(scene.name);
    }
    return config::nearest_name(name, names);
}

}  // namespace

host::Mesh make_object(const config::MachineDescription& machine) {
    const config::SceneDescription& scene = *machine.scene;
    try {
        return scene.mesh ? read_mesh(scene) : host::make_scene_object(scene.object);
    } catch (const std::exception& problem) {
        throw machine.error("scene.object", {}, problem.what(), {},
                            scene.mesh ? "" : nearest_object(scene.object));
    }
}

host::View make_view(const config::MachineDescription& machine) {
    const config::SceneDescription& scene = *machine.scene;
    host::View view;
    view.width = static_cast<int>(machine.screen.width);
    view.height = static_cast<int>(machine.screen.height);
    view.scale = scene.scale;
    view.translate = scene.translate;
    view.vanishing_distance = scene.vanishing_distance;
    view.light = scene.light;
    view.ambient = scene.ambient;
    view.background = static_cast<int>(scene.background.value_or(0));
    view.axis = scene.rotate.axis;
    return view;
}

}  // namespace rasterloom::emulation
