// SPDX-License-Identifier: MIT
// Words of lane memory where they lie: at one address on all lanes, or at each lane's own. Included
// once for each instruction set.
#if defined(RASTERLOOM_LOCKSTEP_WORDS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLOOM_LOCKSTEP_WORDS_INL
#undef RASTERLOOM_LOCKSTEP_WORDS_INL
#else
#define RASTERLOOM_LOCKSTEP_WORDS_INL
#endif

#include "machine/node/lockstep/vectors-inl.hpp"

#include <bit>

#include <hwy/cache_control.h>

HWY_BEFORE_NAMESPACE();
namespace rasterloom::lockstep {
namespace HWY_NAMESPACE {

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

inline std::size_t first_awake(const LaneBlock& block) {
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

}  // namespace HWY_NAMESPACE
}  // namespace rasterloom::lockstep
HWY_AFTER_NAMESPACE();

#endif
