// SPDX-License-Identifier: MIT
#include "machine/node/lockstep/transfer.hpp"

#include "machine/node/lockstep/kernels.hpp"

#include <algorithm>
#include <cstring>

namespace rasterloom::lockstep {
namespace {

// Pieces of a fixed size, which compilers make vectors of; the last one lies over the one before.
void copy(std::uint16_t* to, const std::uint16_t* from, int count) {
    constexpr int kPiece = 16;  // words
    if (count < kPiece) {
        for (int i = 0; i < count; ++i) {
            to[i] = from[i];
        }
        return;
    }
    for (int i = 0; i < count - kPiece; i += kPiece) {
        std::memcpy(to + i, from + i, kPiece * sizeof(*to));
    }
    std::memcpy(to + count - kPiece, from + count - kPiece, kPiece * sizeof(*to));
}

// Each lane's words at its pointer.
class Pointers {
  public:
    Pointers(const LaneBlock& block, int base, std::uint32_t bank, const Transfer& transfer)
        : row_(block.row(base)),
          region_(&block.parts->memory->region(bank + row_[0] +
                                               static_cast<std::uint32_t>(transfer.first_offset))),
          stride_(region_->view().lane_stride),
          words_(region_->view().words + block.index * region_->view().block_stride),
          back_(static_cast<std::ptrdiff_t>(region_->first()) - bank) {}

    std::uint16_t* operator()(std::size_t lane, int offset) const {
        return words_ + (static_cast<std::ptrdiff_t>(lane * stride_) + row_[lane] + offset - back_);
    }

  private:
    const std::uint16_t* row_;
    const MemoryRegion* region_;
    std::size_t stride_;
    std::uint16_t* words_;
    std::ptrdiff_t back_;
};

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

void lay_out(LaneBlock& block, const Transfer& transfer, std::span<std::uint16_t> laid_out,
             std::size_t ring_offset) {
    const std::size_t first_lane = block.index * block.width;
    std::uint16_t* const records = laid_out.data() + first_lane * kMaxTransferSlots;
    const Pointers from(block, transfer.load_base, transfer.load_bank, transfer);
    for (const TransferRun& run : transfer.loads) {
        std::uint16_t* to = records + run.slot;
        for (std::size_t lane = 0; lane < block.lanes; ++lane, to += kMaxTransferSlots) {
            copy(to, from(lane, run.offset), run.count);
        }
    }
    for (const Transfer::Word& word : transfer.laid_registers) {
        const std::uint16_t* const row = block.row(word.reg);
        std::uint16_t* to = records + word.slot;
        for (std::size_t lane = 0; lane < block.lanes; ++lane, to += kMaxTransferSlots) {
            *to = row[lane];
        }
    }
    auto& ring = *block.parts->ring;
    const std::uint16_t* put = records + transfer.last_put;
    std::size_t place = (ring_offset + first_lane) % ring.size();
    for (std::size_t lane = 0; lane < block.lanes; ++lane, put += kMaxTransferSlots) {
        ring[place] = *put;
        place = place + 1 == ring.size() ? 0 : place + 1;
    }
}

namespace {

// do_lanes(lane, record, lanes) for the block's lanes in one or more stretches, in each of which
// the records of the lanes `distance` to the left lie side by side.
template <class DoLanes>
void each_stretch(const LaneBlock& block, std::span<const std::uint16_t> laid_out,
                  std::int64_t distance, DoLanes do_lanes) {
    const auto ring = static_cast<std::int64_t>(block.parts->ring->size());
    const auto first = static_cast<std::int64_t>(block.index * block.width);
    auto neighbour = static_cast<std::size_t>(((first - distance) % ring + ring) % ring);
    for (std::size_t lane = 0; lane < block.lanes;) {
        const std::size_t lanes =
            std::min(block.lanes - lane, static_cast<std::size_t>(ring) - neighbour);
        do_lanes(lane, laid_out.data() + neighbour * kMaxTransferSlots, lanes);
        lane += lanes;
        neighbour = 0;
    }
}

void fill_registers(const LaneBlock& block, std::span<const Transfer::Word> words,
                    std::size_t first_lane, const std::uint16_t* records, std::size_t lanes) {
    for (const Transfer::Word& word : words) {
        std::uint16_t* const row = block.row(word.reg) + first_lane;
        const std::uint16_t* from = records + word.slot;
        for (std::size_t lane = 0; lane < lanes; ++lane, from += kMaxTransferSlots) {
            row[lane] = *from;
        }
    }
}

}  // namespace

void take_over(LaneBlock& block, const Transfer& transfer,
               std::span<const std::uint16_t> laid_out) {
    const Pointers to(block, transfer.store_base, transfer.store_bank, transfer);
    for (const auto& store : transfer.register_stores) {
        const std::uint16_t* const row = block.row(store.reg);
        for (std::size_t lane = 0; lane < block.lanes; ++lane) {
            *to(lane, store.offset) = row[lane];
        }
    }
    each_stretch(block, laid_out, transfer.distance,
                 [&](std::size_t first, const std::uint16_t* records, std::size_t lanes) {
                     for (const TransferRun& run : transfer.stores) {
                         const std::uint16_t* from = records + run.slot;
                         for (std::size_t i = 0; i < lanes; ++i, from += kMaxTransferSlots) {
                             copy(to(first + i, run.offset), from, run.count);
                         }
                     }
                     fill_registers(block, transfer.taken_registers, first, records, lanes);
                 });
    each_stretch(block, laid_out, 0,
                 [&](std::size_t first, const std::uint16_t* records, std::size_t lanes) {
                     fill_registers(block, transfer.own_registers, first, records, lanes);
                 });
    block.lines->forget_all();
}

}  // namespace rasterloom::lockstep
