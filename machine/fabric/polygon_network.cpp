// SPDX-License-Identifier: MIT
#include "machine/fabric/polygon_network.hpp"

#include <stdexcept>
#include <variant>

#include <fmt/format.h>

namespace rasterloom {

namespace {

using topology::Distribution;

// A processor's output queue has memory for all of its places.
constexpr int kIdealOutputQueue = 1024;

// The settings with `ideal` carried out.
PolygonFabricSettings effective(const PolygonFabricSettings& settings) {
    PolygonFabricSettings result = settings;
    if (settings.ideal) {
        result.host_time_per_polygon = result.host_time_per_vertex = Duration();
        result.splitter_time_per_vertex = result.bus_time_per_word = Duration();
        result.splitter_input_fifo = result.splitter_output_fifo = kIdealFifo;
        result.bus_input_fifo = result.processor_fifo = kIdealFifo;
        result.digest_output_queue = kIdealOutputQueue;
        result.latency = Duration::tick();
        result.frame_buffer_bus_time_per_pixel.reset();
    }
    return result;
}

void check_processors(const Distribution& distribution, std::span<Processor* const> processors,
                      const PolygonFabricSettings& settings) {
    if (distribution.elements.empty()) {
        throw WiringError("a distribution has at least one element");
    }
    if (processors.size() != distribution.grids.size()) {
        throw WiringError(fmt::format("a distribution to {} processors cannot feed {}",
                                      distribution.grids.size(), processors.size()));
    }
    for (const Processor* processor : processors) {
        const MessagePorts& ports = processor->message_ports();
        const int count = settings.half_digested ? 2 : 1;
        if (ports.count() != count || ports.transmits(0) || !ports.receives(0) ||
            ports.transmits(1) != settings.half_digested ||
            ports.input_queue() != settings.processor_fifo) {
            throw WiringError(fmt::format(
                "{}: has {} message ports with {} places, not as set_polygon_ports() makes them",
                processor->name(), ports.count(), ports.input_queue()));
        }
    }
}

// A component's end of a wire.
struct End {
    Component* component = nullptr;
    PortIndex port{};
};

class Builder {
  public:
    Builder(Simulation& simulation, const Distribution& distribution,
            std::span<Processor* const> processors, const PolygonFabricSettings& settings)
        : simulation_(simulation),
          distribution_(distribution),
          processors_(processors),
          settings_(settings) {}

    PolygonNetwork build() {
        add_source();
        std::vector<End> inputs;  // of the elements
        for (const Distribution::Element& element : distribution_.elements) {
            inputs.push_back(std::visit([&](const auto& what) { return add(element.name, what); },
                                        element.what));
        }
        join({network_.source, PolygonSource::kOutput}, inputs.front());
        std::size_t splitter = 0;
        for (const Distribution::Element& element : distribution_.elements) {
            if (const auto* cut = std::get_if<Distribution::Cut>(&element.what)) {
                join({network_.splitters[splitter], PolygonSplitter::kLow}, inputs.at(cut->low));
                join({network_.splitters[splitter], PolygonSplitter::kHigh}, inputs.at(cut->high));
                ++splitter;
            }
        }
        return network_;
    }

  private:
    void join(End from, End to) {
        simulation_.connect(*from.component, from.port, *to.component, to.port, settings_.latency);
    }

    // Messages that the element with this index takes before it is full.
    int places(std::size_t element) const {
        const auto& what = distribution_.elements.at(element).what;
        if (std::holds_alternative<Distribution::Cut>(what)) {
            return settings_.splitter_input_fifo;
        }
        return std::holds_alternative<Distribution::Broadcast>(what) ? settings_.bus_input_fifo
                                                                     : settings_.processor_fifo;
    }

    void add_source() {
        PolygonSourceSettings source;
        source.node = static_cast<NodeIndex>(processors_.size());
        source.time_per_polygon = settings_.host_time_per_polygon;
        source.time_per_vertex = settings_.host_time_per_vertex;
        source.receiver_places = places(0);
        source.phases_per_frame = settings_.phases_per_frame;
        source.supervised = settings_.supervised;
        network_.source = &simulation_.add<PolygonSource>("host", source);
    }

    End add(const std::string& name, const Distribution::Cut& cut) {
        const SplitterSettings splitter{cut.axis,
                                        cut.line,
                                        settings_.whole_edges,
                                        settings_.splitter_time_per_vertex,
                                        settings_.splitter_input_fifo,
                                        settings_.splitter_output_fifo,
                                        places(cut.low),
                                        places(cut.high)};
        network_.splitters.push_back(&simulation_.add<PolygonSplitter>(name, splitter));
        return {network_.splitters.back(), PolygonSplitter::kInput};
    }

    End add(const std::string& name, const Distribution::Broadcast& broadcast) {
        const PolygonBusSettings settings{settings_.bus_time_per_word, settings_.bus_input_fifo,
                                          static_cast<int>(broadcast.processors.size()),
                                          settings_.processor_fifo, settings_.half_digested};
        auto& bus = simulation_.add<PolygonBus>(name, settings);
        network_.buses.push_back(&bus);
        for (std::size_t i = 0; i < broadcast.processors.size(); ++i) {
            join({&bus, PolygonBus::listener_port(static_cast<int>(i))},
                 input_of(broadcast.processors[i]));
        }
        if (settings_.half_digested) {
            add_turn_bus("turn_" + name, broadcast.processors);
        }
        return {&bus, PolygonBus::kInput};
    }

    void add_turn_bus(const std::string& name, std::span<const NodeIndex> processors) {
        const TurnBusSettings settings{settings_.bus_time_per_word,
                                       static_cast<int>(processors.size()),
                                       settings_.processor_fifo};
        auto& bus = simulation_.add<TurnBus>(name, settings);
        network_.turn_buses.push_back(&bus);
        for (int i = 0; i < settings.processors; ++i) {
            Processor& processor = *processors_[processors[static_cast<std::size_t>(i)]];
            join({&processor, Processor::transmit_port(1)}, {&bus, TurnBus::input_port(i)});
            join({&bus, TurnBus::output_port(i)}, {&processor, Processor::receive_port(1)});
        }
    }

    End add(const std::string& name, const Distribution::Leaf& leaf) {
        if (settings_.half_digested) {
            throw std::invalid_argument(
                name +
                ": has its part of the screen to itself, nobody shares half-digested polygons");
        }
        return input_of(leaf.processor);
    }

    End input_of(NodeIndex processor) {
        if (processor >= processors_.size()) {
            throw WiringError(fmt::format("a distribution to {} processors names processor {}",
                                          processors_.size(), processor));
        }
        return {processors_[processor], Processor::receive_port(0)};
    }

    Simulation& simulation_;
    const Distribution& distribution_;
    std::span<Processor* const> processors_;
    const PolygonFabricSettings& settings_;
    PolygonNetwork network_;
};

}  // namespace

void set_polygon_ports(Processor::Settings& processor, const PolygonFabricSettings& fabric,
                       const topology::PixelGrid& grid) {
    processor.ports.ports = fabric.half_digested ? 2 : 1;
    processor.ports.transmitting = fabric.half_digested ? 2 : 0;
    processor.ports.receiving = fabric.half_digested ? 3 : 1;
    processor.ports.output_queue = effective(fabric).digest_output_queue;
    processor.ports.receivers_queue = 1;  // a message's memory is free when the bus has taken it
    processor.ports.input_queue = effective(fabric).processor_fifo;
    processor.supervised = fabric.supervised;
    const bool over_bus = effective(fabric).frame_buffer_bus_time_per_pixel.has_value();
    processor.frame_buffer = FrameBuffer::Settings{grid.rows, grid.columns, over_bus};
}

PolygonNetwork connect_polygon_network(Simulation& simulation, const Distribution& distribution,
                                       std::span<Processor* const> processors,
                                       const PolygonFabricSettings& settings) {
    const PolygonFabricSettings wanted = effective(settings);
    check_processors(distribution, processors, wanted);
    PolygonNetwork network = Builder(simulation, distribution, processors, wanted).build();
    if (wanted.frame_buffer_bus_time_per_pixel) {
        network.frame_buffer_bus = &simulation.add<FrameBufferBus>(
            "frame_buffer_bus", *wanted.frame_buffer_bus_time_per_pixel,
            static_cast<int>(processors.size()));
        for (std::size_t i = 0; i < processors.size(); ++i) {
            network.frame_buffer_bus->connect(simulation, static_cast<int>(i), *processors[i]);
        }
    }
    return network;
}

}  // namespace rasterloom
