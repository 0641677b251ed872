// SPDX-License-Identifier: MIT
#include "machine/emulation/fabric_parts.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace rasterloom::emulation {

namespace {

using observe::FabricPart;
using observe::FabricPartReport;
using observe::FifoReport;
using topology::Distribution;

FifoReport fifo_report(const FifoStatistics& fifo, Duration whole) {
    return {fifo.peak, whole > Duration() ? fifo.mean(whole) : 0, fifo.full};
}

// The one that was waited for longest, if anybody was.
void set_waited_for(FabricPartReport& report, const std::vector<Duration>& waited,
                    const std::function<std::string(std::size_t)>& name_of) {
    const auto longest = std::max_element(waited.begin(), waited.end());
    if (*longest > Duration()) {
        report.waited_for = name_of(static_cast<std::size_t>(longest - waited.begin()));
        report.waited_for_it = *longest;
    }
}

FabricPartReport host_report(const PolygonSource& source, const std::string& receiver) {
    const PolygonSourceStatistics& counted = source.statistics();
    FabricPartReport report;
    report.name = source.name();
    report.part = FabricPart::host;
    report.polygons = counted.polygons;
    report.vertices = counted.vertices;
    report.busy = counted.busy;
    report.blocked = counted.blocked;
    set_waited_for(report, {counted.blocked}, [&](std::size_t) { return receiver; });
    return report;
}

FabricPartReport splitter_report(const PolygonSplitter& splitter, const Distribution& distribution,
                                 const Distribution::Cut& cut, Duration whole) {
    const SplitterStatistics counted = splitter.statistics();
    FabricPartReport report;
    report.name = splitter.name();
    report.part = FabricPart::splitter;
    report.polygons = counted.polygons;
    report.vertices = counted.vertices;
    report.cut = counted.cut;
    report.low_polygons = counted.low.polygons;
    report.high_polygons = counted.high.polygons;
    report.busy = counted.busy;
    report.blocked = counted.blocked;
    set_waited_for(report, {counted.low.blocked, counted.high.blocked}, [&](std::size_t side) {
        return distribution.elements[side == 0 ? cut.low : cut.high].name;
    });
    report.input = fifo_report(counted.input_fifo, whole);
    report.low = fifo_report(counted.low.fifo, whole);
    report.high = fifo_report(counted.high.fifo, whole);
    return report;
}

FabricPartReport bus_report(const PolygonBus& bus, const Distribution::Broadcast& listeners,
                            const Machine& machine, Duration whole) {
    const PolygonBusStatistics counted = bus.statistics();
    FabricPartReport report;
    report.name = bus.name();
    report.part = FabricPart::bus;
    report.polygons = counted.messages;
    report.words = counted.words;
    report.busy = counted.busy;
    report.blocked = counted.held;
    set_waited_for(report, counted.held_by, [&](std::size_t listener) {
        return machine.processors()[listeners.processors[listener]]->name();
    });
    report.input = fifo_report(counted.input_fifo, whole);
    return report;
}

FabricPartReport turn_bus_report(const TurnBus& bus, const Distribution::Broadcast& listeners,
                                 const Machine& machine) {
    const TurnBusStatistics& counted = bus.statistics();
    FabricPartReport report;
    report.name = bus.name();
    report.part = FabricPart::turn_bus;
    report.polygons = counted.messages;
    report.words = counted.words;
    report.busy = counted.busy;
    report.blocked = counted.held + counted.out_of_turn;
    // Longest in the way: without a place, or without its message when its turn came.
    std::vector<Duration> waited = counted.held_by;
    for (std::size_t k = 0; k < waited.size(); ++k) {
        waited[k] += counted.waited_for[k];
    }
    set_waited_for(report, waited, [&](std::size_t k) {
        return machine.processors()[listeners.processors[k]]->name();
    });
    return report;
}

FabricPartReport pixel_bus_report(const FrameBufferBus& bus, const Machine& machine) {
    const FrameBufferBusStatistics& counted = bus.statistics();
    FabricPartReport report;
    report.name = bus.name();
    report.part = FabricPart::frame_buffer_bus;
    report.polygons = counted.pixels;
    report.words = counted.pixels;
    report.busy = counted.busy;
    report.blocked = counted.waiting;
    set_waited_for(report, counted.waiting_of,
                   [&](std::size_t processor) { return machine.processors()[processor]->name(); });
    return report;
}

FabricPartReport sequencer_report(const LockstepMachine& machine) {
    FabricPartReport report;
    report.name = machine.name();
    report.part = FabricPart::sequencer;
    report.busy = machine.statistics().busy;
    report.blocked = machine.statistics().blocked;
    return report;
}

FabricPartReport sorter_report(const TileSorter& sorter) {
    FabricPartReport report;
    report.name = sorter.name();
    report.part = FabricPart::tile_sorter;
    report.polygons = sorter.statistics().triangles;
    report.busy = sorter.statistics().busy;
    return report;
}

void add_units(const Rasterizer& rasterizer, const std::string& node,
               std::vector<FabricPartReport>& reports) {
    const RasterizerStatistics counted = rasterizer.statistics();
    const Clock& clock = rasterizer.settings().clock;
    const auto time = [&clock](Cycles cycles) { return clock.edge(cycles).since_start(); };
    FabricPartReport& triangles = reports.emplace_back();
    triangles.name = "triangle_unit/" + node;
    triangles.part = FabricPart::triangle_unit;
    triangles.polygons = counted.pairs;
    triangles.busy = time(counted.triangle_busy);
    triangles.blocked = time(counted.triangle_blocked);
    set_waited_for(triangles, {triangles.blocked},
                   [&](std::size_t) { return "pixel_unit/" + node; });
    FabricPartReport& pixels = reports.emplace_back();
    pixels.name = "pixel_unit/" + node;
    pixels.part = FabricPart::pixel_unit;
    pixels.polygons = counted.pixels;
    pixels.busy = time(counted.pixel_busy);
    pixels.input.peak = static_cast<int>(counted.fifo_peak);
}

FabricPartReport feeder_report(const TileFeeder& feeder) {
    const TileFeederStatistics& counted = feeder.statistics();
    FabricPartReport report;
    report.name = feeder.name();
    report.part = FabricPart::tile_feeder;
    report.polygons = counted.triangles;
    report.words = counted.words;
    report.busy = counted.busy;
    report.blocked = counted.blocked;
    set_waited_for(report, {counted.blocked}, [&](std::size_t) {
        return "node" + feeder.name().substr(feeder.name().find('/'));
    });
    return report;
}

void add_buckets(const Blueprint& blueprint, const BucketNetwork& buckets,
                 std::vector<FabricPartReport>& reports) {
    reports.push_back(sorter_report(*buckets.sorter));
    for (std::size_t node = 0; node < buckets.rasterizers.size(); ++node) {
        add_units(*buckets.rasterizers[node], blueprint.topology.nodes[node].name, reports);
    }
    for (const TileFeeder* feeder : buckets.feeders) {
        reports.push_back(feeder_report(*feeder));
    }
}

}  // namespace

std::vector<ComponentId> part_ids(const Blueprint& blueprint, const Machine& machine) {
    std::vector<ComponentId> ids;
    if (const BucketNetwork* buckets = machine.buckets()) {
        buckets->for_each_part(
            [&](const Component&, ComponentId part, const PartProbe&) { ids.push_back(part); });
    }
    if (machine.lockstep() != nullptr) {
        ids.push_back(machine.lockstep()->id());
    }
    const PolygonNetwork* fabric = machine.fabric();
    if (fabric == nullptr) {
        return ids;
    }
    ids.push_back(fabric->source->id());
    std::size_t splitters = 0;
    std::size_t buses = 0;
    for (const Distribution::Element& element : blueprint.distribution->elements) {
        if (std::holds_alternative<Distribution::Cut>(element.what)) {
            ids.push_back(fabric->splitters[splitters++]->id());
        } else if (std::holds_alternative<Distribution::Broadcast>(element.what)) {
            ids.push_back(fabric->buses[buses]->id());
            if (!fabric->turn_buses.empty()) {
                ids.push_back(fabric->turn_buses[buses]->id());
            }
            ++buses;
        }
    }
    if (fabric->frame_buffer_bus != nullptr) {
        ids.push_back(fabric->frame_buffer_bus->id());
    }
    return ids;
}

std::vector<FabricPartReport> gather_fabric(const Blueprint& blueprint, const Machine& machine,
                                            Time end) {
    std::vector<FabricPartReport> reports;
    if (machine.lockstep() != nullptr) {
        reports.push_back(sequencer_report(*machine.lockstep()));
    }
    if (machine.buckets() != nullptr) {
        add_buckets(blueprint, *machine.buckets(), reports);
    }
    const PolygonNetwork* fabric = machine.fabric();
    if (fabric == nullptr) {
        return reports;
    }
    const Distribution& distribution = *blueprint.distribution;
    const Duration whole = end.since_start();
    reports.push_back(host_report(*fabric->source, distribution.elements.front().name));
    std::size_t splitters = 0;
    std::size_t buses = 0;
    for (const Distribution::Element& element : distribution.elements) {
        if (const auto* cut = std::get_if<Distribution::Cut>(&element.what)) {
            reports.push_back(
                splitter_report(*fabric->splitters[splitters++], distribution, *cut, whole));
        } else if (const auto* bus = std::get_if<Distribution::Broadcast>(&element.what)) {
            reports.push_back(bus_report(*fabric->buses[buses], *bus, machine, whole));
            if (!fabric->turn_buses.empty()) {
                reports.push_back(turn_bus_report(*fabric->turn_buses[buses], *bus, machine));
            }
            ++buses;
        }
    }
    if (fabric->frame_buffer_bus != nullptr) {
        reports.push_back(pixel_bus_report(*fabric->frame_buffer_bus, machine));
    }
    return reports;
}

}  // namespace rasterloom::emulation
