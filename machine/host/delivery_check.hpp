// SPDX-License-Identifier: MIT
// Whether a communication brought every polygon where it is needed (Eldridge 1995, appendix A.3):
// on all processors whose pixels its box meets, on no other, nowhere twice. In sort-twice, where
// several processors draw in a region, it is needed on exactly one of them.
#pragma once

#include "machine/host/destinations.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rasterloom::host {

struct DeliveryFault {
    PolygonIndex polygon = 0;
    ProcessorIndex processor = 0;  // of a missing polygon: its region
};

// The faults of one kind: how many, and the first by region, polygon and processor.
struct DeliveryFaults {
    static constexpr std::size_t kNamed = 5;

    std::uint64_t count = 0;
    std::vector<DeliveryFault> first;  // kNamed at most

    void add(const DeliveryFault& fault);
};

struct DeliveryReport {
    std::uint64_t needed = 0;  // polygon and region
    DeliveryFaults missing;    // needed, and on no processor of the region
    DeliveryFaults unneeded;   // received where no pixel of the box is, or no such polygon
    DeliveryFaults repeated;   // received once more in a region

    bool is_correct() const { return missing.count + unneeded.count + repeated.count == 0; }
    // "2 of 8 deliveries missing (polygon 5 on processor 3, ...); ...", one line.
    std::string to_string() const;
};

// `received[i]`: what processor i got, in any order. Throws std::invalid_argument when the
// processors are not a multiple of the regions.
DeliveryReport check_delivery(const Destinations& needed,
                              std::span<const std::vector<PolygonIndex>> received);

}  // namespace rasterloom::host
