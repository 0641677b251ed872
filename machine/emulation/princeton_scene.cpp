// SPDX-License-Identifier: MIT
#include "machine/emulation/princeton_scene.hpp"

#include "machine/emulation/object.hpp"
#include "machine/host/png.hpp"
#include "machine/host/teapot.hpp"

#include <exception>
#include <utility>

namespace rasterloom::emulation {

namespace {

using config::MachineDescription;

host::Mesh make_mesh(const MachineDescription& machine) {
    if (machine.scene->object == "teapot" && !machine.scene->mesh &&
        machine.written.contains("scene.polygons")) {
        return host::make_teapot(
            host::teapot_tessellation(static_cast<std::size_t>(machine.scene->polygons)));
    }
    return make_object(machine);
}

std::vector<host::Texture> make_textures(const MachineDescription& machine) {
    const config::TextureDescription& texture = machine.scene->texture;
    if (texture.name == "none") {
        return {};
    }
    try {
        return {texture.file ? host::make_texture(host::read_png(*texture.file))
                             : host::make_texture(texture.name)};
    } catch (const std::exception& problem) {
        throw machine.error("scene.texture", texture.name, problem.what());
    }
}

}  // namespace

host::TriangleScene make_princeton_scene(const MachineDescription& machine) {
    host::TriangleMaterial material;
    material.textures = make_textures(machine);
    material.normals = machine.scene->normals == config::Normals::face ? host::NormalStyle::face
                                                                       : host::NormalStyle::smooth;
    host::Mesh mesh = make_mesh(machine);
    try {
        return host::make_triangle_scene(std::move(mesh), material);
    } catch (const std::exception& problem) {
        throw machine.error("scene.object", {}, problem.what());
    }
}

}  // namespace rasterloom::emulation
