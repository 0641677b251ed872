// SPDX-License-Identifier: MIT
#include "machine/emulation/fabric_parts.hpp"

#include <algorithm>

namespace rasterloom::emulation {

namespace {

using observe::FabricPart;
using observe::FabricPartReport;
using observe::FifoReport;
using topology::Distribution;

FifoReport fifo_report(const FifoStatistics& fifo, Duration whole) {
    return {fifo.peak, whole > Duration() ? fifo.mean(whole) : 0, fifo.full};
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
    if (counted.blocked > Duration()) {
        report.waited_for = receiver;
        report.waited_for_it = counted.blocked;
    }
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
    report.waited_for_it = std::max(counted.low.blocked, counted.high.blocked);
    if (report.waited_for_it > Duration()) {
        const bool low = counted.low.blocked >= counted.high.blocked;
        report.waited_for = distribution.elements[low ? cut.low : cut.high].name;
    }
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
    const auto slowest = std::max_element(counted.held_by.begin(), counted.held_by.end());
    if (*slowest > Duration()) {
        const auto listener = static_cast<std::size_t>(slowest - counted.held_by.begin());
        report.waited_for = machine.processors()[listeners.processors[listener]]->name();
        report.waited_for_it = *slowest;
    }
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
    for (std::size_t k = 0; k < listeners.processors.size(); ++k) {
        const Duration waited = counted.held_by[k] + counted.waited_for[k];
        if (waited > report.waited_for_it) {
            report.waited_for = machine.processors()[listeners.processors[k]]->name();
            report.waited_for_it = waited;
        }
    }
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
    const auto longest = std::max_element(counted.waiting_of.begin(), counted.waiting_of.end());
    if (*longest > Duration()) {
        const auto processor = static_cast<std::size_t>(longest - counted.waiting_of.begin());
        report.waited_for = machine.processors()[processor]->name();
        report.waited_for_it = *longest;
    }
    return report;
}

}  // namespace

std::vector<FabricPartReport> gather_fabric(const Blueprint& blueprint, const Machine& machine,
                                            Time end) {
    std::vector<FabricPartReport> reports;
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
