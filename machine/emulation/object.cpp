// SPDX-License-Identifier: MIT
#include "machine/emulation/object.hpp"

#include "machine/emulation/scene_kind.hpp"
#include "machine/host/mesh_file.hpp"
#include "machine/host/png.hpp"
#include "machine/host/polygon_scenes.hpp"
#include "machine/host/scenes.hpp"

#include <algorithm>
#include <exception>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace rasterloom::emulation {

namespace {

host::Mesh read_mesh(const config::SceneDescription& scene, host::Polygons polygons) {
    host::Mesh mesh = host::load_mesh(*scene.mesh, polygons);
    host::orient(mesh, {host::parse_axis(scene.up), host::parse_axis(scene.front)});
    host::fit_to_sphere(mesh, scene.size);
    return mesh;
}

std::vector<std::string> names_of_objects() {
    std::vector<std::string> names;
    for (const host::SceneObject& object : host::scene_objects()) {
        names.emplace_back(object.name);
    }
    return names;
}

[[noreturn]] void refuse_name(const config::MachineDescription& machine) {
    std::vector<std::string> names = names_of_objects();
    for (const host::PolygonScene& scene : host::polygon_scenes()) {
        names.emplace_back(scene.name);
    }
    names.emplace_back(kRandomTriangles);
    const std::string& name = machine.scene->object;
    throw machine.error("scene.object", name, "no such object or scene",
                        fmt::format("one of {}, or a file", fmt::join(names, ", ")),
                        config::nearest_name(name, names));
}

}  // namespace

host::Mesh make_object(const config::MachineDescription& machine, host::Polygons polygons) {
    const config::SceneDescription& scene = *machine.scene;
    const std::vector<std::string> names = names_of_objects();
    if (!scene.mesh && std::find(names.begin(), names.end(), scene.object) == names.end()) {
        refuse_name(machine);
    }
    try {
        return scene.mesh ? read_mesh(scene, polygons) : host::make_scene_object(scene.object);
    } catch (const std::exception& problem) {
        throw machine.error("scene.object", {}, problem.what());
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

double degrees_at(const config::MachineDescription& machine, std::int64_t frame) {
    const config::RotationDescription& rotate = machine.scene->rotate;
    return rotate.start + static_cast<double>(frame) * rotate.degrees;
}

host::NormalStyle normal_style(const config::MachineDescription& machine) {
    return machine.scene->normals == config::Normals::face ? host::NormalStyle::face
                                                           : host::NormalStyle::smooth;
}

std::optional<host::Texture> make_texture(const config::MachineDescription& machine) {
    const config::TextureDescription& texture = machine.scene->texture;
    if (texture.name == "none") {
        return std::nullopt;
    }
    try {
        return texture.file ? host::make_texture(host::read_png(*texture.file))
                            : host::make_texture(texture.name);
    } catch (const std::exception& problem) {
        throw machine.error("scene.texture", texture.name, problem.what());
    }
}

}  // namespace rasterloom::emulation
