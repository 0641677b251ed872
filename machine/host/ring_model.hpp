// SPDX-License-Identifier: MIT
// Eldridge's simulator (1995, appendix A): what rendering costs on a ring of lock-step processors,
// from bounding boxes and a screen map. Passes are simulated (ring_stage.hpp); the rest follows
// from the processor that has most to do. The counts stand beside those of the emulated machine
// code.
//
//  1. Polygon b is dealt to the processors i = b mod (n/m) + k n/m, m of them. Geometry first takes
//         ceil(p m / n) * reject                                  to transform, keep or reject it
//  2. Of its m processors that one sources a visible polygon which has the fewest places to go to
//     the first of its regions (A.2.1: the rightmost one left of it). It lights it:
//         max_i(visible polygons sourced by i) * visible
//  3. Communication, stage by stage, a pass of stride d takes (2 + d) * words + overhead. What a
//     processor received is, in the order of arrival, the next stage's source list.
//  4. Rasterising takes max_i(pixels of i in its polygons' boxes) * pixel.
//  5. With g regions, g < n, pictures are composited: P (1/g - 1/n) pixels for each processor, P
//     those of the screen, over g places each: (2 + g) * composited_words + composited_overhead.
#pragma once

#include "machine/host/destinations.hpp"
#include "machine/host/ring_stage.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rasterloom::host {

// Instructions, and 16-bit words of a message (Eldridge 1995, tables 4.2, 4.3 and A.1).
struct RingCosts {
    std::uint64_t reject = 1000;
    std::uint64_t visible = 5000;
    std::uint64_t words = 42;
    std::uint64_t overhead = 30;
    std::uint64_t pixel = 100;
    std::uint64_t composited_words = 3;
    std::uint64_t composited_overhead = 15;
};

struct RingSetup {
    std::uint32_t processors = 1024;        // n, 1 to 65536, a multiple of the map's regions g
    std::uint32_t duplication = 1;          // m, a divisor of n
    std::vector<std::uint32_t> strides{1};  // each divides the one before, the first divides g; 1
    std::uint64_t period = 1;               // t, of the tests (ring_stage.hpp); n: sparse
    RingCosts costs{};
};

struct RingStage {
    std::uint32_t stride = 1;
    std::uint64_t passes = 0;
    std::uint64_t shifts = 0;  // passes * stride
    std::uint64_t instructions = 0;
    std::uint64_t sent = 0;               // polygons that entered the ring
    std::uint64_t carried = 0;            // of passes * n slots, those with a polygon
    std::vector<std::uint64_t> received;  // polygons, by each processor
};

struct RingInstructions {
    std::uint64_t rejecting = 0;
    std::uint64_t lighting = 0;
    std::uint64_t communicating = 0;
    std::uint64_t rasterising = 0;
    std::uint64_t compositing = 0;

    std::uint64_t total() const {
        return rejecting + lighting + communicating + rasterising + compositing;
    }
};

struct RingRun {
    std::uint64_t polygons = 0;
    std::uint64_t visible = 0;
    std::uint64_t deliveries = 0;        // polygon and region that needs it
    std::vector<std::uint64_t> sourced;  // visible polygons, by each processor
    std::vector<RingStage> stages;
    std::vector<std::uint64_t> pixels;  // of the boxes in its region, by each processor
    PolygonLists received;
    RingInstructions instructions;
};

// Throws std::invalid_argument for a setup that makes no sense, saying what was expected, and for
// what Destinations refuses; std::logic_error if the communication fails one of the checks of
// delivery_check.hpp.
RingRun run_ring_model(std::span<const BoundingBox> boxes, const RegionMap& map,
                       const RingSetup& setup);

}  // namespace rasterloom::host
