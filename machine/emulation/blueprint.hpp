// SPDX-License-Identifier: MIT
// A machine as it is decided before anything of it is built: the description with its program
// assembled and its topology made.
#pragma once

#include "isa/registry.hpp"
#include "machine/config/description.hpp"
#include "topologies/bucket_tiles.hpp"
#include "topologies/tiling.hpp"
#include "topologies/topology.hpp"

#include <memory>
#include <optional>

namespace rasterloom::emulation {

struct Blueprint {
    // The description, and a registry that may load the ISA's plug-in, must outlive the blueprint.
    // Throws ConfigError and isa::AssemblyError for what is wrong with the input.
    Blueprint(const config::MachineDescription& machine, isa::IsaRegistry& registry);

    // Whether the nodes are lanes of one array with one lockstep.
    bool is_lockstep() const;

    const config::MachineDescription& description;
    const isa::Isa& isa;
    topology::Topology topology;
    std::optional<topology::Distribution> distribution;  // of a topology with a tiling
    std::optional<topology::BucketTiles> tiles;          // of a bucket tiler
    std::shared_ptr<const isa::Image> image;             // empty where nodes run no program
};

}  // namespace rasterloom::emulation
