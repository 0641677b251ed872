// SPDX-License-Identifier: MIT
#include "machine/emulation/array_settings.hpp"

#include "machine/emulation/princeton_screen.hpp"
#include "machine/emulation/programs.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <thread>

#include <fmt/format.h>

namespace rasterloom::emulation {

namespace {

using config::MachineDescription;

// With fewer, meeting after each bundle costs more than a second core gains.
constexpr std::int64_t kLanesPerThread = 1024;

void check_multiple(const Blueprint& blueprint, const std::string& symbol) {
    const MachineDescription& machine = blueprint.description;
    const auto of = blueprint.image->symbol(symbol);
    const auto lanes = static_cast<std::int64_t>(blueprint.topology.nodes.size());
    if (of && !blueprint.image->labels.contains(symbol) && (*of == 0 || lanes % *of != 0)) {
        const std::string key = "nodes.symbols." + symbol;
        throw machine.error(
            machine.written.contains(key) ? key : "topology.nodes", std::to_string(*of),
            fmt::format("{} lanes are no multiple of the {} {}", lanes, symbol, *of),
            fmt::format("a divisor of {}", lanes));
    }
}

// How far the renderers' words count on a ring depends on their options.
void check_ring(const Blueprint& blueprint) {
    const auto lanes = static_cast<std::int64_t>(blueprint.topology.nodes.size());
    if (const auto most = blueprint.image->symbol("most_lanes"); most && lanes > *most) {
        throw blueprint.description.error("topology.nodes", std::to_string(lanes),
                                          "too many lanes for the words of the program",
                                          fmt::format("1 to {} with these nodes.symbols", *most));
    }
}

// A lane of a renderer that has frame buffers draws a column; what comes as fragments needs lanes
// even for columns that are not seen.
void check_columns_of_lanes(const Blueprint& blueprint) {
    const MachineDescription& machine = blueprint.description;
    const isa::Image& image = *blueprint.image;
    const auto lanes = static_cast<std::int64_t>(blueprint.topology.nodes.size());
    if (has_frame_buffers(image) && image.symbol("column")) {
        if (machine.screen.width > lanes) {
            throw machine.error("screen.width", std::to_string(machine.screen.width),
                                "each lane of this program draws a column",
                                fmt::format("at most {}, the lanes", lanes));
        }
        const std::int64_t columns = image.symbol("screen_columns").value_or(0);
        if (image.symbol("fragments").value_or(0) != 0 && columns > lanes) {
            throw machine.error("topology.nodes", std::to_string(lanes),
                                "the lanes are fewer than the columns of the program's screen",
                                fmt::format("at least {}", columns));
        }
    }
}

// A program counts the scanlines: it waits for its own rows to have been seen.
void check_scanlines(const Blueprint& blueprint) {
    const MachineDescription& machine = blueprint.description;
    const isa::Image& image = *blueprint.image;
    const std::int64_t rows = image.symbol("screen_rows").value_or(machine.array.visible_lines);
    if (machine.array.line_locked && machine.array.visible_lines > rows) {
        throw machine.error("array.visible_lines", std::to_string(machine.array.visible_lines),
                            "the program's screen has fewer rows", fmt::format("at most {}", rows));
    }
    // finish.s goes on in a scanline below the picture that is followed by another.
    if (machine.array.line_locked && image.symbol("unshown") && machine.array.lines < rows + 2) {
        throw machine.error("array.lines", std::to_string(machine.array.lines),
                            "the program waits for a second scanline below its screen",
                            fmt::format("at least {}", rows + 2));
    }
    if (machine.array.line_locked && machine.screen.height > machine.array.visible_lines) {
        throw machine.error(
            "screen.height", std::to_string(machine.screen.height),
            "the video output has no scanlines for it",
            fmt::format("at most {}, array.visible_lines", machine.array.visible_lines));
    }
}

int threads_for_array(const MachineDescription& machine, std::int64_t lanes) {
    const auto cores = static_cast<std::int64_t>(std::max(1U, std::thread::hardware_concurrency()));
    // More than there are cores would only wait for each other.
    return static_cast<int>(
        std::clamp<std::int64_t>(machine.run.threads.value_or(lanes / kLanesPerThread), 1, cores));
}

}  // namespace

void check_array(const Blueprint& blueprint) {
    const MachineDescription& machine = blueprint.description;
    const topology::Topology& topology = blueprint.topology;
    if (topology.kind != "ring" && topology.kind != "single") {
        throw machine.error("topology.kind", topology.kind, "the lanes of an array are a ring",
                            "ring, or single for one lane");
    }
    if (topology.nodes.size() > static_cast<std::size_t>(kMaxLanes)) {
        throw machine.error("topology.nodes", std::to_string(topology.nodes.size()),
                            "too many lanes", fmt::format("1 to {}", kMaxLanes));
    }
    check_ring(blueprint);
    check_multiple(blueprint, "stride");
    check_multiple(blueprint, "group");
    if (machine.scene) {
        check_columns_of_lanes(blueprint);
        check_scanlines(blueprint);
    }
}

LockstepMachine::Settings lockstep_settings(const Blueprint& blueprint) {
    const MachineDescription& machine = blueprint.description;
    LockstepMachine::Settings settings;
    settings.clock = machine.nodes.clock.clock();
    settings.line_locked = machine.array.line_locked;
    settings.line = machine.array.line;
    settings.lines = machine.array.lines;
    settings.visible_lines = machine.array.visible_lines;
    settings.frames = machine.run.frames;
    settings.array.lanes = static_cast<std::int64_t>(blueprint.topology.nodes.size());
    settings.array.threads = threads_for_array(machine, settings.array.lanes);
    settings.program = std::dynamic_pointer_cast<const isa::vliw::Program>(
        prepare_program(blueprint.isa, *blueprint.image, machine));
    if (settings.program == nullptr) {
        throw machine.error("nodes.isa", machine.nodes.isa, "makes no program for an array");
    }
    settings.image = blueprint.image;
    return settings;
}

}  // namespace rasterloom::emulation
