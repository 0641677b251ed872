// SPDX-License-Identifier: MIT
#include "isa/pdp11/handlers_twofold.hpp"

namespace rasterloom::isa::pdp11 {

Handler twofold_byte_handler(Operation op, Place src, Place dst) {
    using enum Operation;
    switch (op) {
        case movb:
            return twofold_entry<movb>(src, dst);
        case cmpb:
            return twofold_entry<cmpb>(src, dst);
        case bitb:
            return twofold_entry<bitb>(src, dst);
        case bicb:
            return twofold_entry<bicb>(src, dst);
        case bisb:
            return twofold_entry<bisb>(src, dst);
        default:
            return nullptr;
    }
}

}  // namespace rasterloom::isa::pdp11
