// SPDX-License-Identifier: MIT
#include "machine/emulation/bucket_settings.hpp"

#include "machine/emulation/bucket_loader.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>

#include <fmt/format.h>

namespace rasterloom::emulation {

namespace {

// What makes a tile large (machine/fabric/tile_assignment.hpp).
void set_weights(TileQueueSettings& queues, const config::MachineDescription& machine) {
    const auto weigh = [&queues](std::int64_t pair, std::int64_t pixel) {
        queues.pair_weight = static_cast<std::uint32_t>(pair);
        queues.pixel_weight = static_cast<std::uint32_t>(pixel);
    };
    switch (machine.sorter.largest_by) {
        case config::TileMeasure::triangles:
            return weigh(1, 0);
        case config::TileMeasure::pixels:
            return weigh(0, 1);
        case config::TileMeasure::work:
            return weigh(machine.rasterizer.cycles_per_triangle,
                         machine.rasterizer.cycles_per_pixel);
    }
}

}  // namespace

TileSorterSettings sorter_settings(const Blueprint& blueprint) {
    const config::MachineDescription& machine = blueprint.description;
    const topology::BucketTiles& tiles = *blueprint.tiles;
    TileSorterSettings settings;
    settings.time_per_triangle = machine.sorter.time_per_triangle;
    settings.time_per_pair = machine.sorter.time_per_pair;
    settings.queues.assignment = machine.sorter.assignment;
    settings.queues.columns = tiles.columns();
    settings.queues.rows = tiles.rows();
    settings.queues.rasterizers = static_cast<int>(blueprint.topology.nodes.size());
    set_weights(settings.queues, machine);
    return settings;
}

RasterizerSettings rasterizer_settings(const config::MachineDescription& machine) {
    RasterizerSettings settings;
    settings.clock = machine.nodes.clock.clock();
    settings.cycles_per_triangle = machine.rasterizer.cycles_per_triangle;
    settings.cycles_per_pixel = machine.rasterizer.cycles_per_pixel;
    settings.fifo.reset();
    if (machine.rasterizer.fifo) {
        settings.fifo = static_cast<std::size_t>(*machine.rasterizer.fifo);
    }
    return settings;
}

TileFeederSettings feeder_settings(const config::MachineDescription& machine, NodeIndex node) {
    TileFeederSettings settings;
    settings.node = node;
    settings.receiver_places = static_cast<int>(machine.rasterizer.input_fifo);
    settings.time_per_word = machine.sorter.time_per_word;
    return settings;
}

void set_tile_ports(Processor::Settings& settings, const Blueprint& blueprint) {
    const config::MachineDescription& machine = blueprint.description;
    const topology::TileSize tile = blueprint.tiles->tile_size();
    if (tile.width > kMaxFrameBufferColumns) {
        throw machine.error("topology.tile", machine.topology.parameters.at("tile"),
                            "is wider than a processor's frame buffer",
                            fmt::format("at most {} pixels wide", kMaxFrameBufferColumns));
    }
    settings.supervised = true;
    settings.max_message = static_cast<int>(kTriangleMessageBytes);
    settings.ports.ports = 1;
    settings.ports.transmitting = 0;
    settings.ports.receiving = 1;
    settings.ports.input_queue = static_cast<int>(machine.rasterizer.input_fifo);
    settings.frame_buffer = FrameBuffer::Settings{tile.height, tile.width, false};
}

std::shared_ptr<const TileScene> tile_scene(
    const topology::BucketTiles& tiles,
    const std::vector<std::vector<host::ScreenTriangle>>& triangles) {
    auto scene = std::make_shared<TileScene>();
    scene->tiles = tiles;
    scene->frames.clear();
    for (const std::vector<host::ScreenTriangle>& of_frame : triangles) {
        std::transform(of_frame.begin(), of_frame.end(),
                       std::back_inserter(scene->frames.emplace_back()), corners_of);
    }
    return scene;
}

std::vector<TileFrame> sort_frames(const std::vector<std::vector<host::ScreenTriangle>>& triangles,
                                   const topology::BucketTiles& tiles, host::OverlapRule rule) {
    std::vector<TileFrame> frames;
    for (const std::vector<host::ScreenTriangle>& of_frame : triangles) {
        TileFrame& frame = frames.emplace_back();
        frame.triangles = static_cast<std::uint32_t>(of_frame.size());
        for (std::uint32_t i = 0; i < frame.triangles; ++i) {
            for (const host::TilePixels& tile : overlapped_tiles(of_frame[i], tiles, rule)) {
                frame.pairs.push_back({tile.tile, i, tile.pixels});
            }
        }
    }
    return frames;
}

}  // namespace rasterloom::emulation
