// SPDX-License-Identifier: MIT
// Kernels that reach beyond their block's rows: lane memory, communication registers, the rest.
#include "machine/node/lockstep/highway_targets.hpp"
#include "machine/node/lockstep/kernel_tables.hpp"

#include <algorithm>
#include <bit>

#include <hwy/cache_control.h>

// Highway includes this file again for each instruction set; the order matters.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "machine/node/lockstep/kernels_memory.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "machine/node/lockstep/vectors-inl.hpp"
#include "machine/node/lockstep/lines-inl.hpp"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace rasterloom::lockstep {
namespace HWY_NAMESPACE {
namespace {

// do_lane(lane) for every lane that exists, or for those that are awake.
template <bool kMasked, class DoLane>
HWY_INLINE void each_lane(const LaneBlock& block, DoLane do_lane) {
    if (!kMasked) {
        for (std::size_t lane = 0; lane < block.lanes; ++lane) {
            do_lane(lane);
        }
        return;
    }
    for (std::size_t word = 0; word < block.bit_words(); ++word) {
        for (std::uint64_t bits = block.awake[word]; bits != 0; bits &= bits - 1) {
            do_lane(word * kBitsPerWord + static_cast<std::size_t>(std::countr_zero(bits)));
        }
    }
}

std::size_t first_awake(const LaneBlock& block) {
    std::size_t word = 0;
    while (block.awake[word] == 0) {
        ++word;
    }
    return word * kBitsPerWord + static_cast<std::size_t>(std::countr_zero(block.awake[word]));
}

template <bool kMasked>
HWY_INLINE bool is_uniform(const LaneBlock& block, const std::uint16_t* row, std::uint16_t value) {
    const Words d;
    const Vector same = hn::Set(d, value);
    Mask differs = hn::Ne(same, same);  // nowhere
    for (std::size_t lane = 0; lane < block.width; lane += hn::Lanes(d)) {
        Mask here = hn::Ne(hn::Load(d, row + lane), same);
        if (kMasked) {
            here = hn::And(here, load_bits(block.awake, lane));
        }
        differs = hn::Or(differs, here);
    }
    return hn::AllFalse(d, differs);
}

// Each lane's address, base + offset modulo 2^16, and the range they are in.
struct Addresses {
    alignas(64) std::uint16_t of[kMaxWidth];
    std::uint16_t least;
    std::uint16_t most;
};

// `same`: any awake lane's address, which stands in for lanes that are not.
template <bool kMasked>
HWY_INLINE void find_addresses(const LaneBlock& block, const MicroOperation& op, std::uint16_t same,
                               Addresses& addresses) {
    const Words d;
    const Vector offset = hn::Set(d, op.immediate);
    Vector least = hn::Set(d, same);
    Vector most = least;
    for (std::size_t lane = 0; lane < block.width; lane += hn::Lanes(d)) {
        Vector address = hn::Add(hn::Load(d, block.rows + op.a + lane), offset);
        if (kMasked) {
            address = hn::IfThenElse(load_bits(block.awake, lane), address, hn::Set(d, same));
        }
        hn::Store(address, d, addresses.of + lane);
        least = hn::Min(least, address);
        most = hn::Max(most, address);
    }
    addresses.least = hn::GetLane(hn::MinOfLanes(d, least));
    addresses.most = hn::GetLane(hn::MaxOfLanes(d, most));
}

template <bool kMasked>
HWY_INLINE void load_at(LaneBlock& block, std::uint16_t* dst, std::uint32_t address) {
    const MemoryRegion& region = block.parts->memory->region(address);
    const MemoryView& view = region.view();
    const std::uint16_t* const from = region.at(view, block.index, address);
    if (view.lane_stride == 1) {
        each_vector<kMasked>(block, dst, [from](std::size_t lane) HWY_ATTR {
            return hn::Load(Words(), from + lane);
        });
    } else if (view.lane_stride == 0) {
        const Vector value = hn::Set(Words(), *from);
        each_vector<kMasked>(block, dst, [value](std::size_t) HWY_ATTR { return value; });
    } else {
        each_lane<kMasked>(
            block, [&](std::size_t lane) HWY_ATTR { dst[lane] = from[lane * view.lane_stride]; });
    }
}

template <bool kMasked>
HWY_INLINE void store_at(LaneBlock& block, const std::uint16_t* src, std::uint32_t address) {
    LaneMemory& memory = *block.parts->memory;
    const MemoryRegion& region = memory.region(address);
    if (region.view().lane_stride == 0) {
        memory.unshare(region);
    }
    const MemoryView& view = region.view();
    std::uint16_t* const to = region.at(view, block.index, address);
    if (view.lane_stride == 1) {
        each_vector<kMasked>(
            block, to, [src](std::size_t lane) HWY_ATTR { return hn::Load(Words(), src + lane); });
    } else {
        each_lane<kMasked>(
            block, [&](std::size_t lane) HWY_ATTR { to[lane * view.lane_stride] = src[lane]; });
    }
}

// Where lanes that share cache lines of the host go through words near each other, upwards or
// downwards, the first at a new one is at one end of them: asks the host's memory ahead of it.
HWY_INLINE void fetch_ahead(const LaneBlock& block, const std::uint16_t* words, std::size_t stride,
                            const Addresses& addresses) {
    constexpr std::size_t kTogether = 32;  // lanes
    constexpr std::ptrdiff_t kAhead = 8;   // words of a lane
    const auto step = static_cast<std::ptrdiff_t>(stride) * kAhead;
    for (std::size_t first = 0; first < block.width; first += kTogether) {
        const std::size_t last = first + kTogether - 1;
        const int span = addresses.of[last] - addresses.of[first];
        if (span >= 2 * static_cast<int>(kTogether) || -span >= 2 * static_cast<int>(kTogether)) {
            continue;
        }
        for (const std::size_t lane : {first, last}) {
            const std::uint16_t* const word =
                words + static_cast<std::size_t>(addresses.of[lane] - addresses.least) * stride +
                lane;
            hwy::Prefetch(word + step);
            hwy::Prefetch(word - step);
        }
    }
}

// do_word(lane, word of memory) for every lane (that is awake) at its own address.
template <bool kMasked, class DoWord>
HWY_INLINE void each_word(LaneBlock& block, std::uint32_t bank, const Addresses& addresses,
                          DoWord do_word) {
    const LaneMemory& memory = *block.parts->memory;
    const MemoryRegion& region = memory.region(bank + addresses.least);
    MemoryExtent extent = memory.extent(bank + addresses.least);
    if (!extent.holds(bank + addresses.most)) {
        const MemoryRegion* own = &region;
        MemoryView view = region.view();
        each_lane<kMasked>(block, [&](std::size_t lane) HWY_ATTR {
            const std::uint32_t address = bank + addresses.of[lane];
            if (!extent.holds(address)) {
                extent = memory.extent(address);
                own = &memory.region(address);
                view = own->view();
            }
            do_word(lane, own->at(view, block.index, address)[lane * view.lane_stride]);
        });
        return;
    }
    const MemoryView view = region.view();
    std::uint16_t* const words = region.at(view, block.index, bank + addresses.least);
    const std::size_t least = addresses.least;
    if (view.address_stride == 1) {
        each_lane<kMasked>(block, [&](std::size_t lane) HWY_ATTR {
            do_word(lane, words[addresses.of[lane] - least + lane * view.lane_stride]);
        });
    } else {
        fetch_ahead(block, words, view.address_stride, addresses);
        each_lane<kMasked>(block, [&](std::size_t lane) HWY_ATTR {
            do_word(lane, words[(addresses.of[lane] - least) * view.address_stride + lane]);
        });
    }
}

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
