// SPDX-License-Identifier: MIT
// A stage of ring communication as the thesis tells it: pointers that rotate and bits that are
// cleared, pass by pass.
#pragma once

#include "machine/host/ring_stage.hpp"

#include <algorithm>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

namespace rasterloom::host {

struct LiteralRing {
    struct Descriptor {
        PolygonIndex polygon;
        std::vector<bool> needed;  // by each processor
    };

    LiteralRing(const Destinations& destinations, StageSetup setup_, const PolygonLists& sources)
        : setup(setup_), ring(sources.size()), waiting(sources.size()), received(sources.size()) {
        for (std::size_t i = 0; i < sources.size(); ++i)
            for (const PolygonIndex polygon : sources[i]) {
                Descriptor next{polygon, bits(destinations, polygon, i, sources.size())};
                if (next.needed[i]) {
                    received[i].push_back(polygon);
                    next.needed[i] = false;
                }
                if (std::ranges::count(next.needed, true) > 0)
                    waiting[i].push_back(std::make_unique<Descriptor>(std::move(next)));
            }
    }

    // The processors within reach that need it, each put back to the last place of the stride.
    std::vector<bool> bits(const Destinations& destinations, PolygonIndex polygon,
                           std::size_t source, std::size_t processors) const {
        std::vector<bool> set(processors);
        for (std::size_t distance = 0; distance < setup.reach.reach; ++distance)
            for (const auto& range : destinations.of(polygon))
                if (const auto region = (source + distance) % setup.reach.regions;
                    range.first <= region && region <= range.last)
                    set[(source + distance - distance % setup.reach.stride) % processors] = true;
        return set;
    }

    void run() {
        const std::uint64_t period =
            std::min<std::uint64_t>(setup.period, setup.reach.reach / setup.reach.stride);
        for (;;) {
            for (std::size_t i = 0; i < ring.size(); ++i)
                if (!ring[i] && !waiting[i].empty()) {
                    ring[i] = std::move(waiting[i].front());
                    waiting[i].pop_front();
                }
            if (std::ranges::none_of(ring, [](const auto& slot) { return slot != nullptr; }))
                return;
            std::rotate(ring.begin(), ring.end() - setup.reach.stride, ring.end());
            ++passes;
            for (std::size_t i = 0; i < ring.size(); ++i) {
                if (!ring[i])
                    continue;
                ++carried;
                if (ring[i]->needed[i])
                    received[i].push_back(ring[i]->polygon);
                ring[i]->needed[i] = false;
                if (passes % period == 0 && std::ranges::count(ring[i]->needed, true) == 0)
                    ring[i] = nullptr;
            }
        }
    }

    StageSetup setup;
    std::vector<std::unique_ptr<Descriptor>> ring;
    std::vector<std::deque<std::unique_ptr<Descriptor>>> waiting;
    PolygonLists received;
    std::uint64_t passes = 0;
    std::uint64_t carried = 0;
};

}  // namespace rasterloom::host
