// SPDX-License-Identifier: MIT
// The VLIW of the Princeton Engine as an instruction set: docs/vliw.md.
#pragma once

#include "isa/isa.hpp"

namespace rasterloom::isa::vliw {

const Isa& vliw_isa();

}  // namespace rasterloom::isa::vliw
