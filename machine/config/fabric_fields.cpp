// SPDX-License-Identifier: MIT
// The keys of what lies between the host and the processors of a machine that deals out the screen.
#include "machine/config/fabric_fields.hpp"

#include "machine/config/field_builders.hpp"

#include <limits>

namespace rasterloom::config {

namespace {

template <typename Get>
Field fifo_field(std::string path, std::string summary, Get get) {
    return count_field(std::move(path), std::move(summary), 1, 65535, get);
}

void add_splitter_fields(std::vector<Field>& fields) {
    fields.push_back(duration_field(
        "fabric.splitter.time_per_vertex", "a splitter's work on each vertex of a polygon",
        [](auto& m) -> auto& { return m.fabric.splitter.time_per_vertex; }));
    fields.push_back(fifo_field(
        "fabric.splitter.input_fifo", "polygons that wait to be split",
        [](auto& m) -> auto& { return m.fabric.splitter.input_fifo; }));
    fields.push_back(fifo_field(
        "fabric.splitter.output_fifo", "polygons that wait at either output of a splitter",
        [](auto& m) -> auto& { return m.fabric.splitter.output_fifo; }));
}

void add_host_fields(std::vector<Field>& fields) {
    fields.push_back(duration_field(
        "host.time_per_polygon", "from a polygon to the next; 0ns: as fast as there is room",
        [](auto& m) -> auto& { return m.host.time_per_polygon; }));
    fields.push_back(duration_field(
        "host.time_per_vertex", "the same, for each vertex of the polygon",
        [](auto& m) -> auto& { return m.host.time_per_vertex; }));
    fields.push_back(choice_field<host::PolygonOrder>(
        "host.order",
        "the order of a frame's polygons: as the scene has them, nearest first (by their nearest "
        "vertex), or at random",
        {{"mesh", host::PolygonOrder::mesh},
         {"sorted", host::PolygonOrder::sorted},
         {"shuffled", host::PolygonOrder::shuffled}},
        [](auto& m) -> auto& { return m.host.order; }));
    fields.push_back(count_field(
        "host.seed", "of the random order", 0, std::numeric_limits<std::int64_t>::max(),
        [](auto& m) -> auto& { return m.host.seed; }));
}

}  // namespace

void add_fabric_fields(std::vector<Field>& fields) {
    fields.push_back(yes_no_field(
        "fabric.ideal",
        "whether splitters, buses, wires and the host take no time and FIFOs never fill, whatever "
        "the other keys of fabric and host say",
        [](auto& m) -> auto& { return m.fabric.ideal; }));
    add_splitter_fields(fields);
    fields.push_back(duration_field(
        "fabric.polygon_bus.time_per_word", "transfer time of a word to all who share a part",
        [](auto& m) -> auto& { return m.fabric.bus.time_per_word; }));
    fields.push_back(fifo_field(
        "fabric.polygon_bus.input_fifo", "polygons that wait for the bus",
        [](auto& m) -> auto& { return m.fabric.bus.input_fifo; }));
    fields.push_back(fifo_field(
        "fabric.processor_fifo", "polygons that wait at a processor",
        [](auto& m) -> auto& { return m.fabric.processor_fifo; }));
    fields.push_back(choice_field<FrameBufferKind>(
        "fabric.frame_buffer", "whether processors have pixels of their own or write over one bus",
        {{"local", FrameBufferKind::local}, {"bus", FrameBufferKind::bus}},
        [](auto& m) -> auto& { return m.fabric.frame_buffer; }));
    fields.push_back(duration_field(
        "fabric.frame_buffer_bus.time_per_pixel", "transfer time of a pixel",
        [](auto& m) -> auto& { return m.fabric.frame_buffer_time_per_pixel; }));
    fields.push_back(duration_field(
        "fabric.latency", "of every wire of the fabric; at least 2ps",
        [](auto& m) -> auto& { return m.fabric.latency; }));
    fields.push_back(yes_no_field(
        "fabric.half_digested",
        "whether each processor sets up its share of the polygons and broadcasts them to all "
        "(interlace and hybrid)",
        [](auto& m) -> auto& { return m.fabric.half_digested; }));
    fields.push_back(fifo_field(
        "fabric.digest_fifo",
        "polygons that a processor has set up and that wait for their turn on the bus, the one in "
        "transfer included",
        [](auto& m) -> auto& { return m.fabric.digest_fifo; }));
    add_host_fields(fields);
}

}  // namespace rasterloom::config
