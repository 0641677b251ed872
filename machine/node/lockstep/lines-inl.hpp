// SPDX-License-Identifier: MIT
// How lines are fetched, changed by stores and written back (lane_lines.hpp). Included once for
// each instruction set.
#if defined(RASTERLOOM_LOCKSTEP_LINES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLOOM_LOCKSTEP_LINES_INL
#undef RASTERLOOM_LOCKSTEP_LINES_INL
#else
#define RASTERLOOM_LOCKSTEP_LINES_INL
#endif

#include "machine/node/lockstep/vectors-inl.hpp"

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace rasterloom::lockstep {
namespace HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR
// A line's words of one lane, and of as many groups of eight lanes as a vector has room for.
using Part = hn::FixedTag<std::uint16_t, kLineWords>;
inline constexpr std::size_t kParts = hn::MaxLanes(Words()) / kLineWords;

// Within each part: row i of the result is column i of what was there.
HWY_INLINE void transpose(Vector* rows) {
    const Words d;
    const hn::RepartitionToWide<Words> d2;
    const hn::RepartitionToWide<decltype(d2)> d4;
    using Pair = hn::Vec<decltype(d2)>;
    using Quad = hn::Vec<decltype(d4)>;
    Pair pairs[8];
    for (int i = 0; i < 4; ++i) {
        pairs[i] = hn::BitCast(d2, hn::InterleaveLower(d, rows[2 * i], rows[2 * i + 1]));
        pairs[4 + i] = hn::BitCast(d2, hn::InterleaveUpper(d, rows[2 * i], rows[2 * i + 1]));
    }
    Quad quads[8];
    for (int i = 0; i < 4; ++i) {  // columns 2i and 2i + 1, of the upper rows and of the lower
        const int from = i / 2 * 4;
        for (int half = 0; half < 2; ++half) {
            const Pair a = pairs[from + half * 2];
            const Pair b = pairs[from + half * 2 + 1];
            quads[i * 2 + half] = hn::BitCast(
                d4, i % 2 == 0 ? hn::InterleaveLower(d2, a, b) : hn::InterleaveUpper(d2, a, b));
        }
    }
    for (int i = 0; i < 4; ++i) {
        rows[2 * i] = hn::BitCast(d, hn::InterleaveLower(d4, quads[2 * i], quads[2 * i + 1]));
        rows[2 * i + 1] = hn::BitCast(d, hn::InterleaveUpper(d4, quads[2 * i], quads[2 * i + 1]));
    }
}

// load(first), load(first + 1), ..., so many, side by side.
template <std::size_t kCount, class Load>
HWY_INLINE auto parts_of(std::size_t first, Load load) {
    if constexpr (kCount == 1) {
        return load(first);
    } else {
        constexpr std::size_t kHalf = kCount / 2;
        const hn::FixedTag<std::uint16_t, kCount * kLineWords> d;
        return hn::Combine(d, parts_of<kHalf>(first + kHalf, load), parts_of<kHalf>(first, load));
    }
}
#endif

// Lanes that are turned together.
inline constexpr std::size_t kTurned =
    HWY_TARGET == HWY_SCALAR ? kLineWords : hn::MaxLanes(Words());

// Of the lanes from `lane` on, kTurned of them.
HWY_INLINE std::uint64_t bits_from(const LaneBits& bits, std::size_t lane) {
    return bits[lane / kBitsPerWord] >> (lane % kBitsPerWord) & ((std::uint64_t{1} << kTurned) - 1);
}

// rows := each lane's eight words at words[lane * stride + at[lane]], but where all lanes that are
// turned together sleep. `lanes`: without those.
HWY_INLINE void turn_in(const LaneBlock& block, const std::uint16_t* words, std::size_t stride,
                        const std::uint16_t* at, Line& line) {
    for (std::size_t lane = 0; lane < block.width; lane += kTurned) {
        if (bits_from(block.awake, lane) == 0) {
            line.lanes[lane / kBitsPerWord] &=
                ~(((std::uint64_t{1} << kTurned) - 1) << (lane % kBitsPerWord));
            continue;
        }
#if HWY_TARGET == HWY_SCALAR
        for (std::size_t i = lane; i < lane + kTurned; ++i) {
            for (std::size_t word = 0; word < kLineWords; ++word) {
                line.rows[word * block.width + i] = words[i * stride + at[i] + word];
            }
        }
#else
        Vector square[kLineWords];
        for (std::size_t i = 0; i < kLineWords; ++i) {
            square[i] = parts_of<kParts>(0, [&](std::size_t part) HWY_ATTR {
                const std::size_t from = lane + part * kLineWords + i;
                return hn::LoadU(Part(), words + from * stride + at[from]);
            });
        }
        transpose(square);
        for (std::size_t word = 0; word < kLineWords; ++word) {
            hn::Store(square[word], Words(), line.rows + word * block.width + lane);
        }
#endif
    }
}

// The contrary, of the rows in `dirty` and the lanes in `lanes`: word by word...
HWY_INLINE void turn_out_words(const LaneBlock& block, std::uint16_t* words, std::size_t stride,
                               const Line& line, const std::uint16_t* at, std::uint32_t dirty) {
    std::uint16_t* to[kMaxWidth];
    std::uint16_t lanes[kMaxWidth];
    std::size_t count = 0;
    for (std::size_t word = 0; word < block.bit_words(); ++word) {
        for (std::uint64_t bits = line.lanes[word]; bits != 0; bits &= bits - 1) {
            const std::size_t lane =
                word * kBitsPerWord + static_cast<std::size_t>(std::countr_zero(bits));
            lanes[count] = static_cast<std::uint16_t>(lane);
            to[count++] = words + lane * stride + at[lane];
        }
    }
    for (; dirty != 0; dirty &= dirty - 1) {
        const auto word = static_cast<std::size_t>(std::countr_zero(dirty));
        const std::uint16_t* const row = line.rows + word * block.width;
        for (std::size_t i = 0; i < count; ++i) {
            to[i][word] = row[lanes[i]];
        }
    }
}

#if HWY_TARGET != HWY_SCALAR
// ... and lane by lane.
HWY_INLINE void turn_out_lanes(const LaneBlock& block, std::uint16_t* words, std::size_t stride,
                               const Line& line, const std::uint16_t* at, std::uint32_t dirty) {
    const Words d;
    const Part part;
    const auto bits = static_cast<std::uint8_t>(dirty);
    alignas(8) const std::uint8_t stored[8] = {bits};
    const hn::Mask<Part> mask = hn::LoadMaskBits(part, stored);
    for (std::size_t first = 0; first < block.width; first += kTurned) {
        const std::uint64_t lanes = bits_from(line.lanes, first);
        if (lanes == 0) {
            continue;
        }
        Vector square[kLineWords];
        for (std::size_t word = 0; word < kLineWords; ++word) {
            square[word] = hn::Load(d, line.rows + word * block.width + first);
        }
        transpose(square);
        alignas(64) std::uint16_t turned[kLineWords * kTurned];
        for (std::size_t i = 0; i < kLineWords; ++i) {
            hn::Store(square[i], d, turned + i * kTurned);
        }
        for (std::uint64_t left = lanes; left != 0; left &= left - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(left));
            std::uint16_t* const to = words + (first + i) * stride + at[first + i];
            const auto from =
                hn::Load(part, turned + i % kLineWords * kTurned + i / kLineWords * kLineWords);
            hn::StoreU(hn::IfThenElse(mask, from, hn::LoadU(part, to)), part, to);
        }
    }
}
#endif

HWY_INLINE void turn_out(const LaneBlock& block, std::uint16_t* words, std::size_t stride,
                         const Line& line, const std::uint16_t* at, std::uint32_t dirty) {
#if HWY_TARGET != HWY_SCALAR
    if (std::popcount(dirty) > kLineWords / 2) {
        turn_out_lanes(block, words, stride, line, at, dirty);
        return;
    }
#endif
    turn_out_words(block, words, stride, line, at, dirty);
}

// Writes the open line back, and closes it.
inline void close_line(LaneBlock& block) {
    LaneLines& lines = *block.lines;
    Line& open = lines.open;
    if (open.id == 0) {
        return;
    }
    const MemoryRegion& region = block.parts->memory->region(open.bank + open.least);
    const MemoryView& view = region.view();
    // Addresses in the bank may lie below the region's first: the lanes that have them sleep.
    const std::uint32_t shift = region.first() > open.bank ? region.first() - open.bank : 0;
    std::uint16_t* const words = region.at(view, block.index, open.bank + shift);
    alignas(64) std::uint16_t at[kMaxWidth];
    for (std::size_t lane = 0; lane < block.width; ++lane) {
        at[lane] = static_cast<std::uint16_t>(lines.open_at[lane] - shift);
    }
    turn_out(block, words, view.lane_stride, open, at, lines.dirty);
    open.id = 0;
    lines.dirty = 0;
}

inline void close_line_over(LaneBlock& block, std::uint32_t bank, std::uint32_t from,
                            std::uint32_t to) {
    const Line& open = block.lines->open;
    if (open.id != 0 && open.may_hold(bank, from, to)) {
        close_line(block);
    }
}

inline void forget_lines_over(LaneBlock& block, std::uint32_t bank, std::uint32_t from,
                              std::uint32_t to) {
    LaneLines& lines = *block.lines;
    for (std::uint32_t used = lines.used; used != 0; used &= used - 1) {
        const auto index = static_cast<std::size_t>(std::countr_zero(used));
        if (lines.lines[index].may_hold(bank, from, to)) {
            lines.forget(index);
        }
    }
}

inline const Relation& relation_of(LaneBlock& block, std::uint16_t a, std::uint16_t b) {
    LaneLines& lines = *block.lines;
    for (const Relation& known : lines.relations) {
        if (known.a == a && known.b == b) {
            return known;
        }
    }
    Relation& relation = lines.relations[lines.next_relation++ % lines.relations.size()];
    relation.a = a;
    relation.b = b;
    const Words d;
    const Vector farthest = hn::Set(d, 0xFFFF);
    Vector above = farthest;
    Vector below = farthest;
    for (std::size_t lane = 0; lane < block.width; lane += hn::Lanes(d)) {
        const Vector up =
            hn::Sub(hn::Load(d, block.rows + b + lane), hn::Load(d, block.rows + a + lane));
        const Mask equal = hn::Eq(up, hn::Zero(d));
        store_bits(equal, relation.equal, lane);
        const Mask counts = hn::And(load_bits(block.exists, lane), hn::Not(equal));
        above = hn::Min(above, hn::IfThenElse(counts, up, farthest));
        below = hn::Min(below, hn::IfThenElse(counts, hn::Sub(hn::Zero(d), up), farthest));
    }
    relation.nearest_above = hn::GetLane(hn::MinOfLanes(d, above));
    relation.nearest_below = hn::GetLane(hn::MinOfLanes(d, below));
    return relation;
}

// The addresses of a line: of lanes for which it lies in the region, of other lanes that of the
// first awake lane, where it does no harm. False if there is an awake lane among the others.
HWY_INLINE bool find_line(const LaneBlock& block, Line& line, std::uint16_t anchor,
                          std::uint16_t* at) {
    const Words d;
    const MemoryExtent& extent = block.parts->memory->extent(line.bank + anchor);
    const std::uint32_t low = extent.first > line.bank ? extent.first - line.bank : 0;
    const std::uint32_t end =
        std::min<std::uint32_t>(extent.end - line.bank, isa::vliw::kBankWords);
    const Vector first = hn::Set(d, static_cast<std::uint16_t>(low));
    const Vector room = hn::Set(d, static_cast<std::uint16_t>(end - low - kLineWords));
    const Vector offset = hn::Set(d, line.offset);
    const Vector stand_in = hn::Set(d, anchor);
    Vector least = stand_in;
    Vector most = stand_in;
    for (std::size_t lane = 0; lane < block.width; lane += hn::Lanes(d)) {
        const Vector address = hn::Add(hn::Load(d, block.rows + line.base + lane), offset);
        const Mask inside =
            hn::And(hn::Not(hn::Lt(room, hn::Sub(address, first))), load_bits(block.exists, lane));
        const Vector harmless = hn::IfThenElse(inside, address, stand_in);
        store_bits(inside, line.lanes, lane);
        hn::Store(harmless, d, at + lane);
        least = hn::Min(least, harmless);
        most = hn::Max(most, harmless);
    }
    line.least = hn::GetLane(hn::MinOfLanes(d, least));
    line.most = hn::GetLane(hn::MaxOfLanes(d, most));
    if (anchor < low || anchor - low > end - low - kLineWords) {
        return false;
    }
    for (std::size_t word = 0; word < block.bit_words(); ++word) {
        if ((block.awake[word] & ~line.lanes[word]) != 0) {
            return false;
        }
    }
    return true;
}

// Whether what the open line gathers may belong into a line that is about to be fetched.
inline bool open_line_concerns(LaneBlock& block, const Line& line) {
    const Line& open = block.lines->open;
    if (open.id == 0 || open.bank != line.bank) {
        return false;
    }
    const int between = open.offset - line.offset;
    if (open.base == line.base) {
        return between == 0;
    }
    if (!open.may_hold(line.bank, line.least, line.most + std::uint32_t{kLineWords - 1})) {
        return false;
    }
    const Relation& relation = relation_of(block, line.base, open.base);
    return !relation.clear_of(1 - kLineWords - between, kLineWords - 1 - between) ||
           (between == 0 && relation.equal != LaneBits{});
}

// A line to read; none where the words do not lie along the lanes.
inline const Line* fetch_line(LaneBlock& block, const MicroOperation& op, std::uint16_t anchor) {
    LaneLines& lines = *block.lines;
    const MemoryRegion& region = block.parts->memory->region(op.where + anchor);
    const MemoryView view = region.view();
    if (view.address_stride != 1) {
        return nullptr;
    }
    alignas(64) std::uint16_t at[kMaxWidth];
    const std::size_t index = lines.place_for_another();
    Line& line = lines.lines[index];
    line.base = op.a;
    line.bank = op.where;
    line.offset = line_offset(op.immediate);
    if (!find_line(block, line, anchor, at)) {
        return nullptr;
    }
    if (open_line_concerns(block, line)) {
        close_line(block);
    }
    const std::uint32_t shift = region.first() > line.bank ? region.first() - line.bank : 0;
    for (std::size_t lane = 0; lane < block.width; ++lane) {
        at[lane] = static_cast<std::uint16_t>(at[lane] - shift);
    }
    turn_in(block, region.at(view, block.index, line.bank + shift), view.lane_stride, at, line);
    line.id = op.detail;
    lines.place[line.id] = static_cast<std::uint8_t>(index + 1);
    lines.used |= 1U << index;
    return &line;
}

// Opens a line for stores; false where the words do not lie along the lanes.
inline bool open_line(LaneBlock& block, const MicroOperation& op, std::uint16_t anchor) {
    LaneLines& lines = *block.lines;
    close_line(block);
    const MemoryRegion& region = block.parts->memory->region(op.where + anchor);
    if (region.view().address_stride != 1) {
        return false;
    }
    Line& open = lines.open;
    open.base = op.a;
    open.bank = op.where;
    open.offset = line_offset(op.immediate);
    if (!find_line(block, open, anchor, lines.open_at.data())) {
        return false;
    }
    if (region.view().lane_stride == 0) {
        block.parts->memory->unshare(region);
    }
    open.lanes = block.awake;
    open.id = op.detail;
    return true;
}

// Gives lines to read what is being stored at `op`'s addresses, or forgets them.
template <bool kMasked>
HWY_INLINE void change_lines(LaneBlock& block, const MicroOperation& op) {
    LaneLines& lines = *block.lines;
    const Line& open = lines.open;
    const Words d;
    const std::uint16_t* const from = block.rows + op.b;
    for (std::uint32_t used = lines.used; used != 0; used &= used - 1) {
        const auto index = static_cast<std::size_t>(std::countr_zero(used));
        const Line& line = lines.lines[index];
        const int word = op.immediate - line.offset;
        const bool in_line = word >= 0 && word < kLineWords;
        std::uint16_t* const row =
            line.rows + static_cast<std::size_t>(in_line ? word : 0) * block.width;
        if (line.bank != open.bank || (line.base == open.base && !in_line)) {
            continue;
        }
        if (line.base == open.base) {
            each_vector<kMasked>(
                block, row, [&](std::size_t lane) HWY_ATTR { return hn::Load(d, from + lane); });
            continue;
        }
        if (!line.may_hold(open.bank, open.least, open.most + std::uint32_t{kLineWords - 1})) {
            continue;
        }
        const Relation& relation = relation_of(block, line.base, open.base);
        if (!relation.clear_of(-word, kLineWords - 1 - word)) {
            lines.forget(index);
        } else if (in_line) {
            each_vector<kMasked>(block, row, [&](std::size_t lane) HWY_ATTR {
                return hn::IfThenElse(load_bits(relation.equal, lane), hn::Load(d, from + lane),
                                      hn::Load(d, row + lane));
            });
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterloom::lockstep
HWY_AFTER_NAMESPACE();

#endif
