// SPDX-License-Identifier: MIT
#include "machine/emulation/fabric_settings.hpp"

namespace rasterloom::emulation {

PolygonFabricSettings fabric_settings(const config::MachineDescription& machine,
                                      const isa::Image& program, std::int64_t phases_per_frame) {
    const config::FabricDescription& fabric = machine.fabric;
    PolygonFabricSettings settings;
    settings.ideal = fabric.ideal;
    settings.host_time_per_polygon = machine.host.time_per_polygon;
    settings.host_time_per_vertex = machine.host.time_per_vertex;
    settings.splitter_time_per_vertex = fabric.splitter.time_per_vertex;
    settings.splitter_input_fifo = static_cast<int>(fabric.splitter.input_fifo);
    settings.splitter_output_fifo = static_cast<int>(fabric.splitter.output_fifo);
    settings.bus_time_per_word = fabric.bus.time_per_word;
    settings.bus_input_fifo = static_cast<int>(fabric.bus.input_fifo);
    settings.processor_fifo = static_cast<int>(fabric.processor_fifo);
    if (fabric.frame_buffer == config::FrameBufferKind::bus) {
        settings.frame_buffer_bus_time_per_pixel = fabric.frame_buffer_time_per_pixel;
    }
    settings.latency = fabric.latency;
    settings.half_digested = fabric.half_digested;
    settings.digest_output_queue = static_cast<int>(fabric.digest_fifo);
    settings.whole_edges = program.symbol("takes_parts").value_or(0) != 0;
    settings.phases_per_frame = static_cast<int>(phases_per_frame);
    return settings;
}

}  // namespace rasterloom::emulation
