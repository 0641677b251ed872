// SPDX-License-Identifier: MIT
// The memory an assembly fills: each byte once.
#pragma once

#include "isa/image.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace rasterloom::isa::assembler {

class OutputMemory {
  public:
    // The line that wrote the byte before, if one has: the byte stays as it was.
    std::optional<std::size_t> write(std::uint32_t address, std::uint8_t byte, std::size_t line);
    std::vector<Segment> segments() const;  // ascending

  private:
    std::vector<std::uint8_t> bytes_;
    std::vector<std::uint32_t> writers_;  // index of the line plus one; 0 for none
};

}  // namespace rasterloom::isa::assembler
