// SPDX-License-Identifier: MIT
// Appendix C for programs: appendix-c.json and appendix-c.csv (docs/statistics.md).
#pragma once

#include "machine/observe/appendix_c/appendix_c.hpp"

#include <string>

namespace rasterloom::observe {

// Everything, frame by frame, distributions included.
std::string appendix_c_json(const AppendixCReport& report);
// One row a processor and frame.
std::string appendix_c_csv(const AppendixCReport& report);

}  // namespace rasterloom::observe
