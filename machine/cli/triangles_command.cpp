// SPDX-License-Identifier: MIT
// rasterloom triangles: the screen triangles of a scene, for `rasterloom overlap` and the machines
// that draw by tiles.
#include "machine/cli/command.hpp"
#include "machine/cli/config_options.hpp"
#include "machine/cli/mesh_options.hpp"
#include "machine/config/error.hpp"
#include "machine/emulation/triangle_frames.hpp"
#include "machine/host/polygon_projection.hpp"
#include "machine/host/polygon_stage.hpp"
#include "machine/host/texture_places.hpp"
#include "machine/host/triangle_file.hpp"
#include "machine/host/triangle_scenes.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/vec3.hpp>

namespace rasterloom::cli {

namespace {

constexpr int kLastFrame = 9999;

using Place = std::array<double, 3>;

struct TrianglesOptions {
    ConfigOptions machine;
    std::int64_t frame = 0;
    MeshOptions mesh;
    Place eye{-4, 0, 0};
    Place target{0, 0, 0};
    double field_of_view = 40;
    host::RandomTriangles random{.count = 0};
    double depth_complexity = 0;  // 0: the mean area is given
    std::string out;
};

struct Scene {
    std::vector<host::ScreenTriangle> triangles;
    std::int64_t width;  // of the screen, pixels
    std::int64_t height;
};

Scene machines_scene(const TrianglesOptions& options, const Session& session) {
    config::MachineDescription machine = load(options.machine, session);
    if (!machine.scene) {
        throw machine.error("scene", {}, "missing", "an object, a mesh or screen triangles");
    }
    machine.run.frames = options.frame + 1;
    return {emulation::make_triangle_frames(machine).frames.back(), machine.screen.width,
            machine.screen.height};
}

std::vector<host::ScreenTriangle> random_triangles(const TrianglesOptions& options) {
    host::RandomTriangles random = options.random;
    if (options.depth_complexity != 0) {
        random.mean_area = options.depth_complexity * random.width * random.height /
                           static_cast<double>(random.count);
    }
    return host::random_triangles(random);
}

std::vector<host::ScreenTriangle> mesh_triangles(const TrianglesOptions& options) {
    const auto place = [](const Place& p) { return glm::dvec3{p[0], p[1], p[2]}; };
    const host::Camera camera{.eye = place(options.eye),
                              .target = place(options.target),
                              .field_of_view = options.field_of_view};
    const auto lens = host::make_lens(camera, options.random.width, options.random.height);
    host::Mesh mesh = make_mesh(options.mesh);
    host::add_texture_coordinates(mesh);
    auto triangles = host::triangles_through_lens(host::stage_polygons(std::move(mesh)), lens);
    if (triangles.empty()) {
        throw std::invalid_argument(
            "nothing of the mesh is visible, expected a view of its front; --eye, --target, "
            "--turn and --tilt say from where");
    }
    return triangles;
}

Scene make_scene(const TrianglesOptions& options, const Session& session) {
    if (!options.machine.file.empty()) {
        return machines_scene(options, session);
    }
    return {options.random.count != 0 ? random_triangles(options) : mesh_triangles(options),
            options.random.width, options.random.height};
}

void write_triangles(const TrianglesOptions& options, const Session& session) {
    try {
        const Scene scene = make_scene(options, session);
        host::save_triangles(options.out, scene.triangles);
        fmt::print("{}: {} triangles on {} x {} pixels\n", options.out, scene.triangles.size(),
                   scene.width, scene.height);
    } catch (const config::ConfigError&) {
        throw;
    } catch (const std::runtime_error& problem) {  // files
        config::refuse({}, {}, {}, problem.what());
    } catch (const std::invalid_argument& problem) {
        config::refuse({}, {}, {}, problem.what());
    }
}

void add_scene_options(CLI::App& command, TrianglesOptions& options) {
    CLI::App* const scene = command.add_option_group("Scene", "one of them");
    add_mesh_sources(*scene, options.mesh);
    scene->add_option("--random", options.random.count, "So many triangles evenly over the screen")
        ->check(CLI::Range(std::int64_t{1}, static_cast<std::int64_t>(host::kMostTriangles)))
        ->type_name("N");
    CLI::Option* const machine = add_machine_source(
        command, *scene, options.machine, "The scene of a machine's configuration, on its screen");
    scene->require_option(1);
    command.add_option("--frame", options.frame, "Of the machine's frames, from 0")
        ->check(CLI::Range(0, kLastFrame))
        ->needs(machine)
        ->capture_default_str();
}

void add_view_options(CLI::App& command, TrianglesOptions& options) {
    const auto add_place = [&command](const char* name, Place& place, const char* summary) {
        command.add_option(name, place, summary)
            ->delimiter(',')
            ->type_name("X,Y,Z")
            ->capture_default_str();
    };
    add_mesh_stance(command, options.mesh);
    add_place("--eye", options.eye,
              "The viewer; the mesh is in the unit sphere, z up, its front towards -x");
    add_place("--target", options.target, "What the viewer looks at");
    command
        .add_option("--field-of-view", options.field_of_view, "Degrees between the screen's sides")
        ->capture_default_str();
}

void add_random_options(CLI::App& command, TrianglesOptions& options) {
    const auto add = [&command](const char* name, auto& value, const char* summary) {
        return command.add_option(name, value, summary)->capture_default_str();
    };
    host::RandomTriangles& random = options.random;
    add("--seed", random.seed, "Of random triangles");
    CLI::Option* const area = add("--mean-area", random.mean_area, "Of random triangles, pixels");
    command
        .add_option("--depth-complexity", options.depth_complexity,
                    "Instead: the sum of their areas over the screen's")
        ->check(CLI::PositiveNumber)
        ->excludes(area);
    add("--skew", random.skew,
        "How uneven their areas are: mean (skew + 1) u^skew for u from 0 to 1; 0: all alike");
    add("--box-ratio", random.box_ratio, "The area of their bounding boxes over their own");
    add("--aspect", random.aspect, "The longer side of their bounding boxes over the shorter");
}

}  // namespace

void add_triangles_command(CLI::App& app, Session& session) {
    auto options = std::make_shared<TrianglesOptions>();
    CLI::App* command = app.add_subcommand(
        "triangles", "Write a scene's triangles as they are on the screen: what `overlap` reads");
    add_scene_options(*command, *options);
    command->add_option("--out", options->out, "The file, such as teapot.triangles")
        ->required()
        ->type_name("FILE");
    add_view_options(*command, *options);
    add_random_options(*command, *options);
    command->add_option("--width", options->random.width, "Of the screen, pixels")
        ->capture_default_str();
    command->add_option("--height", options->random.height, "Of the screen, pixels")
        ->capture_default_str();
    command->callback([options, &session] { write_triangles(*options, session); });
}

}  // namespace rasterloom::cli
