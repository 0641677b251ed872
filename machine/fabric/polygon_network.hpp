// SPDX-License-Identifier: MIT
// What lies between the host and the processors of Parks' machines: the source, the tree of
// splitters, the buses and the frame-buffer bus, built and wired from a topology::Distribution.
//
// Order of work for a machine:
//   1. make processor i as set_polygon_ports() says, and the supervisor for one node more
//      than there are processors;
//   2. connect_polygon_network();
//   3. join every processor i to the supervisor as node i, and the source (its port kSupervisor) as
//      the last node;
//   4. seal, load the source's frames, run.
#pragma once

#include "machine/fabric/frame_buffer_bus.hpp"
#include "machine/fabric/polygon_bus.hpp"
#include "machine/fabric/polygon_source.hpp"
#include "machine/fabric/polygon_splitter.hpp"
#include "machine/fabric/turn_bus.hpp"
#include "machine/kernel/simulation.hpp"
#include "machine/node/processor.hpp"
#include "topologies/tiling.hpp"

#include <optional>
#include <span>
#include <vector>

namespace rasterloom {

struct PolygonFabricSettings {
    // The thesis' assumption: every time below is 0 (a wire has one tick), no FIFO is ever full,
    // and there is no frame-buffer bus: the image window stands in memory.
    bool ideal = false;
    // What the processors' program expects of splitters: that they leave edges whole.
    bool whole_edges = false;

    Duration host_time_per_polygon = Duration::microseconds(10);
    Duration host_time_per_vertex;
    Duration splitter_time_per_vertex = Duration::nanoseconds(600);
    int splitter_input_fifo = 4;   // messages
    int splitter_output_fifo = 4;  // messages, each
    Duration bus_time_per_word = Duration::nanoseconds(300);
    int bus_input_fifo = 4;  // messages
    int processor_fifo = 4;  // messages that wait at a processor
    // An image word's time on the frame-buffer bus; none: no such bus, words go straight into
    // memory.
    std::optional<Duration> frame_buffer_bus_time_per_pixel;
    Duration latency = Duration::microseconds(1);  // of every wire; at least 1 tick
    // Processors that share a part also share the set-up of its polygons:
    // machine/fabric/turn_bus.hpp. Every part has to be shared then. processor_fifo holds for
    // either port.
    bool half_digested = false;
    int digest_output_queue = 2;  // messages that wait at a processor for the turn bus
    int phases_per_frame = 1;
    bool supervised = true;
};

// Deep enough for the frames of an ideal machine.
inline constexpr int kIdealFifo = 1 << 20;

struct PolygonNetwork {  // owned by the simulation
    PolygonSource* source = nullptr;
    std::vector<PolygonSplitter*> splitters;  // in the order of the distribution's elements
    std::vector<PolygonBus*> buses;           // likewise
    std::vector<TurnBus*> turn_buses;         // [bus], where polygons are half-digested
    FrameBufferBus* frame_buffer_bus = nullptr;

    // Calls `visit(part)` for all of them, each as what it is.
    template <class Visit>
    void for_each_part(Visit&& visit) const {
        visit(*source);
        const auto each = [&](const auto& parts) {
            for (auto* part : parts) {
                visit(*part);
            }
        };
        each(splitters);
        each(buses);
        each(turn_buses);
        if (frame_buffer_bus != nullptr) {
            visit(*frame_buffer_bus);
        }
    }
};

// Sets what the fabric wants of the processor that draws `grid`: its ports and its frame buffer.
void set_polygon_ports(Processor::Settings& processor, const PolygonFabricSettings& fabric,
                       const topology::PixelGrid& grid);

// Adds the source ("host"), an element by its name in the distribution for every splitter and bus,
// for half-digested polygons "turn_bus/3" beside "bus/3", and "frame_buffer_bus"; lays all wires
// but those to the supervisor. processors[i] is the distribution's processor i, its settings as
// set_polygon_ports() makes them. Throws WiringError when the processors do not fit,
// std::invalid_argument when a setting is out of range.
PolygonNetwork connect_polygon_network(Simulation& simulation,
                                       const topology::Distribution& distribution,
                                       std::span<Processor* const> processors,
                                       const PolygonFabricSettings& settings);

}  // namespace rasterloom
