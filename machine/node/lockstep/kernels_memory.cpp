// SPDX-License-Identifier: MIT
// Kernels that reach beyond their block's rows: lane memory, communication registers, the rest.
#include "machine/node/lockstep/highway_targets.hpp"
#include "machine/node/lockstep/kernel_tables.hpp"

#include <algorithm>

// Highway includes this file again for each instruction set; the order matters.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "machine/node/lockstep/kernels_memory.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "machine/node/lockstep/vectors-inl.hpp"
#include "machine/node/lockstep/lines-inl.hpp"
#include "machine/node/lockstep/words-inl.hpp"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace rasterloom::lockstep {
namespace HWY_NAMESPACE {
namespace {

// Whether one of so many words from base + offset on is of a record in flight.
template <bool kMasked>
HWY_INLINE bool flies(const LaneBlock& block, std::uint16_t base, std::uint32_t bank,
                      std::uint16_t offset, int words) {
    const Words d;
    const Flying& flying = *block.flying;
    const Transfer& transfer = *flying.transfer;
    if (transfer.store_bank != bank) {
        return false;
    }
    const Vector ahead =
        hn::Set(d, static_cast<std::uint16_t>(offset - transfer.first_offset + words - 1));
    const Vector near = hn::Set(d, static_cast<std::uint16_t>(transfer.words + words - 1));
    Mask found = hn::Ne(near, near);  // nowhere
    for (std::size_t lane = 0; lane < block.width; lane += hn::Lanes(d)) {
        const Vector address = hn::Add(hn::Load(d, block.rows + base + lane), ahead);
        const Vector distance = hn::Sub(address, hn::Load(d, flying.at.data() + lane));
        const Mask looks = load_bits(kMasked ? block.awake : block.exists, lane);
        found = hn::Or(found, hn::And(looks, hn::Lt(distance, near)));
    }
    return !hn::AllFalse(d, found);
}

// Before words of memory are looked at or changed, so many from base + offset on, on lanes that are
// awake: what flies and is among them has to be there.
template <bool kMasked>
HWY_INLINE void land_words(LaneBlock& block, std::uint16_t base, std::uint32_t bank,
                           std::uint16_t offset, int words) {
    if (block.flying->transfer != nullptr && flies<kMasked>(block, base, bank, offset, words)) {
        land(block);
    }
}
// What the operation reaches; all eight words of lanes that sleep, too, where it goes by lines.
template <bool kMasked>
HWY_INLINE void land_for(LaneBlock& block, const MicroOperation& op) {
    if (op.detail != 0) {
        land_words<false>(block, op.a, op.where, line_offset(op.immediate), kLineWords);
    } else {
        land_words<kMasked>(block, op.a, op.where, op.immediate, 1);
    }
}
template <bool kMasked>
HWY_INLINE void land_for_fixed(LaneBlock& block, const MicroOperation& op) {
    land_words<kMasked>(block, op.a, op.where - op.immediate, op.immediate, 1);
}

template <bool kMasked>
void load_fixed(LaneBlock& block, const MicroOperation& op) {
    land_for_fixed<kMasked>(block, op);
    close_line_over(block, op.where / isa::vliw::kBankWords * isa::vliw::kBankWords,
                    op.where % isa::vliw::kBankWords, op.where % isa::vliw::kBankWords);
    load_at<kMasked>(block, block.rows + op.dst, op.where);
}

// Before a store that passes the lines by.
HWY_INLINE void leave_lines(LaneBlock& block, std::uint32_t bank, std::uint32_t from,
                            std::uint32_t to) {
    close_line_over(block, bank, from, to);
    forget_lines_over(block, bank, from, to);
}

template <bool kMasked>
void store_fixed(LaneBlock& block, const MicroOperation& op) {
    land_for_fixed<kMasked>(block, op);
    leave_lines(block, op.where / isa::vliw::kBankWords * isa::vliw::kBankWords,
                op.where % isa::vliw::kBankWords, op.where % isa::vliw::kBankWords);
    store_at<kMasked>(block, block.rows + op.b, op.where);
}

// Whether the line holds what all lanes that are awake want.
HWY_INLINE bool serves(const Line& line, const LaneBlock& block) {
    std::uint64_t missing = 0;
    for (std::size_t word = 0; word < block.bit_words(); ++word) {
        missing |= block.awake[word] & ~line.lanes[word];
    }
    return missing == 0;
}

template <bool kMasked>
HWY_INLINE void load_from(LaneBlock& block, const MicroOperation& op, const Line& line) {
    const std::uint16_t* const row = line.rows + op.immediate % kLineWords * block.width;
    each_vector<kMasked>(block, block.rows + op.dst, [row](std::size_t lane) HWY_ATTR {
        return hn::Load(Words(), row + lane);
    });
}

// Where a lane's words lie side by side, an address that is the same on all lanes is none the
// better for it.
HWY_INLINE bool goes_by_lines(const LaneBlock& block, const MicroOperation& op,
                              std::uint16_t address) {
    return op.detail != 0 && block.parts->memory->region(op.where + address).view().lane_stride > 1;
}

template <bool kMasked>
void load(LaneBlock& block, const MicroOperation& op) {
    LaneLines& lines = *block.lines;
    if (const std::size_t place = lines.place[op.detail]; place != 0) {
        if (serves(lines.lines[place - 1], block)) {
            load_from<kMasked>(block, op, lines.lines[place - 1]);
            return;
        }
        lines.forget(place - 1);
    }
    land_for<kMasked>(block, op);
    const std::uint16_t* const base = block.rows + op.a;
    const std::uint16_t value = base[kMasked ? first_awake(block) : 0];
    const auto address = static_cast<std::uint16_t>(value + op.immediate);
    if (!goes_by_lines(block, op, address) && is_uniform<kMasked>(block, base, value)) {
        close_line_over(block, op.where, address, address);
        load_at<kMasked>(block, block.rows + op.dst, op.where + address);
        return;
    }
    if (op.detail != 0) {
        const auto start = static_cast<std::uint16_t>(value + line_offset(op.immediate));
        if (const Line* const line = fetch_line(block, op, start)) {
            load_from<kMasked>(block, op, *line);
            return;
        }
    }
    Addresses addresses;
    find_addresses<kMasked>(block, op, address, addresses);
    close_line_over(block, op.where, addresses.least, addresses.most);
    std::uint16_t* const dst = block.rows + op.dst;
    each_word<kMasked>(block, op.where, addresses,
                       [dst](std::size_t lane, std::uint16_t word) HWY_ATTR { dst[lane] = word; });
}

template <bool kMasked>
HWY_INLINE void store_into_open_line(LaneBlock& block, const MicroOperation& op) {
    const std::size_t word = op.immediate % kLineWords;
    std::copy_n(block.rows + op.b, block.width, block.lines->open.rows + word * block.width);
    block.lines->dirty |= 1U << word;
    change_lines<kMasked>(block, op);
}

template <bool kMasked>
void store_each(LaneBlock& block, const MicroOperation& op, std::uint16_t address) {
    Addresses addresses;
    find_addresses<kMasked>(block, op, address, addresses);
    leave_lines(block, op.where, addresses.least, addresses.most);
    LaneMemory& memory = *block.parts->memory;
    const MemoryRegion& region = memory.region(op.where + addresses.least);
    if (!memory.extent(op.where + addresses.least).holds(op.where + addresses.most) ||
        region.view().lane_stride == 0) {
        each_lane<kMasked>(block, [&](std::size_t lane) HWY_ATTR {
            const MemoryRegion& own = memory.region(op.where + addresses.of[lane]);
            if (own.view().lane_stride == 0) {
                memory.unshare(own);
            }
        });
    }
    const std::uint16_t* const src = block.rows + op.b;
    each_word<kMasked>(block, op.where, addresses,
                       [src](std::size_t lane, std::uint16_t& word) HWY_ATTR { word = src[lane]; });
}

template <bool kMasked>
void store(LaneBlock& block, const MicroOperation& op) {
    if (op.detail != 0 && block.lines->open.id == op.detail) {
        store_into_open_line<kMasked>(block, op);
        return;
    }
    land_for<kMasked>(block, op);
    const std::uint16_t* const base = block.rows + op.a;
    const std::uint16_t value = base[kMasked ? first_awake(block) : 0];
    const auto address = static_cast<std::uint16_t>(value + op.immediate);
    if (!goes_by_lines(block, op, address) && is_uniform<kMasked>(block, base, value)) {
        leave_lines(block, op.where, address, address);
        store_at<kMasked>(block, block.rows + op.b, op.where + address);
        return;
    }
    const auto start = static_cast<std::uint16_t>(value + line_offset(op.immediate));
    if (op.detail != 0 && open_line(block, op, start)) {
        store_into_open_line<kMasked>(block, op);
        return;
    }
    store_each<kMasked>(block, op, address);
}

void forget_base(LaneBlock& block, const MicroOperation& op) {
    LaneLines& lines = *block.lines;
    if (lines.open.id != 0 && lines.open.base == op.a) {
        close_line(block);
    }
    for (std::uint32_t used = lines.used; used != 0; used &= used - 1) {
        const auto index = static_cast<std::size_t>(std::countr_zero(used));
        if (lines.lines[index].base == op.a) {
            lines.forget(index);
        }
    }
    for (Relation& relation : lines.relations) {
        if (relation.a == op.a || relation.b == op.a) {
            relation = {};
        }
    }
}

void close_open_line(LaneBlock& block, const MicroOperation&) {
    close_line(block);
}

// The block's communication registers lie side by side in the ring, or at its end and its start.
template <bool kMasked>
void put(LaneBlock& block, const MicroOperation& op) {
    auto& ring = *block.parts->ring;
    const std::uint16_t* const src = block.rows + op.b;
    const std::size_t until_end = std::min(block.lanes, ring.size() - block.ring_place);
    if (!kMasked) {
        std::copy_n(src, until_end, ring.data() + block.ring_place);
        std::copy_n(src + until_end, block.lanes - until_end, ring.data());
        return;
    }
    each_lane<kMasked>(block, [&](std::size_t lane) HWY_ATTR {
        ring[lane < until_end ? block.ring_place + lane : lane - until_end] = src[lane];
    });
}

template <bool kMasked>
void get(LaneBlock& block, const MicroOperation& op) {
    const auto& ring = *block.parts->ring;
    const std::size_t until_end = std::min(block.lanes, ring.size() - block.ring_place);
    alignas(64) std::uint16_t found[kMaxWidth];
    std::uint16_t* const dst = block.rows + op.dst;
    std::uint16_t* const to = kMasked ? found : dst;
    std::copy_n(ring.data() + block.ring_place, until_end, to);
    std::copy_n(ring.data(), block.lanes - until_end, to + until_end);
    if (kMasked) {
        std::fill(found + block.lanes, found + block.width, std::uint16_t{0});
        each_vector<true>(block, dst, [&found](std::size_t lane) HWY_ATTR {
            return hn::Load(Words(), found + lane);
        });
    }
}

template <bool kMasked>
void aux(LaneBlock& block, const MicroOperation& op) {
    const Vector value = hn::Set(Words(), block.parts->aux);
    each_vector<kMasked>(block, block.rows + op.dst,
                         [value](std::size_t) HWY_ATTR { return value; });
}

void keep_test(LaneBlock& block, const MicroOperation&) {
    block.kept = block.test;
}

template <bool kMasked>
constexpr std::array<Kernel, kKernelCodes - kRegisterCodes> table_of() {
    return {load_fixed<kMasked>, load<kMasked>,  store_fixed<kMasked>, store<kMasked>,
            put<kMasked>,        get<kMasked>,   aux<kMasked>,         keep_test,
            forget_base,         close_open_line};
}

constexpr auto kFull = table_of<false>();
constexpr auto kMasked = table_of<true>();

}  // namespace

std::span<const Kernel> memory_table(bool masked) {
    return masked ? kMasked : kFull;
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterloom::lockstep
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rasterloom::lockstep {

HWY_EXPORT(memory_table);

std::span<const Kernel> memory_kernels(bool masked) {
    return HWY_DYNAMIC_DISPATCH(memory_table)(masked);
}

}  // namespace rasterloom::lockstep
#endif
