// SPDX-License-Identifier: MIT
#pragma once

#include "machine/node/lockstep/lane_state.hpp"

#include <cstddef>

namespace rasterloom::lockstep {

// `cast`: every lane's communication register takes the value of the nearest lane at or left of
// it that is awake and has T set. Lane 0's register is at `ring_offset` in the ring.
void broadcast_communication(LaneState& lanes, std::size_t ring_offset);

}  // namespace rasterloom::lockstep
