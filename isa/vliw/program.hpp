// SPDX-License-Identifier: MIT
// A program made ready for a lock-step machine: its bundles decoded, at their addresses.
#pragma once

#include "isa/isa.hpp"
#include "isa/vliw/bundle.hpp"

#include <cstdint>
#include <vector>

namespace rasterloom::isa::vliw {

struct Program final : PreparedProgram {
    std::vector<Bundle> bundles;  // by address; empty bundles where the image has none
    std::uint16_t entry = 0;
};

}  // namespace rasterloom::isa::vliw
