// SPDX-License-Identifier: MIT
#include "machine/cli/describe_tiling.hpp"

#include "machine/observe/output_folder.hpp"
#include "topologies/tiling_export.hpp"

#include <algorithm>
#include <sstream>
#include <variant>
#include <vector>

#include <fmt/format.h>

namespace rasterloom::cli {

namespace {

using topology::CutAxis;
using topology::Distribution;
using topology::PixelGrid;

const char* plural(int count, const char* one, const char* several) {
    return count == 1 ? one : several;
}

// The elements from the host to the processor, by number.
bool find_way(const Distribution& distribution, std::size_t element, topology::NodeIndex node,
              std::vector<std::size_t>& way) {
    way.push_back(element);
    const auto& what = distribution.elements[element].what;
    if (const auto* cut = std::get_if<Distribution::Cut>(&what)) {
        if (find_way(distribution, cut->low, node, way) ||
            find_way(distribution, cut->high, node, way)) {
            return true;
        }
    } else if (const auto* bus = std::get_if<Distribution::Broadcast>(&what)) {
        if (std::find(bus->processors.begin(), bus->processors.end(), node) !=
            bus->processors.end()) {
            return true;
        }
    } else if (std::get<Distribution::Leaf>(what).processor == node) {
        return true;
    }
    way.pop_back();
    return false;
}

std::string steps(int start, int step, int count) {
    return step == 1
               ? fmt::format("{} to {}", start, start + count - 1)
               : fmt::format("{}, {}, ... {}", start, start + step, start + (count - 1) * step);
}

void print_step(const Distribution& distribution, const std::vector<std::size_t>& way,
                std::size_t step) {
    const auto& element = distribution.elements[way[step]];
    if (const auto* cut = std::get_if<Distribution::Cut>(&element.what)) {
        fmt::print("  {} cuts at {} = {}: {} side\n", element.name,
                   cut->axis == CutAxis::x ? 'x' : 'y', cut->line,
                   way[step + 1] == cut->low ? "low" : "high");
    } else if (const auto* bus = std::get_if<Distribution::Broadcast>(&element.what)) {
        fmt::print("  {}, {} listeners\n", element.name, bus->processors.size());
    }
}

}  // namespace

void print_tiling(const topology::Tiling& tiling, const Distribution& distribution) {
    const PixelGrid& grid = distribution.grids.front();
    fmt::print("Processors  {}, each {} x {} pixels of {} x {}", tiling.processors(), grid.columns,
               grid.rows, distribution.width, distribution.height);
    if (tiling.interlaced() > 1) {
        fmt::print(", {} x {} apart", grid.x_step, grid.y_step);
    }
    fmt::print("\nParts       {}: {} x {} of {} x {} pixels, {} {} each\n", tiling.parts(),
               tiling.columns, tiling.rows, grid.columns * grid.x_step, grid.rows * grid.y_step,
               tiling.interlaced(), plural(tiling.interlaced(), "processor", "processors"));
    const int splitters = tiling.parts() - 1;
    const int depth = topology::tree_depth(distribution);
    fmt::print("Splitters   {}{}\n", splitters == 0 ? "none" : std::to_string(splitters),
               splitters == 0
                   ? ""
                   : fmt::format(" in a tree of {} {}", depth, plural(depth, "level", "levels")));
    const int buses = tiling.interlaced() > 1 ? tiling.parts() : 0;
    fmt::print(
        "Buses       {}\n",
        buses == 0 ? "none" : fmt::format("{}, {} listeners each", buses, tiling.interlaced()));
}

void print_fabric(const config::MachineDescription& machine) {
    const config::FabricDescription& fabric = machine.fabric;
    const auto time = config::format_duration;
    if (fabric.ideal) {
        fmt::print("Fabric      ideal: takes no time, never full\n");
        return;
    }
    fmt::print("Splitter    {} a vertex, FIFOs of {} in, {} out\n",
               time(fabric.splitter.time_per_vertex), fabric.splitter.input_fifo,
               fabric.splitter.output_fifo);
    fmt::print("Bus         {} a word, FIFOs of {} at the processors, wires of {}\n",
               time(fabric.bus.time_per_word), fabric.processor_fifo, time(fabric.latency));
    if (fabric.frame_buffer == config::FrameBufferKind::bus) {
        fmt::print("Pixels      over one frame-buffer bus, {} each\n",
                   time(fabric.frame_buffer_time_per_pixel));
    }
    fmt::print("Host        {} a polygon and {} a vertex\n", time(machine.host.time_per_polygon),
               time(machine.host.time_per_vertex));
}

void print_share(const Distribution& distribution, std::size_t node, const std::string& name) {
    const PixelGrid& grid = distribution.grids[node];
    fmt::print("{} is node {}: {} x {} pixels, x {}, y {}\n", name, node, grid.columns, grid.rows,
               steps(grid.x_start, grid.x_step, grid.columns),
               steps(grid.y_start, grid.y_step, grid.rows));
    std::vector<std::size_t> way;
    find_way(distribution, 0, static_cast<topology::NodeIndex>(node), way);
    for (std::size_t step = 0; step < way.size(); ++step) {
        print_step(distribution, way, step);
    }
}

void write_tiling_tables(const Distribution& distribution, const std::string& folder) {
    std::ostringstream nodes;
    topology::write_grids_csv(nodes, distribution);
    std::ostringstream elements;
    topology::write_elements_csv(elements, distribution);
    observe::OutputFolder output(folder);
    observe::write_file_whole(output.file("nodes.csv"), nodes.str());
    observe::write_file_whole(output.file("elements.csv"), elements.str());
    output.commit();
}

}  // namespace rasterloom::cli
