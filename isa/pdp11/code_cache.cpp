// SPDX-License-Identifier: MIT
#include "isa/pdp11/code_cache.hpp"

#include <algorithm>

namespace rasterloom::isa::pdp11 {
namespace {

// Words that an entry may have been made from: two instructions of three words.
constexpr std::uint32_t kLongest = 6;

}  // namespace

// Whether all words that the program's decoded block depends on are still the program's: those in
// the block, and the first few of the next, into which its last instructions reach.
bool CodeCache::matches_program(std::uint32_t number) const {
    const std::uint32_t first = number * kBlockWords;
    const std::uint32_t last = std::min(first + kBlockWords + kLongest, m_.memory_words);
    for (std::uint32_t i = first; i < last; ++i) {
        if (program_.is_code(i) &&
            m_.load_word(static_cast<std::uint16_t>(2 * i)) != program_.word(i))
            return false;
    }
    // With less memory than the program was decoded for, the last block is decoded anew.
    return first + kBlockWords + kLongest <= m_.memory_words || m_.memory_words == kIoPage / 2;
}

void CodeCache::mark(std::uint32_t index) {
    m_.code[index >> 5] |= 1U << (index & 31U);
}

Block* CodeCache::own(std::uint32_t number) {
    if (own_.empty())
        own_.resize(kBlocks);
    if (own_[number] == nullptr) {
        own_[number] = std::make_unique<Block>();
        for (std::uint32_t i = 0; i < own_[number]->entries.size(); ++i) {
            const std::uint32_t index = number * kBlockWords + i;
            own_[number]->entries[i] =
                i < kBlockWords ? undecoded_entry(index) : next_block_entry(index);
        }
    }
    m_.blocks[number] = own_[number]->entries.data();
    return own_[number].get();
}

const Entry* CodeCache::enter(std::uint16_t address) {
    const std::uint32_t index = address / 2U;
    const std::uint32_t number = index / kBlockWords;
    if (m_.blocks[number] == nullptr) {
        const Block* shared = program_.block(number);
        if (shared != nullptr && !has_taps(number) && matches_program(number)) {
            m_.blocks[number] = shared->entries.data();
            const std::uint32_t first = number * kBlockWords;
            for (std::uint32_t i = first; i < first + kBlockWords + kLongest; ++i) {
                if (program_.is_code(i))
                    mark(i);
            }
        } else {
            own(number);
        }
    }
    return m_.blocks[number] + index % kBlockWords;
}

void CodeCache::place(Block& block, std::uint32_t index) {
    if (is_tapped(index)) {
        block.entries[index % kBlockWords] = tapped_entry(index);
        return;
    }
    const CodeView view{m_.memory, m_.memory_words, &program_.costs()};
    const Decoded alone = decode_instruction(view, index);
    const bool before_tap = is_tapped(index + static_cast<std::uint32_t>(alone.words));
    const Decoded decoded = before_tap ? alone : decode_fused(view, index);
    block.entries[index % kBlockWords] = decoded.entry;
    const auto words = static_cast<std::uint32_t>(decoded.words);
    for (std::uint32_t i = index; i < index + words; ++i)
        mark(i);
    if (decoded.words == alone.words)
        return;
    // A fused handler reads its second instruction's entry, too.
    const std::uint32_t second = index + static_cast<std::uint32_t>(alone.words);
    if (block.entries[second % kBlockWords].run == &undecoded)
        place(block, second);
}

const Entry* CodeCache::decode(std::uint16_t address) {
    const std::uint32_t index = address / 2U;
    Block* block = own(index / kBlockWords);
    place(*block, index);
    return &block->entries[index % kBlockWords];
}

void CodeCache::forget_from(std::uint32_t number, std::uint32_t first, std::uint32_t last) {
    if (m_.blocks[number] == nullptr)
        return;
    Block* block = own(number);
    for (std::uint32_t i = first; i <= last; ++i)
        block->entries[i] = undecoded_entry(number * kBlockWords + i);
}

void CodeCache::written(std::uint32_t index) {
    m_.code[index >> 5] &= ~(1U << (index & 31U));
    const std::uint32_t number = index / kBlockWords;
    const std::uint32_t within = index % kBlockWords;
    forget_from(number, within < kLongest ? 0 : within - (kLongest - 1), within);
    if (within < kLongest - 1 && number > 0) {
        forget_from(number - 1, kBlockWords - (kLongest - 1 - within), kBlockWords - 1);
    }
}

bool CodeCache::has_taps(std::uint32_t number) const {
    for (std::uint32_t i = number * kBlockWords; i < (number + 1) * kBlockWords; ++i) {
        if (is_tapped(i))
            return true;
    }
    return false;
}

// It is found or decoded anew when it is next entered.
void CodeCache::forget_block(std::uint32_t number) {
    m_.blocks[number] = nullptr;
    if (!own_.empty())
        own_[number].reset();
}

void CodeCache::set_taps(std::span<const std::uint32_t> addresses) {
    const auto forget_tapped_blocks = [this] {
        for (std::uint32_t number = 0; number < kBlocks; ++number) {
            if (has_taps(number))
                forget_block(number);
        }
    };
    forget_tapped_blocks();
    taps_.assign(addresses.empty() ? 0 : m_.memory_words, false);
    for (const std::uint32_t address : addresses)
        taps_[address / 2] = true;
    forget_tapped_blocks();
}

std::size_t CodeCache::own_blocks() const {
    return static_cast<std::size_t>(std::count_if(
        own_.begin(), own_.end(), [](const auto& block) { return block != nullptr; }));
}

}  // namespace rasterloom::isa::pdp11
