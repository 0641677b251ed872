// SPDX-License-Identifier: MIT
#include "isa/pdp11/program.hpp"

#include "isa/pdp11/reachable.hpp"

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace rasterloom::isa::pdp11 {
namespace {

std::string octal(std::uint32_t value) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%06o", value);
    return text.data();
}

}  // namespace

Program::Program(const Image& image, const CostChoice& cost)
    : costs_(cost), memory_(kIoPage + 8), code_(kIoPage / 2 + 8) {
    load(image);
    find_code(image);
}

void Program::load(const Image& image) {
    for (const Segment& segment : image.segments) {
        const std::size_t end = segment.address + segment.bytes.size();
        if (end > kIoPage) {
            throw std::invalid_argument(image.name + ": the program reaches address " +
                                        octal(static_cast<std::uint32_t>(end - 1)) +
                                        "; a PDP-11's memory ends at 157777");
        }
        std::copy(segment.bytes.begin(), segment.bytes.end(),
                  memory_.begin() + static_cast<std::ptrdiff_t>(segment.address));
        last_address_ = std::max(last_address_, static_cast<std::uint32_t>(end));
    }
    if (image.entry >= kIoPage || (image.entry & 1U) != 0) {
        throw std::invalid_argument(
            image.name + ": the entry " + octal(image.entry) +
            " is no instruction address; expected an even one below 160000");
    }
    segments_ = image.segments;
    entry_ = static_cast<std::uint16_t>(image.entry);
}

void Program::find_code(const Image& image) {
    const std::vector<bool> starts = reachable_instructions(image, view());
    for (std::uint32_t index = 0; index < starts.size(); ++index) {
        if (!starts[index])
            continue;
        const int words = decode_instruction(view(), index).words;
        for (std::uint32_t i = index; i < index + static_cast<std::uint32_t>(words); ++i)
            code_[i] = true;
    }
    decode_blocks(starts);
}

void Program::decode_blocks(const std::vector<bool>& starts) {
    block_of_.fill(-1);
    for (std::uint32_t number = 0; number < kBlocks; ++number) {
        const std::uint32_t first = number * kBlockWords;
        const auto begin = starts.begin() + static_cast<std::ptrdiff_t>(first);
        if (std::find(begin, begin + kBlockWords, true) == begin + kBlockWords)
            continue;
        block_of_[number] = static_cast<std::int16_t>(blocks_.size());
        Block& block = blocks_.emplace_back();
        for (std::uint32_t i = 0; i < block.entries.size(); ++i) {
            block.entries[i] = i >= kBlockWords    ? next_block_entry(first + i)
                               : starts[first + i] ? decode_fused(view(), first + i).entry
                                                   : undecoded_entry(first + i);
        }
    }
}

}  // namespace rasterloom::isa::pdp11
