// SPDX-License-Identifier: MIT
#include "machine/emulation/polygon_frames.hpp"

#include "machine/emulation/object.hpp"
#include "machine/emulation/scene_kind.hpp"
#include "machine/host/mesh_file.hpp"
#include "machine/host/polygon_file.hpp"
#include "machine/host/polygon_scenes.hpp"
#include "machine/host/polygon_shape.hpp"
#include "machine/host/polygon_stage.hpp"

#include <exception>
#include <stdexcept>

namespace rasterloom::emulation {

namespace {

using config::MachineDescription;

std::optional<host::Mesh> read_model(const MachineDescription& machine) {
    const config::SceneDescription& scene = *machine.scene;
    if (!scene.model) {
        return std::nullopt;
    }
    try {
        host::Mesh mesh = host::load_mesh(scene.model->path, host::Polygons::as_in_file);
        host::check(mesh);
        host::orient(mesh, {host::parse_axis(scene.up), host::parse_axis(scene.front)});
        return mesh;
    } catch (const std::exception& problem) {
        throw machine.error("scene.model", {}, problem.what());
    }
}

void add(host::PolygonSetupStatistics& sum, const host::PolygonSetupStatistics& part) {
    sum.given += part.given;
    sum.additional += part.additional;
    sum.back_faces += part.back_faces;
    sum.outside += part.outside;
    sum.sent += part.sent;
    sum.clipped += part.clipped;
    sum.repaired += part.repaired;
    sum.lines += part.lines;
    sum.points += part.points;
}

void make_scene_frames(const MachineDescription& machine, PolygonFrames& result) {
    const config::SceneDescription& wanted = *machine.scene;
    const host::PolygonScene& scene = *host::find_polygon_scene(wanted.object);
    const std::optional<host::Mesh> model = read_model(machine);
    host::PolygonSceneOptions options;
    options.width = static_cast<int>(machine.screen.width);
    options.height = static_cast<int>(machine.screen.height);
    options.frames = machine.run.frames;
    options.model = model ? &*model : nullptr;
    options.seed = static_cast<std::uint64_t>(wanted.seed);
    options.count = wanted.polygons;
    host::PolygonSetupStatistics all;
    for (options.frame = 0; options.frame < options.frames; ++options.frame) {
        host::PolygonSetupStatistics statistics;
        options.setup = &statistics;
        result.frames.push_back(scene.make(options));
        add(all, statistics);
    }
    if (all.given > 0) {
        result.setup = all;
    }
    result.background = static_cast<int>(wanted.background.value_or(scene.background));
}

void make_object_frames(const MachineDescription& machine, PolygonFrames& result) {
    const host::Mesh object = make_object(machine, host::Polygons::as_in_file);
    host::View view = make_view(machine);
    host::PolygonShading shading;
    shading.normals = normal_style(machine);
    result.setup.emplace();
    for (std::int64_t frame = 0; frame < machine.run.frames; ++frame) {
        view.degrees = degrees_at(machine, frame);
        host::PolygonSetupStatistics statistics;
        result.frames.push_back(host::screen_polygons(object, view, shading, &statistics));
        add(*result.setup, statistics);
    }
    result.background = view.background;
}

void make_file_frames(const MachineDescription& machine, PolygonFrames& result) {
    const std::vector<Polygon> polygons =
        host::load_polygons(*machine.scene->mesh, static_cast<int>(machine.screen.width),
                            static_cast<int>(machine.screen.height));
    result.frames.assign(static_cast<std::size_t>(machine.run.frames), polygons);
    result.background = static_cast<int>(machine.scene->background.value_or(0));
}

void make_frames(const MachineDescription& machine, PolygonFrames& result) {
    switch (scene_kind(machine)) {
        case SceneKind::polygon_scene:
            return make_scene_frames(machine, result);
        case SceneKind::polygon_file:
            return make_file_frames(machine, result);
        case SceneKind::object:
            return make_object_frames(machine, result);
        case SceneKind::boxes:
            throw machine.error("scene.object", machine.scene->object,
                                "bounding boxes are sent by lock-step machines only",
                                "an object, a mesh or polygons");
        case SceneKind::triangle_file:
        case SceneKind::random_triangles:
            refuse_screen_triangles(machine);
    }
}

}  // namespace

PolygonFrames make_polygon_frames(const MachineDescription& machine) {
    PolygonFrames result;
    try {
        make_frames(machine, result);
        for (std::vector<Polygon>& polygons : result.frames) {
            host::check_polygons(polygons, static_cast<int>(machine.screen.width),
                                 static_cast<int>(machine.screen.height));
            host::arrange(polygons, machine.host.order,
                          static_cast<std::uint64_t>(machine.host.seed));
        }
    } catch (const config::ConfigError&) {
        throw;
    } catch (const std::exception& problem) {
        throw machine.error("scene.object", {}, problem.what());
    }
    return result;
}

}  // namespace rasterloom::emulation
