// SPDX-License-Identifier: MIT
// How the files of kernels hand them over: for the instruction set in use, by code.
#pragma once

#include "machine/node/lockstep/kernels.hpp"

namespace rasterloom::lockstep {

// Codes 0 ... kRegisterCodes - 1 and kRegisterCodes ... kKernelCodes - 1.
std::span<const Kernel> register_kernels(bool masked);
std::span<const Kernel> memory_kernels(bool masked);

}  // namespace rasterloom::lockstep
