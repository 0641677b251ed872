// SPDX-License-Identifier: MIT
// A program made ready for a lock-step machine: its bundles decoded, at their addresses.
#pragma once

#include "isa/isa.hpp"
#include "isa/vliw/bundle.hpp"

#include <cstdint>
#include <vector>

namespace rasterloom::isa::vliw {

struct Program final : PreparedProgram {
    Program() = default;
    // Throws std::invalid_argument, naming the source line where the image knows it, for what is no
    // bundle or cannot be executed, and for an entry without one.
    explicit Program(const Image& image);

    std::vector<Bundle> bundles;  // by address; empty bundles where the image has none
    std::uint16_t entry = 0;
};

}  // namespace rasterloom::isa::vliw
