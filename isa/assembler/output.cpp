// SPDX-License-Identifier: MIT
#include "isa/assembler/output.hpp"

namespace rasterloom::isa::assembler {

std::optional<std::size_t> OutputMemory::write(std::uint32_t address, std::uint8_t byte,
                                               std::size_t line) {
    if (address >= bytes_.size()) {
        bytes_.resize(address + 1);
        writers_.resize(address + 1);
    }
    if (writers_[address] != 0) {
        return writers_[address] - 1;
    }
    bytes_[address] = byte;
    writers_[address] = static_cast<std::uint32_t>(line + 1);
    return std::nullopt;
}

std::vector<Segment> OutputMemory::segments() const {
    std::vector<Segment> segments;
    bool inside = false;
    for (std::uint32_t address = 0; address < bytes_.size(); ++address) {
        const bool written = writers_[address] != 0;
        if (written && !inside) {
            segments.push_back({address, {}});
        }
        if (written) {
            segments.back().bytes.push_back(bytes_[address]);
        }
        inside = written;
    }
    return segments;
}

}  // namespace rasterloom::isa::assembler
