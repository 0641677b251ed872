// SPDX-License-Identifier: MIT
#include "machine/host/delivery_check.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>

namespace rasterloom::host {
namespace {

// The polygons that each region needs, ascending.
std::vector<std::vector<PolygonIndex>> needs_by_region(const Destinations& needed) {
    std::vector<std::vector<PolygonIndex>> needs(needed.regions());
    for (PolygonIndex polygon = 0; polygon < needed.polygons(); ++polygon)
        for (const auto& [first, last] : needed.of(polygon))
            for (RegionIndex region = first; region <= last; ++region)
                needs[region].push_back(polygon);
    return needs;
}

std::vector<DeliveryFault> received_in(RegionIndex region, RegionIndex regions,
                                       std::span<const std::vector<PolygonIndex>> received) {
    std::vector<DeliveryFault> all;
    for (std::size_t processor = region; processor < received.size(); processor += regions)
        for (const PolygonIndex polygon : received[processor])
            all.push_back({polygon, static_cast<ProcessorIndex>(processor)});
    std::ranges::sort(all, {}, [](const auto& r) { return std::pair(r.polygon, r.processor); });
    return all;
}

// Both ascending by polygon.
void compare(RegionIndex region, const std::vector<PolygonIndex>& needs,
             const std::vector<DeliveryFault>& received, DeliveryReport& report) {
    auto next = received.begin();
    const auto take_unneeded_before = [&](std::uint64_t polygon) {
        for (; next != received.end() && next->polygon < polygon; ++next)
            report.unneeded.add(*next);
    };
    for (const PolygonIndex polygon : needs) {
        take_unneeded_before(polygon);
        if (next == received.end() || next->polygon != polygon) {
            report.missing.add({polygon, region});
            continue;
        }
        for (++next; next != received.end() && next->polygon == polygon; ++next)
            report.repeated.add(*next);
    }
    take_unneeded_before(~std::uint64_t{0});
}

}  // namespace

void DeliveryFaults::add(const DeliveryFault& fault) {
    ++count;
    if (first.size() < kNamed)
        first.push_back(fault);
}

std::string DeliveryReport::to_string() const {
    if (is_correct())
        return fmt::format("all {} deliveries made, none twice, no other", needed);
    std::string text;
    const auto tell = [&](const DeliveryFaults& faults, const std::string& what,
                          const char* place) {
        if (faults.count == 0)
            return;
        std::string names;
        for (const auto& [polygon, processor] : faults.first)
            names += fmt::format("{}polygon {} {} {}", names.empty() ? "" : ", ", polygon, place,
                                 processor);
        text += fmt::format("{}{} {} ({}{})", text.empty() ? "" : "; ", faults.count, what, names,
                            faults.count > faults.first.size() ? ", ..." : "");
    };
    tell(missing, fmt::format("of {} deliveries missing", needed), "for region");
    tell(unneeded, "not needed", "on processor");
    tell(repeated, "made twice", "on processor");
    return text;
}

DeliveryReport check_delivery(const Destinations& needed,
                              std::span<const std::vector<PolygonIndex>> received) {
    const RegionIndex regions = needed.regions();
    if (regions == 0 || received.size() % regions != 0)
        throw std::invalid_argument(
            fmt::format("{} processors received polygons, expected a multiple of {} regions",
                        received.size(), regions));
    DeliveryReport report;
    const auto needs = needs_by_region(needed);
    for (RegionIndex region = 0; region < regions; ++region) {
        report.needed += needs[region].size();
        compare(region, needs[region], received_in(region, regions, received), report);
    }
    return report;
}

}  // namespace rasterloom::host
