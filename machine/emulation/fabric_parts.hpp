// SPDX-License-Identifier: MIT
#pragma once

#include "machine/emulation/blueprint.hpp"
#include "machine/emulation/machine.hpp"
#include "machine/observe/fabric_report.hpp"

#include <vector>

namespace rasterloom::emulation {

// The fabric's parts: the host, then the elements in the distribution's order, each turn bus after
// its bus, then the frame-buffer bus; of a bucket tiler those of BucketNetwork::for_each_part; of a
// lock-step machine its sequencer. Empty where the machine is a graph.
std::vector<ComponentId> part_ids(const Blueprint& blueprint, const Machine& machine);

// What the fabric's parts have counted until `end`, in the same order.
std::vector<observe::FabricPartReport> gather_fabric(const Blueprint& blueprint,
                                                     const Machine& machine, Time end);

}  // namespace rasterloom::emulation
