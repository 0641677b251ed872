// SPDX-License-Identifier: MIT
// The PDP-11 as an ISA.
#pragma once

#include "isa/isa.hpp"

namespace rasterloom::isa::pdp11 {

const Isa& pdp11_isa();

}  // namespace rasterloom::isa::pdp11
