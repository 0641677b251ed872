// SPDX-License-Identifier: MIT
// What the assembler's tests share: PDP-11 source to words, and to the text of its errors.
#pragma once

#include "isa/assembler.hpp"
#include "isa/pdp11/instruction_table.hpp"
#include "isa/pdp11/syntax.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace rasterloom::isa::testing {

inline Dialect pdp11() {
    return {pdp11::instruction_table(), &pdp11::pdp11_syntax(), 16, 16};
}

inline Assembly assemble(std::string_view source, const AssemblerOptions& options = {}) {
    return assemble_text(pdp11(), "t.s", source, options);
}

// The bytes from the first to the last, gaps as zeros.
inline std::vector<std::uint8_t> bytes_of(const Image& image) {
    std::vector<std::uint8_t> bytes;
    for (const Segment& segment : image.segments) {
        bytes.resize(segment.address - image.segments.front().address);
        bytes.insert(bytes.end(), segment.bytes.begin(), segment.bytes.end());
    }
    return bytes;
}

inline std::vector<unsigned> words_of(const Image& image) {
    const auto bytes = bytes_of(image);
    std::vector<unsigned> words;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        words.push_back(bytes[i] | unsigned{bytes[i + 1]} << 8);
    }
    return words;
}

// The words of a source without errors.
inline std::vector<unsigned> words(std::string_view source, const AssemblerOptions& options = {}) {
    const Assembly assembly = assemble(source, options);
    EXPECT_TRUE(assembly.ok()) << to_string(assembly.diagnostics);
    return words_of(assembly.image);
}

inline std::string complaint(std::string_view source) {
    return to_string(assemble(source).diagnostics);
}

}  // namespace rasterloom::isa::testing
