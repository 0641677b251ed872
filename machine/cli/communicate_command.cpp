// SPDX-License-Identifier: MIT
// rasterloom communicate: what a ring of lock-step processors spends on a scene's bounding boxes,
// by the model of machine/host/ring_model.hpp.
#include "machine/cli/command.hpp"
#include "machine/config/error.hpp"
#include "machine/host/ring_model.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rasterloom::cli {

namespace {

using nlohmann::ordered_json;

struct CommunicateOptions {
    std::string boxes;
    std::string map;
    int width = 768;
    int height = 512;
    host::RingSetup setup;
    std::uint32_t group = 0;  // 0: all processors
    bool is_sparse = false;
    bool as_json = false;
};

double mean_of(const std::vector<std::uint64_t>& counts) {
    double sum = 0;
    for (const std::uint64_t count : counts) {
        sum += static_cast<double>(count);
    }
    return sum / static_cast<double>(counts.size());
}

double per_visible(std::uint64_t count, const host::RingRun& run) {
    return static_cast<double>(count) /
           static_cast<double>(std::max<std::uint64_t>(1, run.visible));
}

ordered_json stages_as_json(const host::RingRun& run) {
    ordered_json stages = ordered_json::array();
    for (const host::RingStage& stage : run.stages) {
        stages.push_back({{"stride", stage.stride},
                          {"passes", stage.passes},
                          {"shifts", stage.shifts},
                          {"instructions", stage.instructions},
                          {"sent", stage.sent},
                          {"carried", stage.carried},
                          {"received", stage.received}});
    }
    return stages;
}

void print_json(const CommunicateOptions& options, const host::RingRun& run) {
    const auto& count = run.instructions;
    const ordered_json json{{"processors", options.setup.processors},
                            {"group", options.group},
                            {"duplicate", options.setup.duplication},
                            {"period", options.setup.period},
                            {"polygons", run.polygons},
                            {"visible", run.visible},
                            {"deliveries", run.deliveries},
                            {"stages", stages_as_json(run)},
                            {"instructions",
                             {{"rejecting", count.rejecting},
                              {"lighting", count.lighting},
                              {"communicating", count.communicating},
                              {"rasterising", count.rasterising},
                              {"compositing", count.compositing},
                              {"total", count.total()}}},
                            {"sourced", run.sourced},
                            {"pixels", run.pixels}};
    fmt::print("{}\n", json.dump(1));
}

void print_loads(const char* what, const std::vector<std::uint64_t>& loads) {
    fmt::print("{:<28}{:>14} on the fullest, {:.2f} on the mean\n", what, std::ranges::max(loads),
               mean_of(loads));
}

void print_table(const CommunicateOptions& options, const host::RingRun& run) {
    fmt::print("{}: {} polygons, {} visible, {} deliveries on {} processors in groups of {}\n",
               options.boxes, run.polygons, run.visible, run.deliveries, options.setup.processors,
               options.group);
    print_loads("visible polygons sourced", run.sourced);
    print_loads("polygons received", run.stages.back().received);
    print_loads("pixels of boxes", run.pixels);
    for (const host::RingStage& stage : run.stages) {
        const double slots =
            static_cast<double>(stage.passes) * static_cast<double>(options.setup.processors);
        fmt::print("{:<28}{:>14} passes, {:.3f} shifts a visible polygon, {:.1f} % full\n",
                   fmt::format("stride {}", stage.stride), stage.passes,
                   per_visible(stage.shifts, run),
                   100 * static_cast<double>(stage.carried) / std::max(1.0, slots));
    }
    const auto print_count = [&run](const char* what, std::uint64_t count) {
        fmt::print("{:<28}{:>14} instructions, {:.1f} a visible polygon\n", what, count,
                   per_visible(count, run));
    };
    print_count("keep or reject", run.instructions.rejecting);
    print_count("light, set up", run.instructions.lighting);
    print_count("communicate", run.instructions.communicating);
    print_count("rasterise", run.instructions.rasterising);
    print_count("composite", run.instructions.compositing);
    print_count("all", run.instructions.total());
}

host::RingRun simulate(const CommunicateOptions& options) {
    try {
        const auto boxes = host::load_bounding_boxes(options.boxes);
        const auto map = options.map.empty()
                             ? topology::column_map(options.width, options.height, options.group)
                             : topology::region_map_file(options.map, options.width, options.height,
                                                         options.group);
        return host::run_ring_model(boxes, map, options.setup);
    } catch (const std::runtime_error& problem) {  // files
        config::refuse({}, {}, {}, problem.what());
    } catch (const std::invalid_argument& problem) {
        config::refuse({}, {}, {}, problem.what());
    }
}

void communicate(CommunicateOptions& options) {
    if (options.group == 0) {
        options.group = options.setup.processors;
    }
    if (options.is_sparse) {
        options.setup.period = options.setup.processors;
    }
    const host::RingRun run = simulate(options);
    if (options.as_json) {
        print_json(options, run);
    } else {
        print_table(options, run);
    }
}

}  // namespace

void add_communicate_command(CLI::App& app, Session&) {
    auto options = std::make_shared<CommunicateOptions>();
    CLI::App* command = app.add_subcommand(
        "communicate",
        "Count what a ring of lock-step processors spends to bring polygons where they are drawn "
        "(Eldridge 1995, appendix A)");
    command->add_option("boxes", options->boxes, "Bounding boxes (rasterloom boxes)")
        ->required()
        ->type_name("FILE");
    command->add_option("--map", options->map, "Who draws what; default: columns, left to right")
        ->type_name("FILE");
    const auto add = [command](const char* name, auto& value, const char* summary) {
        return command->add_option(name, value, summary)->capture_default_str();
    };
    add("--processors", options->setup.processors, "On the ring")->check(CLI::Range(1U, 65536U));
    add("--strides", options->setup.strides, "Places a pass, stage by stage, such as 16,1")
        ->delimiter(',');
    add("--duplicate", options->setup.duplication, "Deal each polygon to so many processors");
    command
        ->add_option("--group", options->group,
                     "Sort-twice: so many processors draw one screen; default: all")
        ->check(CLI::PositiveNumber);
    CLI::Option* const period = add("--period", options->setup.period,
                                    "Passes between tests whether a polygon is where it has to be");
    command->add_flag("--sparse", options->is_sparse, "Never test: each polygon goes all the way")
        ->excludes(period);
    add("--pixel-cost", options->setup.costs.pixel, "Instructions to rasterise a pixel");
    add("--width", options->width, "Of the screen, pixels");
    add("--height", options->height, "Of the screen, pixels");
    command->add_flag("--json", options->as_json, "All counts, by processor, as JSON");
    command->callback([options] { communicate(*options); });
}

}  // namespace rasterloom::cli
