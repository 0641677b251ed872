// SPDX-License-Identifier: MIT
// Words that a loader puts into a node's memory: constants of the program by their names, and
// tables behind it.
#pragma once

#include "isa/image.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace rasterloom {

class NodeMemory {
  public:
    // Constants lie between the symbols `first` and `end` of the image, tables from `tables` on
    // (even). Throws std::invalid_argument, naming the image and the symbol, when the image lacks
    // one of them.
    NodeMemory(const isa::Image& image, std::string_view first, std::string_view end,
               std::string_view tables);

    // Value of the constant at `symbol` (plus `offset` bytes), modulo 65536. Throws
    // std::invalid_argument when the image lacks the symbol, std::logic_error when it is not
    // between `first` and `end`.
    void set(std::string_view symbol, std::int64_t value, std::uint32_t offset = 0);
    // Likewise, at a byte address; for tables, whose symbol need not be looked up for every word.
    void set_at(std::uint32_t address, std::int64_t value);
    std::uint32_t address_of(std::string_view symbol) const;

    // Address of the next table word or byte.
    std::uint32_t here() const {
        return tables_.address + static_cast<std::uint32_t>(tables_.bytes.size());
    }
    void append(std::int64_t word);  // modulo 65536
    void append_byte(std::uint8_t byte) { tables_.bytes.push_back(byte); }
    void skip(std::uint32_t bytes) { tables_.bytes.resize(tables_.bytes.size() + bytes); }
    // Changes a table word that has been appended.
    void replace(std::uint32_t address, std::int64_t word);

    // Constants and tables, to be written over the program.
    std::vector<isa::Segment> segments() const { return {constants_, tables_}; }

  private:
    const isa::Image& image_;
    isa::Segment constants_;
    isa::Segment tables_;
};

// The image's value of a symbol. Throws std::invalid_argument, naming image and symbol, when there
// is none.
std::uint32_t require_symbol(const isa::Image& image, std::string_view symbol);

// Little-endian word of a node's memory. Throws std::out_of_range beyond its end.
std::uint16_t word_at(std::span<const std::uint8_t> memory, std::uint32_t address);

}  // namespace rasterloom
