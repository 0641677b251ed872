// SPDX-License-Identifier: MIT
#include "machine/node/lockstep/block_runner.hpp"

#include <algorithm>
#include <limits>

namespace rasterloom::lockstep {
namespace {

constexpr std::int64_t kRowLimit = std::numeric_limits<std::uint16_t>::max();

void empty_row(LaneBlock& block) {
    std::uint16_t* const row = block.row(kAwakeRow);
    for (std::size_t lane = 0; lane < block.lanes; ++lane) {
        block.totals[lane] += row[lane];
        row[lane] = 0;
    }
    block.in_row = 0;
}

bool is_awake(const LaneBlock& block, std::size_t lane) {
    return (block.awake[lane / kBitsPerWord] >> (lane % kBitsPerWord) & 1U) != 0;
}

// Counts the cycles up to now before the sleep state changes: with a 16-bit addition where some
// lanes sleep and others do not, with none otherwise.
void count_awake(LaneBlock& block, std::int64_t now, const Kernels& kernels) {
    const std::int64_t cycles = now - block.since;
    block.since = now;
    if (!block.any_awake) {
        return;
    }
    if (block.all_awake) {
        block.all_cycles += cycles;
        return;
    }
    if (block.in_row + cycles > kRowLimit) {
        empty_row(block);
    }
    if (cycles > kRowLimit) {
        for (std::size_t lane = 0; lane < block.lanes; ++lane) {
            block.totals[lane] += is_awake(block, lane) ? cycles : 0;
        }
        return;
    }
    block.in_row += cycles;
    MicroOperation add;
    add.code = value_code(isa::vliw::AluOp::add, true);
    add.immediate = static_cast<std::uint16_t>(cycles);
    add.dst = add.a = static_cast<std::uint16_t>(kAwakeRow * block.width);
    kernels.masked[add.code](block, add);
}

std::uint64_t awake_after(Code code, const LaneBlock& block, std::size_t word) {
    const std::uint64_t awake = block.awake[word];
    switch (code) {
        case kWake:
            return block.exists[word];
        case kToggle:
            return block.exists[word] & ~awake;
        case kSleepIfSet:
            return awake & ~block.test[word];
        case kSleepIfClear:
            return awake & block.test[word];
        case kSleepIfKeptSet:
            return awake & ~block.kept[word];
        default:  // kSleepIfKeptClear
            return awake & block.kept[word];
    }
}

void change_sleep(LaneBlock& block, Code code, std::int64_t now, const Kernels& kernels) {
    if (block.lines->open.id != 0) {
        kernels.full[kCloseLine](block, {});  // its lanes are those awake until now
    }
    count_awake(block, now, kernels);
    bool all = true;
    bool any = false;
    for (std::size_t word = 0; word < block.bit_words(); ++word) {
        const std::uint64_t awake = awake_after(code, block, word);
        block.awake[word] = awake;
        all = all && awake == block.exists[word];
        any = any || awake != 0;
    }
    block.all_awake = all;
    block.any_awake = any;
}

void run_piece(LaneBlock& block, const Piece& piece, const Translation& translation,
               const Kernels& kernels) {
    const MicroOperation* const operations = translation.operations().data();
    std::uint32_t op = piece.first;
    while (op < piece.end) {
        std::uint32_t stop = 0;
        if (block.any_awake) {
            stop = std::min(translation.next_sleep_change(op), piece.end);
            const auto& variants = block.all_awake ? kernels.full : kernels.masked;
            for (; op < stop; ++op) {
                variants[operations[op].code](block, operations[op]);
            }
        } else {
            stop = translation.next_waking(op);
        }
        if (stop < piece.end) {
            change_sleep(block, operations[stop].code, operations[stop].where + piece.cycles_off,
                         kernels);
        }
        op = stop + 1;
    }
}

}  // namespace

void run_pieces(LaneBlock& block, std::span<const Piece> pieces, const Translation& translation,
                const Kernels& kernels) {
    const std::size_t ring = block.parts->ring->size();
    for (const Piece& piece : pieces) {
        block.ring_place = (piece.ring_offset + block.index * block.width) % ring;
        run_piece(block, piece, translation, kernels);
    }
}

void end_run(LaneBlock& block, const Kernels& kernels) {
    kernels.full[kCloseLine](block, {});
    block.lines->forget_all();
}

std::int64_t awake_cycles(const LaneBlock& block, std::size_t lane, std::int64_t now) {
    return block.all_cycles + block.totals[lane] + block.row(kAwakeRow)[lane] +
           (is_awake(block, lane) ? now - block.since : 0);
}

}  // namespace rasterloom::lockstep
