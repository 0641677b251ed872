// SPDX-License-Identifier: MIT
// The toy's operands as text: addr, (x), (x)+, -(x), #n. Numbers are decimal unless marked (0x1f,
// ^O17).
#pragma once

#include "isa/syntax.hpp"

namespace rasterloom::isa::toy {

const Syntax& toy_syntax();

}  // namespace rasterloom::isa::toy
