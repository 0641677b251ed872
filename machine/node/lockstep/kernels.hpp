// SPDX-License-Identifier: MIT
// The passes over a block that micro-operations stand for, compiled for each of the host's vector
// instruction sets.
#pragma once

#include "machine/node/lockstep/lane_block.hpp"
#include "machine/node/lockstep/micro_operation.hpp"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::lockstep {

using Kernel = void (*)(LaneBlock&, const MicroOperation&);

struct Kernels {
    std::array<Kernel, kKernelCodes> full{};    // all lanes are awake
    std::array<Kernel, kKernelCodes> masked{};  // lanes asleep keep what they have
};

struct PointerRange {
    std::uint16_t least = 0;
    std::uint16_t most = 0;
};
struct PointerCheck {
    PointerRange first;
    PointerRange second;
    int nearest = 0;  // the least distance of the two on a lane where they differ; not modulo 2^16
};
// Of two registers, on all lanes of a block.
PointerCheck check_pointers(const LaneBlock& block, int first, int second);

// Of the instruction set in use.
const Kernels& kernels();
// See LockstepArray::paths and use_path.
std::vector<std::string> kernel_paths();
void use_kernel_path(std::string_view name);

}  // namespace rasterloom::lockstep
