// SPDX-License-Identifier: MIT
#include "machine/emulation/triangle_frames.hpp"

#include "machine/emulation/object.hpp"
#include "machine/emulation/scene_kind.hpp"
#include "machine/host/polygon_order.hpp"
#include "machine/host/polygon_projection.hpp"
#include "machine/host/polygon_stage.hpp"
#include "machine/host/texture_places.hpp"
#include "machine/host/triangle_file.hpp"
#include "machine/host/triangle_scenes.hpp"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::emulation {

namespace {

using config::MachineDescription;
using Triangles = std::vector<host::ScreenTriangle>;
using Frames = std::vector<Triangles>;

Frames standing_still(const MachineDescription& machine, const Triangles& triangles) {
    return Frames(static_cast<std::size_t>(machine.run.frames), triangles);
}

host::Lens make_lens(const MachineDescription& machine, const host::View& view) {
    const config::CameraDescription& camera = machine.scene->camera;
    if (!camera.eye) {  // as on the geodesic machine's square screen
        host::Lens lens = host::make_lens(view);
        lens.scale_x = lens.scale_y = std::min(lens.scale_x, lens.scale_y);
        return lens;
    }
    try {
        return host::make_lens(
            host::Camera{
                .eye = *camera.eye, .target = camera.target, .field_of_view = camera.field_of_view},
            view.width, view.height);
    } catch (const std::invalid_argument& problem) {
        throw machine.error("scene.camera.eye", {}, problem.what());
    }
}

Frames object_frames(const MachineDescription& machine) {
    host::Mesh object = make_object(machine, host::Polygons::as_in_file);
    host::add_texture_coordinates(object);
    host::View view = make_view(machine);
    if (machine.scene->camera.eye) {  // it is the camera that comes and goes
        view.scale = 1;
        view.translate = {0, 0, 0};
    }
    const host::Lens lens = make_lens(machine, view);
    Frames frames;
    for (std::int64_t frame = 0; frame < machine.run.frames; ++frame) {
        view.degrees = degrees_at(machine, frame);
        frames.push_back(host::triangles_through_lens(
            host::stage_in_view(object, view, {.normals = normal_style(machine)}), lens));
    }
    return frames;
}

double mean_area(const MachineDescription& machine) {
    const config::RandomTrianglesDescription& wanted = machine.scene->triangles;
    if (wanted.depth_complexity == 0) {
        return wanted.mean_area;
    }
    if (machine.written.contains("scene.triangles.mean_area")) {
        throw machine.error("scene.triangles.depth_complexity",
                            fmt::format("{}", wanted.depth_complexity), "stands beside mean_area",
                            "one of them");
    }
    return wanted.depth_complexity * static_cast<double>(machine.screen.width) *
           static_cast<double>(machine.screen.height) / static_cast<double>(wanted.count);
}

Frames random_frames(const MachineDescription& machine) {
    const config::SceneDescription& scene = *machine.scene;
    const config::RandomTrianglesDescription& wanted = scene.triangles;
    const double area = mean_area(machine);
    try {
        return standing_still(
            machine, host::random_triangles({.count = wanted.count,
                                             .seed = static_cast<std::uint64_t>(scene.seed),
                                             .width = static_cast<int>(machine.screen.width),
                                             .height = static_cast<int>(machine.screen.height),
                                             .mean_area = area,
                                             .skew = static_cast<int>(wanted.skew),
                                             .box_ratio = wanted.box_ratio,
                                             .aspect = wanted.aspect}));
    } catch (const std::invalid_argument& problem) {
        throw machine.error(wanted.depth_complexity > 0 ? "scene.triangles.depth_complexity"
                                                        : "scene.triangles.mean_area",
                            {}, problem.what());
    }
}

Frames make_frames(const MachineDescription& machine) {
    constexpr const char* kExpected = "an object, a mesh, a .triangles file or random-triangles";
    switch (scene_kind(machine)) {
        case SceneKind::object:
            return object_frames(machine);
        case SceneKind::triangle_file:
            return standing_still(machine, host::load_triangles(*machine.scene->mesh));
        case SceneKind::random_triangles:
            return random_frames(machine);
        case SceneKind::polygon_scene:
        case SceneKind::polygon_file:
            break;
        case SceneKind::boxes:
            throw machine.error("scene.object", machine.scene->object,
                                "bounding boxes are sent by lock-step machines only", kExpected);
    }
    throw machine.error("scene.object", machine.scene->object,
                        "bucket tiles draw triangles, not screen polygons", kExpected);
}

}  // namespace

TriangleFrames make_triangle_frames(const MachineDescription& machine) {
    TriangleFrames result;
    try {
        result.frames = make_frames(machine);
    } catch (const config::ConfigError&) {
        throw;
    } catch (const std::exception& problem) {
        throw machine.error("scene.object", {}, problem.what());
    }
    for (Triangles& triangles : result.frames) {
        host::arrange(triangles, machine.host.order, static_cast<std::uint64_t>(machine.host.seed));
    }
    result.background = static_cast<int>(machine.scene->background.value_or(0));
    result.texture = make_texture(machine);
    return result;
}

}  // namespace rasterloom::emulation
