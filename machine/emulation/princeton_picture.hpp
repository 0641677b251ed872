// SPDX-License-Identifier: MIT
// Takes a Princeton Engine's picture out of its lanes' frame buffers (programs/vliw/memory.s).
#pragma once

#include "isa/image.hpp"
#include "machine/emulation/princeton_loader.hpp"
#include "machine/host/picture.hpp"
#include "machine/node/lockstep/lockstep_array.hpp"

#include <cstdint>
#include <vector>

namespace rasterloom {

struct PrincetonPicture {
    host::Picture picture;             // 768 x 512, red, green and blue; black where nothing is
    std::vector<std::uint32_t> depth;  // [pixel]: 24 bits, 2^36/z'; 0: nothing drawn
};

// The picture that the program finished last: in the buffer that `shown` names, on each lane by
// itself. Columns that no lane draws stay black. Throws std::invalid_argument when the image lacks
// a symbol.
PrincetonPicture shown_picture(const LockstepArray& array, const isa::Image& image,
                               const ColumnMap& columns);

}  // namespace rasterloom
