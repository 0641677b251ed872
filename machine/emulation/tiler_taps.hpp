// SPDX-License-Identifier: MIT
// Where the tiler program's sections begin, and what it is about to do there: the labels that begin
// with tap_, as programs/pdp11/tiler.s describes them.
#pragma once

#include "isa/core.hpp"
#include "isa/image.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace rasterloom::emulation {

enum class TilerTap : std::uint8_t {
    idle,         // waits for the next message
    digest,       // works a polygon out for others
    polygon,      // sets a polygon up
    vertex,       // a side comes to its next vertex and sets the edge below it up
    segment,      // begins a line of the polygon
    pixels,       // draws the line's pixels next
    pixels_done,  // finishes the line
};

class TilerTaps {
  public:
    // Throws std::invalid_argument when the program lacks one of the labels (but tap_digest) or
    // `vertex_count`, has a label tap_... that is none of them, or two of different kinds at one
    // address.
    explicit TilerTaps(const isa::Image& image);

    std::vector<std::uint32_t> addresses() const;
    // Of one of those addresses.
    TilerTap kind(std::uint32_t address) const { return kinds_.at(address); }

    // At a polygon: how many vertices it has.
    int vertices(const isa::Core& core) const;
    // At pixels: how many, 1 or more, and the first one's column.
    struct Run {
        int column = 0;
        int pixels = 0;
    };
    static Run run(const isa::Core& core);

  private:
    std::map<std::uint32_t, TilerTap> kinds_;
    std::uint32_t vertex_count_ = 0;  // address of the word
};

}  // namespace rasterloom::emulation
