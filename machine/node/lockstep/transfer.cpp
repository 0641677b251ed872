// SPDX-License-Identifier: MIT
#include "machine/node/lockstep/transfer.hpp"

#include "machine/node/lockstep/kernels.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>

namespace rasterloom::lockstep {
namespace {

// Words that compilers copy by vectors.
constexpr int kPiece = 16;

// The last piece lies over the one before.
template <int kWholePieces>
void copy_pieces(std::uint16_t* to, const std::uint16_t* from, int count) {
    for (int i = 0; i < kWholePieces * kPiece; i += kPiece) {
        std::memcpy(to + i, from + i, kPiece * sizeof(*to));
    }
    std::memcpy(to + count - kPiece, from + count - kPiece, kPiece * sizeof(*to));
}

void copy_words(std::uint16_t* to, const std::uint16_t* from, int count) {
    for (int i = 0; i < count; ++i) {
        to[i] = from[i];
    }
}

using Copy = void (*)(std::uint16_t*, const std::uint16_t*, int);

// Each lane's words at its pointer.
class Pointers {
  public:
    Pointers(const LaneBlock& block, int base, std::uint32_t bank, const Transfer& transfer)
        : row_(block.row(base)) {
        const MemoryRegion& region = block.parts->memory->region(
            bank + row_[0] + static_cast<std::uint32_t>(transfer.first_offset));
        stride_ = region.view().lane_stride;
        words_ = region.view().words + block.index * region.view().block_stride;
        back_ = static_cast<std::ptrdiff_t>(region.first()) - bank;
    }

    std::uint16_t* operator()(std::size_t lane, int offset) const {
        return words_ + (static_cast<std::ptrdiff_t>(lane * stride_) + row_[lane] + offset - back_);
    }

  private:
    const std::uint16_t* row_;
    std::size_t stride_ = 0;
    std::uint16_t* words_ = nullptr;
    std::ptrdiff_t back_ = 0;
};

Pointers load_pointers(const LaneBlock& block, const Transfer& transfer) {
    return {block, transfer.load_base, transfer.load_bank, transfer};
}
Pointers store_pointers(const LaneBlock& block, const Transfer& transfer) {
    return {block, transfer.store_base, transfer.store_bank, transfer};
}

bool lies_along(const LaneBlock& block, std::uint32_t bank, PointerRange range,
                const Transfer& transfer) {
    const std::uint32_t first = range.least + static_cast<std::uint32_t>(transfer.first_offset);
    const std::uint32_t last = range.most + static_cast<std::uint32_t>(transfer.last_offset);
    const MemoryRegion& region = block.parts->memory->region(bank + first);
    return last < isa::vliw::kBankWords &&
           block.parts->memory->extent(bank + first).holds(bank + last) &&
           region.view().address_stride == 1 && region.view().lane_stride > 1;
}

}  // namespace

bool can_transfer(LaneBlock& block, const Transfer& transfer) {
    if (!block.all_awake) {
        return false;
    }
    const PointerCheck check = check_pointers(block, transfer.load_base, transfer.store_base);
    const int span = transfer.last_offset - transfer.first_offset;
    return lies_along(block, transfer.load_bank, check.first, transfer) &&
           lies_along(block, transfer.store_bank, check.second, transfer) &&
           (transfer.load_bank != transfer.store_bank || check.nearest > span);
}

namespace {

using Source = Transfer::Source;

// do_lane(lane) for `count` lanes from `first` on, upwards or downwards.
template <class DoLane>
void each_lane(std::size_t first, std::size_t count, bool downwards, DoLane do_lane) {
    if (downwards) {
        for (std::size_t lane = first + count; lane-- > first;) {
            do_lane(lane);
        }
    } else {
        for (std::size_t lane = first; lane < first + count; ++lane) {
            do_lane(lane);
        }
    }
}

// Words come from a lane that has not yet taken its own neighbour's if lanes take theirs in the
// contrary of the direction in which words travel.
bool goes_downwards(const Transfer& transfer) {
    return transfer.distance > 0;
}

// Lanes whose neighbours' words lie in one block, or in what has been laid out.
struct Stretch {
    const LaneBlock* block = nullptr;
    std::size_t first = 0;  // lane of the block
    std::size_t count = 0;
    const LaneBlock* neighbours = nullptr;  // block; none: laid out
    std::size_t first_neighbour = 0;        // lane of that block; of the array, if laid out
};

// At the most so many lanes: what they read and write stays in the host's nearest cache.
constexpr std::size_t kMostTogether = 64;

class Taker {
  public:
    Taker(std::span<const LaneBlock> blocks, const Transfer& transfer,
          std::span<const std::uint16_t> laid_out, std::size_t ring_offset)
        : blocks_(blocks), transfer_(transfer), laid_out_(laid_out), ring_offset_(ring_offset) {}

    void take_all() {
        std::vector<Stretch> stretches;
        for (const LaneBlock& block : blocks_) {
            for (std::size_t lane = 0; lane < block.lanes;) {
                stretches.push_back(stretch_from(block, lane));
                lane += stretches.back().count;
            }
        }
        if (goes_downwards(transfer_)) {
            std::reverse(stretches.begin(), stretches.end());
        }
        for (const Stretch& stretch : stretches) {
            take(stretch);
        }
    }

  private:
    Stretch stretch_from(const LaneBlock& block, std::size_t lane) const {
        const std::size_t width = block.width;
        const auto ring = static_cast<std::int64_t>(block.parts->ring->size());
        const auto place = static_cast<std::int64_t>(block.index * width + lane);
        // Neighbours beyond the ring's end or start are others' or are laid out, too.
        const std::int64_t neighbour = place - transfer_.distance;
        const auto first = static_cast<std::int64_t>(blocks_.front().index * width);
        const auto end =
            static_cast<std::int64_t>(blocks_.back().index * width + blocks_.back().lanes);
        Stretch stretch{&block, lane, std::min(block.lanes - lane, kMostTogether)};
        const auto shorten = [&stretch](std::int64_t most) {
            stretch.count = std::min(stretch.count, static_cast<std::size_t>(most));
        };
        if (neighbour >= first && neighbour < end) {
            const auto index = static_cast<std::size_t>(neighbour - first);
            stretch.neighbours = &blocks_[index / width];
            stretch.first_neighbour = index % width;
            shorten(static_cast<std::int64_t>(stretch.neighbours->lanes - index % width));
        } else {
            const std::int64_t around = (neighbour + ring) % ring;
            stretch.first_neighbour = static_cast<std::size_t>(around);
            shorten(ring - around);
            if (neighbour < first) {
                shorten(first - neighbour);
            }
        }
        return stretch;
    }

    void find_places(const Stretch& stretch) {
        const Pointers own = load_pointers(*stretch.block, transfer_);
        const Pointers to = store_pointers(*stretch.block, transfer_);
        for (std::size_t i = 0; i < stretch.count; ++i) {
            own_[i] = own(stretch.first + i, 0);
            to_[i] = to(stretch.first + i, 0);
        }
        if (stretch.neighbours != nullptr) {
            const Pointers from = load_pointers(*stretch.neighbours, transfer_);
            for (std::size_t i = 0; i < stretch.count; ++i) {
                from_[i] = from(stretch.first_neighbour + i, 0);
            }
        }
    }

    // do_word(i, word) for each lane of the stretch, with the lane's own word of the source.
    template <class DoWord>
    void each_own(const Stretch& stretch, int source, DoWord do_word) const {
        const auto [in_register, number] = transfer_.sources[static_cast<std::size_t>(source)];
        if (in_register) {
            each_of(stretch.block->row(number) + stretch.first, 1, stretch.count, do_word);
        } else {
            each_at(own_, number, stretch.count, do_word);
        }
    }
    // The same with the neighbour's.
    template <class DoWord>
    void each_taken(const Stretch& stretch, int source, DoWord do_word) const {
        const auto [in_register, number] = transfer_.sources[static_cast<std::size_t>(source)];
        if (stretch.neighbours == nullptr) {
            each_of(laid_out_.data() + stretch.first_neighbour * kMaxTransferWords +
                        static_cast<std::size_t>(source),
                    kMaxTransferWords, stretch.count, do_word);
        } else if (in_register) {
            each_of(stretch.neighbours->row(number) + stretch.first_neighbour, 1, stretch.count,
                    do_word);
        } else {
            each_at(from_, number, stretch.count, do_word);
        }
    }
    template <class DoWord>
    static void each_of(const std::uint16_t* words, std::size_t stride, std::size_t count,
                        DoWord do_word) {
        for (std::size_t i = 0; i < count; ++i) {
            do_word(i, words[i * stride]);
        }
    }
    template <class DoWord>
    static void each_at(const auto& places, std::ptrdiff_t offset, std::size_t count,
                        DoWord do_word) {
        for (std::size_t i = 0; i < count; ++i) {
            do_word(i, places[i][offset]);
        }
    }

    auto store_at(std::ptrdiff_t offset) const {
        return [this, offset](std::size_t i, std::uint16_t word) { to_[i][offset] = word; };
    }

    void take(const Stretch& stretch) {
        find_places(stretch);
        fill_ring(stretch);
        find_results(stretch);
        for (const auto& [reg, offset] : transfer_.register_stores) {
            each_of(stretch.block->row(reg) + stretch.first, 1, stretch.count, store_at(offset));
        }
        if (stretch.neighbours != nullptr) {
            move(stretch);
        } else {
            for (const auto& [source, offset] : transfer_.stores) {
                each_taken(stretch, source, store_at(offset));
            }
        }
        keep_results(stretch);
    }

    void move(const Stretch& stretch) const {
        if (transfer_.moves.size() == 1) {
            const int count = transfer_.moves.front().count;
            switch (count < kPiece ? -1 : (count - 1) / kPiece) {
                case 0:
                    move_by<copy_pieces<0>>(stretch);
                    break;
                case 1:
                    move_by<copy_pieces<1>>(stretch);
                    break;
                case 2:
                    move_by<copy_pieces<2>>(stretch);
                    break;
                case 3:
                    move_by<copy_pieces<3>>(stretch);
                    break;
                default:
                    move_by<copy_words>(stretch);
            }
        } else {
            move_by<copy_words>(stretch);
        }
        for (const auto& [reg, offset] : transfer_.handed) {
            each_of(stretch.neighbours->row(reg) + stretch.first_neighbour, 1, stretch.count,
                    store_at(offset));
        }
    }
    // All moves of a lane before those of the next one, which may be its neighbour.
    template <Copy kCopy>
    void move_by(const Stretch& stretch) const {
        each_lane(0, stretch.count, goes_downwards(transfer_), [&](std::size_t i) {
            for (const auto& [from, to, count] : transfer_.moves) {
                kCopy(to_[i] + to, from_[i] + from, count);
            }
        });
    }

    void fill_ring(const Stretch& stretch) const {
        auto& ring = *stretch.block->parts->ring;
        const std::size_t width = stretch.block->width;
        std::size_t place =
            (ring_offset_ + stretch.block->index * width + stretch.first) % ring.size();
        each_own(stretch, transfer_.last_put, [&](std::size_t, std::uint16_t word) {
            ring[place] = word;
            place = place + 1 == ring.size() ? 0 : place + 1;
        });
    }

    // Registers' values wait until nobody reads what registers and memory had before.
    void find_results(const Stretch& stretch) {
        std::uint16_t* to = results_.data();
        for (const Transfer::Result& result : transfer_.own_results) {
            each_own(stretch, result.source,
                     [to](std::size_t i, std::uint16_t word) { to[i] = word; });
            to += kMostTogether;
        }
        for (const Transfer::Result& result : transfer_.taken_results) {
            each_taken(stretch, result.source,
                       [to](std::size_t i, std::uint16_t word) { to[i] = word; });
            to += kMostTogether;
        }
    }
    void keep_results(const Stretch& stretch) const {
        const std::uint16_t* from = results_.data();
        for (const auto* results : {&transfer_.own_results, &transfer_.taken_results}) {
            for (const Transfer::Result& result : *results) {
                std::copy_n(from, stretch.count, stretch.block->row(result.reg) + stretch.first);
                from += kMostTogether;
            }
        }
    }

    std::span<const LaneBlock> blocks_;
    const Transfer& transfer_;
    std::span<const std::uint16_t> laid_out_;
    std::size_t ring_offset_;
    // Where the pointers of a stretch's lanes point to, and its neighbours' of those to load by.
    std::array<const std::uint16_t*, kMostTogether> own_;
    std::array<const std::uint16_t*, kMostTogether> from_;
    std::array<std::uint16_t*, kMostTogether> to_;
    std::array<std::uint16_t, isa::vliw::kRegisters * kMostTogether> results_;
};

}  // namespace

void lay_out(std::span<const LaneBlock> blocks, const Transfer& transfer,
             std::span<std::uint16_t> laid_out) {
    const std::size_t width = blocks.front().width;
    const std::size_t first = blocks.front().index * width;
    const std::size_t end = blocks.back().index * width + blocks.back().lanes;
    const std::size_t count =
        std::min(end - first, static_cast<std::size_t>(std::abs(transfer.distance)));
    const std::size_t begin = goes_downwards(transfer) ? end - count : first;
    for (std::size_t place = begin; place < begin + count; ++place) {
        const LaneBlock& block = blocks[(place - first) / width];
        const std::size_t lane = (place - first) % width;
        const Pointers from = load_pointers(block, transfer);
        std::uint16_t* to = laid_out.data() + place * kMaxTransferWords;
        for (const auto& [in_register, number] : transfer.sources) {
            *to++ = in_register ? block.row(number)[lane] : *from(lane, number);
        }
    }
}

void take_over(std::span<const LaneBlock> blocks, const Transfer& transfer,
               std::span<const std::uint16_t> laid_out, std::size_t ring_offset) {
    Taker(blocks, transfer, laid_out, ring_offset).take_all();
    for (const LaneBlock& block : blocks) {
        block.lines->forget_all();
    }
}

}  // namespace rasterloom::lockstep
