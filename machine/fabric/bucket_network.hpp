// SPDX-License-Identifier: MIT
// The parts of a bucket tiler: the tile sorter, and rasterizers in hardware or what feeds those
// that are processors.
#pragma once

#include "machine/fabric/rasterizer.hpp"
#include "machine/fabric/tile_feeder.hpp"
#include "machine/fabric/tile_sorter.hpp"

#include <vector>

namespace rasterloom {

struct BucketNetwork {  // owned by the simulation
    TileSorter* sorter = nullptr;
    std::vector<Rasterizer*> rasterizers;  // by node; none where they are processors
    std::vector<TileFeeder*> feeders;      // by node; none where they are hardware

    // Calls visit(component, part's id, its PartProbe): the sorter, then each rasterizer's triangle
    // unit and pixel unit, or each feeder. Once the machine is sealed.
    template <class Visit>
    void for_each_part(Visit&& visit) const {
        visit(*sorter, sorter->id(), sorter->probe());
        for (Rasterizer* rasterizer : rasterizers) {
            visit(*rasterizer, rasterizer->triangle_unit(), rasterizer->triangle_probe());
            visit(*rasterizer, rasterizer->pixel_unit(), rasterizer->pixel_probe());
        }
        for (TileFeeder* feeder : feeders) {
            visit(*feeder, feeder->id(), feeder->probe());
        }
    }
};

}  // namespace rasterloom
