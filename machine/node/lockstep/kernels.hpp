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

// Of the instruction set in use.
const Kernels& kernels();
// See LockstepArray::paths and use_path.
std::vector<std::string> kernel_paths();
void use_kernel_path(std::string_view name);

}  // namespace rasterloom::lockstep
