// SPDX-License-Identifier: MIT
#include "machine/host/ring_model.hpp"

#include "machine/host/delivery_check.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rasterloom::host {
namespace {

constexpr std::uint32_t kMostProcessors = 65536;

[[noreturn]] void refuse(const std::string& what) {
    throw std::invalid_argument("ring: " + what);
}

void check_strides(const RingSetup& setup, RegionIndex regions) {
    const auto refuse_strides = [&](const std::string& why) {
        refuse(fmt::format("strides {}: {}", fmt::join(setup.strides, ","), why));
    };
    std::uint32_t reach = regions;
    for (const std::uint32_t stride : setup.strides) {
        if (stride == 0 || reach % stride != 0)
            refuse_strides(fmt::format("{} is not a divisor of {}, expected one of the {}", stride,
                                       reach, reach == regions ? "regions" : "stride before it"));
        reach = stride;
    }
    if (setup.strides.empty() || reach != 1)
        refuse_strides("expected 1 as the last one");
}

void check(const RingSetup& setup, RegionIndex regions) {
    if (setup.processors < 1 || setup.processors > kMostProcessors)
        refuse(fmt::format("{} processors, expected 1 to {}", setup.processors, kMostProcessors));
    if (setup.processors % regions != 0)
        refuse(fmt::format("groups of {}, expected a divisor of the {} processors", regions,
                           setup.processors));
    if (setup.duplication < 1 || setup.processors % setup.duplication != 0)
        refuse(fmt::format("duplication {}, expected a divisor of the {} processors",
                           setup.duplication, setup.processors));
    if (setup.period < 1)
        refuse("a test every 0 passes, expected every 1 or more");
    check_strides(setup, regions);
}

std::uint64_t divided_up(std::uint64_t a, std::uint64_t b) {
    return (a + b - 1) / b;
}

// Of the processors that polygon was dealt to, the nearest before the first of its regions.
ProcessorIndex source_of(PolygonIndex polygon, const Destinations& destinations,
                         const RingSetup& setup) {
    const std::uint32_t apart = setup.processors / setup.duplication;
    const RegionIndex regions = destinations.regions();
    const RegionIndex first = destinations.of(polygon).front().first;
    const auto distance = [&](ProcessorIndex processor) {
        return (first + regions - processor % regions) % regions;
    };
    ProcessorIndex nearest = polygon % apart;
    for (ProcessorIndex next = nearest; next < setup.processors; next += apart)
        if (distance(next) < distance(nearest))
            nearest = next;
    return nearest;
}

PolygonLists deal(const Destinations& destinations, const RingSetup& setup) {
    PolygonLists sources(setup.processors);
    for (PolygonIndex polygon = 0; polygon < destinations.polygons(); ++polygon)
        if (!destinations.of(polygon).empty())
            sources[source_of(polygon, destinations, setup)].push_back(polygon);
    return sources;
}

std::vector<std::uint64_t> sizes_of(const PolygonLists& lists) {
    std::vector<std::uint64_t> sizes;
    for (const auto& list : lists)
        sizes.push_back(list.size());
    return sizes;
}

std::uint64_t pass_cost(std::uint64_t distance, std::uint64_t words, std::uint64_t overhead) {
    return (2 + distance) * words + overhead;
}

// All stages; `lists` holds the sources before and the received polygons after.
std::vector<RingStage> distribute(const Destinations& destinations, const RingSetup& setup,
                                  PolygonLists& lists) {
    std::vector<RingStage> stages;
    std::uint32_t reach = destinations.regions();
    for (const std::uint32_t stride : setup.strides) {
        auto outcome = communicate(destinations,
                                   {{destinations.regions(), reach, stride}, setup.period}, lists);
        lists = std::move(outcome.received);
        stages.push_back(
            {stride, outcome.passes, outcome.passes * stride,
             outcome.passes * pass_cost(stride, setup.costs.words, setup.costs.overhead),
             outcome.sent, outcome.carried, sizes_of(lists)});
        reach = stride;
    }
    return stages;
}

std::uint64_t check_deliveries(const Destinations& destinations, const PolygonLists& received) {
    const auto report = check_delivery(destinations, received);
    if (!report.is_correct())
        throw std::logic_error("ring model: " + report.to_string());
    return report.needed;
}

std::vector<std::uint64_t> pixels_by_processor(std::span<const BoundingBox> boxes,
                                               const RegionMap& map, const PolygonLists& received) {
    std::vector<std::uint64_t> pixels(received.size());
    for (std::size_t processor = 0; processor < received.size(); ++processor) {
        const auto region = static_cast<RegionIndex>(processor % map.regions());
        for (const PolygonIndex polygon : received[processor])
            pixels[processor] +=
                static_cast<std::uint64_t>(map.pixels_in(boxes[polygon].box, region));
    }
    return pixels;
}

RingInstructions count_instructions(const RingRun& run, const RegionMap& map,
                                    const RingSetup& setup) {
    const RingCosts& costs = setup.costs;
    const std::uint64_t processors = setup.processors;
    const std::uint64_t regions = map.regions();
    const auto screen =
        static_cast<std::uint64_t>(map.width()) * static_cast<std::uint64_t>(map.height());
    RingInstructions count;
    count.rejecting = divided_up(run.polygons, processors / setup.duplication) * costs.reject;
    count.lighting = std::ranges::max(run.sourced) * costs.visible;
    for (const RingStage& stage : run.stages)
        count.communicating += stage.instructions;
    count.rasterising = std::ranges::max(run.pixels) * costs.pixel;
    count.compositing = divided_up(screen * (processors - regions), processors * regions) *
                        pass_cost(regions, costs.composited_words, costs.composited_overhead);
    return count;
}

}  // namespace

RingRun run_ring_model(std::span<const BoundingBox> boxes, const RegionMap& map,
                       const RingSetup& setup) {
    check(setup, map.regions());
    const Destinations destinations(boxes, map);
    RingRun run;
    run.polygons = boxes.size();
    run.visible =
        static_cast<std::uint64_t>(std::ranges::count_if(boxes, &BoundingBox::is_visible));
    run.received = deal(destinations, setup);
    run.sourced = sizes_of(run.received);
    run.stages = distribute(destinations, setup, run.received);
    run.deliveries = check_deliveries(destinations, run.received);
    run.pixels = pixels_by_processor(boxes, map, run.received);
    run.instructions = count_instructions(run, map, setup);
    return run;
}

}  // namespace rasterloom::host
