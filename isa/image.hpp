// SPDX-License-Identifier: MIT
// A program as it is loaded into a node's memory: what the assembler makes and what raw images and
// a.out files hold.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::isa {

// Where a word of a program came from. Lines and columns count from 1.
struct SourceLocation {
    std::string file;
    int line = 0;
    int column = 0;

    friend bool operator==(const SourceLocation&, const SourceLocation&) = default;
};

// A contiguous run of bytes at a byte address of the node's memory or program store.
struct Segment {
    std::uint32_t address = 0;
    std::vector<std::uint8_t> bytes;
};

// Addresses count Isa::address_unit() bytes, but for those of the segments.
struct Image {
    std::string name;                                           // file name, for messages
    std::uint32_t entry = 0;                                    // address of the first instruction
    std::vector<Segment> segments;                              // ascending, not overlapping
    std::map<std::string, std::uint32_t, std::less<>> symbols;  // labels and assigned symbols
    std::map<std::uint32_t, SourceLocation> lines;   // address of each statement's output
    std::set<std::string, std::less<>> labels = {};  // those of the symbols that are labels

    std::optional<std::uint32_t> symbol(std::string_view symbol_name) const {
        const auto found = symbols.find(symbol_name);
        return found == symbols.end() ? std::nullopt : std::optional(found->second);
    }

    // The source line that produced what stands at `address`, if the image knows.
    const SourceLocation* source_of(std::uint32_t address) const {
        auto after = lines.upper_bound(address);
        return after == lines.begin() ? nullptr : &std::prev(after)->second;
    }
};

}  // namespace rasterloom::isa
