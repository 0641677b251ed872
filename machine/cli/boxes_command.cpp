// SPDX-License-Identifier: MIT
// rasterloom boxes: the bounding boxes of a scene, for `rasterloom communicate` and the ring.
#include "machine/cli/command.hpp"
#include "machine/cli/config_options.hpp"
#include "machine/cli/mesh_options.hpp"
#include "machine/config/error.hpp"
#include "machine/emulation/princeton_scene.hpp"
#include "machine/emulation/programs.hpp"
#include "machine/host/box_scenes.hpp"
#include "machine/host/polygon_projection.hpp"
#include "machine/host/polygon_stage.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace rasterloom::cli {

namespace {

struct BoxesOptions {
    ConfigOptions machine;
    MeshOptions mesh;
    host::Camera camera{.field_of_view = 40};
    host::RandomBoxes random{.count = 0};
    std::string out;
};

std::vector<host::BoundingBox> make_boxes(const BoxesOptions& options, const Session& session) {
    if (!options.machine.file.empty()) {
        const config::MachineDescription machine = load(options.machine, session);
        isa::IsaRegistry registry = emulation::built_in_isas();
        return emulation::princeton_boxes({machine, registry});
    }
    if (options.random.count != 0) {
        return host::random_boxes(options.random);
    }
    const auto lens = host::make_lens(options.camera, options.random.width, options.random.height);
    return host::boxes_through_lens(host::stage_polygons(make_mesh(options.mesh)), lens);
}

void print_summary(const std::string& file, const std::vector<host::BoundingBox>& boxes) {
    std::size_t visible = 0;
    std::int64_t pixels = 0;
    std::int64_t columns = 0;
    for (const auto& [is_visible, box] : boxes) {
        if (is_visible) {
            ++visible;
            pixels += box.pixels();
            columns += box.x1 - box.x0 + 1;
        }
    }
    const auto mean = [visible](std::int64_t sum) {
        return static_cast<double>(sum) / static_cast<double>(std::max<std::size_t>(1, visible));
    };
    fmt::print("{}: {} polygons, {} visible, boxes of {:.1f} pixels in {:.2f} columns\n", file,
               boxes.size(), visible, mean(pixels), mean(columns));
}

void write_boxes(const BoxesOptions& options, const Session& session) {
    try {
        const auto boxes = make_boxes(options, session);
        host::save_bounding_boxes(options.out, boxes);
        print_summary(options.out, boxes);
    } catch (const config::ConfigError&) {
        throw;
    } catch (const std::runtime_error& problem) {  // files
        config::refuse({}, {}, {}, problem.what());
    } catch (const std::invalid_argument& problem) {
        config::refuse({}, {}, {}, problem.what());
    }
}

void add_scene_options(CLI::App& command, BoxesOptions& options) {
    CLI::App* const scene = command.add_option_group("Scene", "one of them");
    add_mesh_sources(*scene, options.mesh);
    scene
        ->add_option("--random", options.random.count,
                     "So many polygons evenly over the screen, half of them visible")
        ->check(CLI::Range(std::int64_t{1}, host::kMostBoxes))
        ->type_name("N");
    add_machine_source(command, *scene, options.machine,
                       "What a lock-step machine draws in its first frame, as it stands there");
    scene->require_option(1);
}

}  // namespace

void add_boxes_command(CLI::App& app, Session& session) {
    auto options = std::make_shared<BoxesOptions>();
    CLI::App* command = app.add_subcommand(
        "boxes", "Write the bounding boxes of a scene's polygons: what `communicate` reads");
    add_scene_options(*command, *options);
    command->add_option("--out", options->out, "The file, such as teapot.boxes")
        ->required()
        ->type_name("FILE");
    const auto add = [command](const char* name, auto& value, const char* summary) {
        return command->add_option(name, value, summary)->capture_default_str();
    };
    add_mesh_stance(*command, options->mesh);
    add("--field-of-view", options->camera.field_of_view,
        "Degrees between the screen's sides; the viewer is 4 radii from the object's middle");
    add("--seed", options->random.seed, "Of random polygons");
    add("--longest-side", options->random.longest_side, "Of random polygons' boxes, pixels");
    add("--width", options->random.width, "Of the screen, pixels");
    add("--height", options->random.height, "Of the screen, pixels");
    command->callback([options, &session] { write_boxes(*options, session); });
}

}  // namespace rasterloom::cli
