// SPDX-License-Identifier: MIT
// Appendix C for a person.
#pragma once

#include "machine/observe/appendix_c/appendix_c.hpp"

#include <string>

namespace rasterloom::observe {

// One line a processor (all frames together), the formula beside the emulated cycles, and what the
// program's items cost beside the thesis'. "own" is the error of those costs, means over all
// processors, times each processor's items.
std::string appendix_c_table(const AppendixCReport& report);

// Everything of one processor, in the thesis' order; all frames together.
std::string appendix_c_of(const AppendixCNode& node);

}  // namespace rasterloom::observe
