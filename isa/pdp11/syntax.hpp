// SPDX-License-Identifier: MIT
// PDP-11 operands to and from text, as MACRO-11 writes them:
//
//   mode  text      effective address                    mode  text    PC modes (register 7)
//   0r    rn        the register                         27    #n      the next word
//   1r    (rn) @rn  what the register points at          37    @#a     the address in the next word
//   2r    (rn)+     the same, then the register advances 67    a       a, as a distance from the PC
//   3r    @(rn)+    what that points at                  77    @a      what that points at
//   4r    -(rn)     the register goes back, then points
//   5r    @-(rn)    what that points at
//   6r    x(rn)     x more than the register
//   7r    @x(rn)    what that points at; @(rn) is @0(rn)
#pragma once

#include "isa/syntax.hpp"

namespace rasterloom::isa::pdp11 {

const Syntax& pdp11_syntax();

}  // namespace rasterloom::isa::pdp11
