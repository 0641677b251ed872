// SPDX-License-Identifier: MIT
#pragma once

#include "machine/emulation/blueprint.hpp"
#include "machine/emulation/machine.hpp"
#include "machine/observe/fabric_report.hpp"
#include "machine/observe/page/machine_drawing.hpp"

#include <vector>

namespace rasterloom::emulation {

// Where a machine's processors stand. Of a graph: where the topology puts them, on a sphere if it
// says how they enclose it, else in the plane of (phi, theta); on a circle where it puts them
// nowhere. Of a bucket tiler that has run: also who drew which pixel last. `fabric`: the parts in
// the order of the report.
observe::MachineDrawing draw_machine(const Blueprint& blueprint, const Machine& machine,
                                     const std::vector<observe::FabricPartReport>& fabric);

}  // namespace rasterloom::emulation
