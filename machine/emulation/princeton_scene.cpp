// SPDX-License-Identifier: MIT
#include "machine/emulation/princeton_scene.hpp"

#include "machine/emulation/object.hpp"
#include "machine/emulation/scene_kind.hpp"
#include "machine/host/png.hpp"
#include "machine/host/projection.hpp"
#include "machine/host/teapot.hpp"
#include "machine/host/triangle_renderer.hpp"

#include <exception>
#include <optional>
#include <stdexcept>
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

}  // namespace

host::TriangleScene make_princeton_scene(const MachineDescription& machine) {
    host::TriangleMaterial material;
    if (std::optional<host::Texture> texture = make_texture(machine)) {
        material.textures.push_back(std::move(*texture));
    }
    material.normals = normal_style(machine);
    host::Mesh mesh = make_mesh(machine);
    try {
        return host::make_triangle_scene(std::move(mesh), material);
    } catch (const std::exception& problem) {
        throw machine.error("scene.object", {}, problem.what());
    }
}

host::TriangleView make_princeton_view(const MachineDescription& machine, int distance,
                                       std::int64_t frame) {
    host::View turn = make_view(machine);
    turn.degrees = degrees_at(machine, frame);
    host::TriangleView view;
    view.matrix = host::eye_matrix(host::rotation_of(turn), {0, 0, distance});
    return view;
}

std::vector<host::BoundingBox> princeton_boxes(const Blueprint& blueprint) {
    const MachineDescription& machine = blueprint.description;
    if (!blueprint.is_lockstep()) {
        throw machine.error("nodes.isa", machine.nodes.isa, "is no machine of lanes", "vliw");
    }
    if (!machine.scene) {
        throw machine.error("scene", {}, "missing", "an object, a mesh or bounding boxes");
    }
    if (scene_kind(machine) == SceneKind::boxes) {
        try {
            return host::load_bounding_boxes(*machine.scene->mesh);
        } catch (const std::runtime_error& problem) {
            throw machine.error("scene.object", {}, problem.what());
        }
    }
    if (scene_kind(machine) != SceneKind::object) {
        throw machine.error("scene", {}, "has no object or mesh");
    }
    const host::TriangleScene scene = make_princeton_scene(machine);
    const int distance = host::fitting_distance(scene, machine.scene->rotate.axis);
    const host::TriangleRendering drawn = host::render_triangles(
        scene, make_princeton_view(machine, distance, 0), host::make_lights(machine.scene->light));
    std::vector<host::BoundingBox> boxes;
    boxes.reserve(drawn.boxes.size());
    for (const auto& box : drawn.boxes) {
        boxes.push_back(
            box ? host::BoundingBox{true, {box->left, box->top, box->right, box->bottom}}
                : host::BoundingBox{});
    }
    return boxes;
}

}  // namespace rasterloom::emulation
