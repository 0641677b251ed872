// SPDX-License-Identifier: MIT
#include "machine/cli/describe_buckets.hpp"

#include "machine/config/field.hpp"
#include "machine/config/units.hpp"
#include "machine/fabric/tile_assignment.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace rasterloom::cli {

namespace {

constexpr std::size_t kShown = 8;  // tiles

// As the configuration writes it.
std::string value_of(const config::MachineDescription& machine, std::string_view key) {
    for (const config::Field& field : config::machine_fields()) {
        if (field.path == key) {
            return field.write(machine);
        }
    }
    return {};
}

void print_hardware(const config::MachineDescription& machine) {
    fmt::print("Units       {} cycles a triangle, {} a pixel at {} a cycle; FIFO: {}\n",
               machine.rasterizer.cycles_per_triangle, machine.rasterizer.cycles_per_pixel,
               config::format_clock(machine.nodes.clock), value_of(machine, "rasterizer.fifo"));
}

void print_software(const config::MachineDescription& machine) {
    fmt::print("Processor   {}, {} a cycle, {} bytes, {}\n", machine.nodes.isa,
               config::format_clock(machine.nodes.clock), machine.nodes.memory,
               machine.nodes.program.text);
    fmt::print("Feeder      {} a word, FIFO of {} at the processor\n",
               config::format_duration(machine.sorter.time_per_word),
               machine.rasterizer.input_fifo);
}

}  // namespace

std::vector<std::size_t> tile_owners(const config::MachineDescription& machine,
                                     const topology::BucketTiles& tiles, std::size_t rasterizers) {
    if (!is_static(machine.sorter.assignment)) {
        return {};
    }
    return owners_of_tiles(machine.sorter.assignment, tiles.columns(), tiles.rows(),
                           static_cast<int>(rasterizers));
}

void print_buckets(const config::MachineDescription& machine, const topology::BucketTiles& tiles,
                   std::size_t rasterizers) {
    fmt::print("Screen      {} x {} in {} tiles of {} pixels, {} x {} of them\n",
               tiles.screen_width(), tiles.screen_height(), tiles.tiles(),
               name_of(tiles.tile_size()), tiles.columns(), tiles.rows());
    fmt::print("Sorter      by {}, {} a triangle and {} a pair; tiles {}\n",
               value_of(machine, "sorter.rule"),
               config::format_duration(machine.sorter.time_per_triangle),
               config::format_duration(machine.sorter.time_per_pair),
               value_of(machine, "sorter.assignment"));
    fmt::print("Nodes       {} rasterizer{} in {}\n", rasterizers, rasterizers == 1 ? "" : "s",
               value_of(machine, "rasterizer.kind"));
    if (machine.has_program()) {
        print_software(machine);
    } else {
        print_hardware(machine);
    }
}

void print_tiles_of(const topology::BucketTiles& tiles, const std::vector<std::size_t>& owners,
                    std::size_t node, const std::string& name) {
    if (owners.empty()) {
        fmt::print("{} is node {}: it takes tiles when it is free\n", name, node);
        return;
    }
    const auto count = std::count(owners.begin(), owners.end(), node);
    fmt::print("{} is node {}: {} of {} tiles\n", name, node, count, tiles.tiles());
    std::size_t shown = 0;
    for (topology::TileIndex tile = 0; tile < tiles.tiles() && shown < kShown; ++tile) {
        if (owners[tile] == node) {
            const auto box = tiles.box_of(tile);
            fmt::print("  tile {}: x {} to {}, y {} to {}\n", tile, box.x0, box.x1, box.y0, box.y1);
            ++shown;
        }
    }
    if (static_cast<std::size_t>(count) > shown) {
        fmt::print("  and {} more\n", static_cast<std::size_t>(count) - shown);
    }
}

}  // namespace rasterloom::cli
