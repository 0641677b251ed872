// SPDX-License-Identifier: MIT
// Takes a Princeton Engine's picture out of its lanes: of their frame buffers
// (programs/vliw/memory.s) or of what they have composited (programs/vliw/composite.s).
#pragma once

#include "isa/image.hpp"
#include "machine/emulation/princeton_screen.hpp"
#include "machine/host/picture.hpp"
#include "machine/node/lockstep/lockstep_array.hpp"

#include <cstdint>
#include <vector>

namespace rasterloom {

struct PrincetonPicture {
    host::Picture picture;  // the program's screen; red, green and blue; black where nothing is
    std::vector<std::uint32_t> depth;  // [pixel]: 24 bits, 2^36/z'; 0: nothing drawn
};

// The picture that the program finished last. Frame buffers: the one that `shown` names, on each
// lane by itself; columns that no lane draws stay black. Composited: spread over all lanes, whose
// `columns` mean nothing. Throws std::invalid_argument when the image lacks a symbol.
PrincetonPicture shown_picture(const LockstepArray& array, const isa::Image& image,
                               const ColumnMap& columns);

}  // namespace rasterloom
