// SPDX-License-Identifier: MIT
// What lay between the host and the processors of a machine that deals out the screen; the units of
// rasterizers in hardware; and the sequencer of a lock-step machine.
#pragma once

#include "machine/kernel/time.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::observe {

struct FifoReport {
    int peak = 0;     // messages
    double mean = 0;  // over the run
    Duration full;
};

enum class FabricPart : std::uint8_t {
    host,
    splitter,
    bus,
    frame_buffer_bus,
    turn_bus,
    sequencer,
    tile_sorter,
    tile_feeder,
    triangle_unit,
    pixel_unit,
};

std::string_view name_of(FabricPart part);  // "host", "splitter", "bus", ...

// One part; what does not apply to its kind stays 0.
struct FabricPartReport {
    std::string name;  // "splitter/3"
    FabricPart part = FabricPart::host;
    // Sent, split, broadcast; pixels of a frame-buffer bus or a pixel unit; of the other parts of a
    // bucket tiler triangles, once for each tile but at the sorter.
    std::int64_t polygons = 0;
    std::int64_t vertices = 0;
    std::int64_t words = 0;  // of a bus; of a sequencer: by all lanes, a place further
    std::int64_t cut = 0;    // polygons that went both ways
    std::int64_t low_polygons = 0;
    std::int64_t high_polygons = 0;
    Duration busy;
    // Had something to hand on, and somebody had no room for it. Of a frame-buffer bus: pixels
    // waited for their turn, summed over the processors. Of a sequencer: waited for the next
    // scanline. Of a triangle unit: the FIFO to the pixel unit was full.
    Duration blocked;
    std::string waited_for;  // the one that had no room for the longest time; empty: nobody
    Duration waited_for_it;
    FifoReport input;
    FifoReport low;
    FifoReport high;
};

// One row a part, in the order of the report. `whole`: the run's time.
std::string fabric_csv(const std::vector<FabricPartReport>& fabric, Duration whole);

// "" for a machine without any; else some lines, with a newline after each.
std::string fabric_summary(const std::vector<FabricPartReport>& fabric, Duration whole);

}  // namespace rasterloom::observe
