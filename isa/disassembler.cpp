// SPDX-License-Identifier: MIT
#include "isa/disassembler.hpp"

#include <algorithm>
#include <iterator>
#include <map>

#include <fmt/format.h>

namespace rasterloom::isa {
namespace {

constexpr std::size_t kLongestInstruction = 9;  // words, of any ISA

std::string number(unsigned value, int radix) {
    return radix == 8 ? fmt::format("0{:o}", value) : fmt::format("0x{:x}", value);
}

}  // namespace

std::vector<std::uint16_t> words_of_bytes(std::span<const std::uint8_t> bytes, int word_bits) {
    if (word_bits == 8) {
        return {bytes.begin(), bytes.end()};
    }
    std::vector<std::uint16_t> words;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        words.push_back(static_cast<std::uint16_t>(bytes[i] | bytes[i + 1] << 8));
    }
    return words;
}

std::vector<DisassembledLine> disassemble(const Dialect& dialect,
                                          std::span<const std::uint8_t> bytes,
                                          std::uint32_t address) {
    const std::size_t word = dialect.word_bits == 8 ? 1 : 2;
    const auto unit = static_cast<std::size_t>(dialect.address_unit);
    const auto address_of = [&](std::size_t at) {
        return static_cast<std::uint32_t>(address + at / unit);
    };
    std::vector<DisassembledLine> lines;
    const auto single_byte = [&](std::size_t at) {
        lines.push_back(
            {address_of(at), 1, ".byte " + number(bytes[at], dialect.syntax->default_radix())});
    };
    std::size_t at = 0;
    if (word == 2 && address * unit % 2 != 0 && !bytes.empty()) {
        single_byte(at++);
    }
    while (at + word <= bytes.size()) {
        const std::size_t length = std::min(bytes.size() - at, kLongestInstruction * word);
        const auto words = words_of_bytes(bytes.subspan(at, length), dialect.word_bits);
        DecodedText decoded = dialect.syntax->decode(words, address_of(at));
        const std::size_t size = static_cast<std::size_t>(decoded.words) * word;
        lines.push_back(
            {address_of(at), static_cast<std::uint32_t>(size), std::move(decoded.text)});
        at += size;
    }
    if (at < bytes.size()) {
        single_byte(at);
    }
    return lines;
}

std::string disassemble(const Dialect& dialect, const Image& image) {
    std::multimap<std::uint32_t, std::string_view> names;
    for (const auto& [name, value] : image.symbols) {
        if (image.labels.empty() || image.labels.contains(name)) {
            names.emplace(value, name);
        }
    }
    const int radix = dialect.syntax->default_radix();
    std::string text;
    for (const Segment& segment : image.segments) {
        const auto start = segment.address / static_cast<std::uint32_t>(dialect.address_unit);
        fmt::format_to(std::back_inserter(text), "        . = {}\n", number(start, radix));
        for (const DisassembledLine& line : disassemble(dialect, segment.bytes, start)) {
            const auto [first, last] = names.equal_range(line.address);
            for (auto name = first; name != last; ++name) {
                fmt::format_to(std::back_inserter(text), "{}:\n", name->second);
            }
            fmt::format_to(std::back_inserter(text), "        {}\n", line.text);
        }
    }
    fmt::format_to(std::back_inserter(text), "        .end {}\n", number(image.entry, radix));
    return text;
}

}  // namespace rasterloom::isa
