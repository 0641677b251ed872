// SPDX-License-Identifier: MIT
#include "machine/observe/fabric_report.hpp"

#include "machine/observe/figures.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace rasterloom::observe {

namespace {

void append(std::string& text, const FifoReport& fifo) {
    fmt::format_to(std::back_inserter(text), ",{},{:.6f},{}", fifo.peak, fifo.mean,
                   fifo.full.picoseconds());
}

// The part of this kind with the largest value; null when there is none.
template <typename Value>
const FabricPartReport* largest(const std::vector<FabricPartReport>& fabric, FabricPart kind,
                                Value value) {
    const FabricPartReport* found = nullptr;
    for (const FabricPartReport& part : fabric) {
        if (part.part == kind && (found == nullptr || value(part) > value(*found))) {
            found = &part;
        }
    }
    return found;
}

std::string waiting(const FabricPartReport& part, Duration whole) {
    if (part.blocked == Duration()) {
        return {};
    }
    return fmt::format(", {:.1f}%{}", 100 * share(part.blocked, whole),
                       part.waited_for.empty() ? "" : " for " + part.waited_for);
}

void add_host(std::string& text, const FabricPartReport& host, Duration whole) {
    fmt::format_to(std::back_inserter(text),
                   "Host            {} polygons sent, {} vertices; preparing {:.1f}% of the time, "
                   "blocked {:.1f}%\n",
                   host.polygons, host.vertices, 100 * share(host.busy, whole),
                   100 * share(host.blocked, whole));
}

// "Splitters   busiest splitter/0 3.1%; blocked longest splitter/0, 51.2% for splitter/1"
void add_kind(std::string& text, const std::vector<FabricPartReport>& fabric, FabricPart kind,
              std::string_view title, Duration whole) {
    const auto* busiest = largest(fabric, kind, [](const auto& part) { return part.busy; });
    const auto* blocked = largest(fabric, kind, [](const auto& part) { return part.blocked; });
    if (busiest == nullptr) {
        return;
    }
    fmt::format_to(std::back_inserter(text), "{:<16}busiest {} {:.1f}%; ", title, busiest->name,
                   100 * share(busiest->busy, whole));
    text += blocked->blocked == Duration()
                ? "none was ever held up\n"
                : fmt::format("held up longest {}{}\n", blocked->name, waiting(*blocked, whole));
}

}  // namespace

std::string_view name_of(FabricPart part) {
    switch (part) {
        case FabricPart::host:
            return "host";
        case FabricPart::splitter:
            return "splitter";
        case FabricPart::bus:
            return "bus";
        case FabricPart::frame_buffer_bus:
            return "frame_buffer_bus";
        case FabricPart::turn_bus:
            return "turn_bus";
        case FabricPart::sequencer:
            return "sequencer";
        case FabricPart::tile_sorter:
            return "tile_sorter";
        case FabricPart::tile_feeder:
            return "tile_feeder";
        case FabricPart::triangle_unit:
            return "triangle_unit";
        case FabricPart::pixel_unit:
            return "pixel_unit";
    }
    return {};
}

std::string fabric_csv(const std::vector<FabricPartReport>& fabric, Duration whole) {
    std::string text =
        "name,kind,polygons,vertices,words,cut,low_polygons,high_polygons,busy_ps,utilisation,"
        "blocked_ps,waited_for,waited_for_ps";
    for (const char* fifo : {"input", "low", "high"}) {
        fmt::format_to(std::back_inserter(text), ",{0}_peak,{0}_mean,{0}_full_ps", fifo);
    }
    text += "\n";
    for (const FabricPartReport& part : fabric) {
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{:.6f},{},{},{}",
                       part.name, name_of(part.part), part.polygons, part.vertices, part.words,
                       part.cut, part.low_polygons, part.high_polygons, part.busy.picoseconds(),
                       share(part.busy, whole), part.blocked.picoseconds(), part.waited_for,
                       part.waited_for_it.picoseconds());
        append(text, part.input);
        append(text, part.low);
        append(text, part.high);
        text += "\n";
    }
    return text;
}

std::string fabric_summary(const std::vector<FabricPartReport>& fabric, Duration whole) {
    std::string text;
    for (const FabricPartReport& part : fabric) {
        if (part.part == FabricPart::host) {
            add_host(text, part, whole);
        }
    }
    add_kind(text, fabric, FabricPart::splitter, "Splitters", whole);
    add_kind(text, fabric, FabricPart::bus, "Polygon buses", whole);
    add_kind(text, fabric, FabricPart::turn_bus, "Digest bus", whole);
    add_kind(text, fabric, FabricPart::frame_buffer_bus, "Pixel bus", whole);
    add_kind(text, fabric, FabricPart::tile_sorter, "Tile sorter", whole);
    add_kind(text, fabric, FabricPart::tile_feeder, "Tile feeders", whole);
    return text;
}

}  // namespace rasterloom::observe
