// SPDX-License-Identifier: MIT
#include "machine/node/lockstep/flight.hpp"

#include "machine/node/lockstep/kernels.hpp"
#include "machine/node/lockstep/lane_block.hpp"

#include <algorithm>

namespace rasterloom::lockstep {
namespace {

// Each lane's words at its address.
class LaneWords {
  public:
    LaneWords(const LaneBlock& block, const std::uint16_t* addresses, std::uint32_t bank,
              int offset)
        : addresses_(addresses) {
        const MemoryRegion& region =
            block.parts->memory->region(bank + addresses[0] + static_cast<std::uint32_t>(offset));
        const MemoryView& view = region.view();
        stride_ = view.lane_stride;
        words_ = view.words + block.index * view.block_stride;
        back_ = static_cast<std::ptrdiff_t>(region.first()) - bank - offset;
    }

    std::uint16_t* operator()(std::size_t lane) const {
        return words_ + (static_cast<std::ptrdiff_t>(lane * stride_) + addresses_[lane] - back_);
    }

  private:
    const std::uint16_t* addresses_;
    std::size_t stride_ = 0;
    std::uint16_t* words_ = nullptr;
    std::ptrdiff_t back_ = 0;
};

// do_stretch(lane, place, count) for lanes whose places in a ring lie side by side.
template <class DoStretch>
void each_stretch(const LaneBlock& block, std::size_t offset, DoStretch do_stretch) {
    const std::size_t ring = block.parts->ring->size();
    const std::size_t place = (offset + block.index * block.width) % ring;
    const std::size_t until_end = std::min(block.lanes, ring - place);
    do_stretch(std::size_t{0}, place, until_end);
    do_stretch(until_end, std::size_t{0}, block.lanes - until_end);
}

std::size_t place_of(const LaneBlock& block, const FlightStand& stand, std::size_t lane) {
    return (stand.offset + block.index * block.width + lane) % block.parts->ring->size();
}

// Lane memory's record takes off, as if a transfer had brought it.
void take_off(Flight& flight, const Transfer& transfer, const FlightStand& stand, std::size_t place,
              const std::uint16_t* words) {
    std::copy_n(words, transfer.words, flight.record(place));
    for (std::size_t i = 0; i < transfer.sources.size(); ++i) {
        if (!transfer.sources[i].in_register) {
            flight.row(transfer, static_cast<int>(i), false)[place] =
                words[transfer.sources[i].number - transfer.first_offset];
        }
    }
    for (const auto& [source, offset] : transfer.handed) {
        flight.row(transfer, source, stand.second)[place] = words[offset - transfer.first_offset];
    }
}

void land_record(Flight& flight, const Flying& flying, std::size_t place, std::uint16_t* words) {
    const Transfer& transfer = *flying.transfer;
    std::copy_n(flight.record(place), transfer.words, words);
    for (const auto& [source, offset] : transfer.handed) {
        words[offset - transfer.first_offset] =
            flight.row(transfer, source, flying.stand.second)[place];
    }
}

bool lies_along(const LaneBlock& block, std::uint32_t bank, PointerRange range,
                const Transfer& transfer) {
    const std::uint32_t first = range.least + static_cast<std::uint32_t>(transfer.first_offset);
    const std::uint32_t last =
        range.most + static_cast<std::uint32_t>(transfer.first_offset + transfer.words) - 1;
    const MemoryRegion& region = block.parts->memory->region(bank + first);
    return last < isa::vliw::kBankWords &&
           block.parts->memory->extent(bank + first).holds(bank + last) &&
           region.view().address_stride == 1 && region.view().lane_stride > 1;
}

// Lanes that begin, go on with another record than the one that has come, or keep it where it is.
void change_records(LaneBlock& block, const Transfer& transfer, const FlightStand& stand) {
    Flying& flying = *block.flying;
    Flight& flight = *block.parts->flight;
    const std::uint16_t* const load = block.row(transfer.load_base);
    const std::uint16_t* const store = block.row(transfer.store_base);
    const LaneWords from(block, load, transfer.load_bank, transfer.first_offset);
    if (flying.transfer == nullptr) {
        for (std::size_t lane = 0; lane < block.lanes; ++lane) {
            take_off(flight, transfer, stand, place_of(block, stand, lane), from(lane));
        }
        return;
    }
    const LaneWords at(block, flying.at.data(), transfer.store_bank, transfer.first_offset);
    constexpr std::size_t kTogether = 32;
    for (std::size_t first = 0; first < block.lanes; first += kTogether) {
        std::uint16_t differs = 0;
        for (std::size_t lane = first; lane < first + kTogether; ++lane) {
            const std::uint16_t here = flying.at[lane];
            differs =
                static_cast<std::uint16_t>(differs | (load[lane] ^ here) | (store[lane] ^ here));
        }
        if (differs == 0) {
            continue;
        }
        for (std::size_t lane = first; lane < std::min(first + kTogether, block.lanes); ++lane) {
            const std::uint16_t here = flying.at[lane];
            const std::size_t place = place_of(block, stand, lane);
            if (load[lane] != here || store[lane] != here) {
                land_record(flight, flying, place, at(lane));
            }
            if (load[lane] != here) {
                take_off(flight, transfer, stand, place, from(lane));
                flying.at[lane] = load[lane];
            }
        }
    }
}

}  // namespace

void Flight::reserve(std::size_t lanes, std::span<const Transfer> transfers) {
    std::size_t sources = 0;
    for (const Transfer& transfer : transfers) {
        sources = std::max(sources, transfer.sources.size());
    }
    if (sources != 0) {
        lanes_ = lanes;
        records_.resize(lanes * kMostRecordWords);
        rows_.resize(lanes * 2 * sources);
    }
}

bool can_board(const LaneBlock& block, const Transfer& transfer) {
    if (!block.all_awake) {
        return false;
    }
    const PointerCheck check = check_pointers(block, transfer.load_base, transfer.store_base);
    return lies_along(block, transfer.load_bank, check.first, transfer) &&
           lies_along(block, transfer.store_bank, check.second, transfer) &&
           (transfer.load_bank != transfer.store_bank || check.nearest >= transfer.words);
}

void board(LaneBlock& block, const Transfer& transfer, const FlightStand& stand) {
    Flying& flying = *block.flying;
    Flight& flight = *block.parts->flight;
    // A lane loads what has come to it only if it is in the bank that it loads from.
    if (flying.transfer != &transfer || transfer.load_bank != transfer.store_bank) {
        land(block);
    }
    change_records(block, transfer, stand);
    for (std::size_t i = 0; i < transfer.sources.size(); ++i) {
        if (transfer.sources[i].in_register) {
            const std::uint16_t* const from = block.row(transfer.sources[i].number);
            std::uint16_t* const to = flight.row(transfer, static_cast<int>(i), !stand.second);
            each_stretch(block, stand.offset, [&](auto lane, auto place, auto count) {
                std::copy_n(from + lane, count, to + place);
            });
        }
    }
    flying.own.resize((transfer.own_results.size() + 1) * block.width);
    std::uint16_t* to = flying.own.data();
    const auto keep = [&](int source) {
        const std::uint16_t* const from = flight.row(transfer, source, !stand.second);
        each_stretch(block, stand.offset, [&](auto lane, auto place, auto count) {
            std::copy_n(from + place, count, to + lane);
        });
        to += block.width;
    };
    for (const Transfer::Result& result : transfer.own_results) {
        keep(result.source);
    }
    keep(transfer.last_put);
}

void arrive(LaneBlock& block, const Transfer& transfer, const FlightStand& after,
            std::size_t ring_offset) {
    Flying& flying = *block.flying;
    Flight& flight = *block.parts->flight;
    const std::uint16_t* own = flying.own.data();
    for (const Transfer::Result& result : transfer.own_results) {
        std::copy_n(own, block.lanes, block.row(result.reg));
        own += block.width;
    }
    each_stretch(block, ring_offset, [&](auto lane, auto place, auto count) {
        std::copy_n(own + lane, count, block.parts->ring->data() + place);
    });
    for (const Transfer::Result& result : transfer.taken_results) {
        const std::uint16_t* const from = flight.row(transfer, result.source, after.second);
        std::uint16_t* const to = block.row(result.reg);
        each_stretch(block, after.offset, [&](auto lane, auto place, auto count) {
            std::copy_n(from + place, count, to + lane);
        });
    }
    std::copy_n(block.row(transfer.store_base), block.width, flying.at.data());
    flying.transfer = &transfer;
    flying.stand = after;
    block.lines->forget_all();
}

void land(LaneBlock& block) {
    Flying& flying = *block.flying;
    if (flying.transfer == nullptr) {
        return;
    }
    const LaneWords at(block, flying.at.data(), flying.transfer->store_bank,
                       flying.transfer->first_offset);
    for (std::size_t lane = 0; lane < block.lanes; ++lane) {
        land_record(*block.parts->flight, flying, place_of(block, flying.stand, lane), at(lane));
    }
    flying.transfer = nullptr;
}

}  // namespace rasterloom::lockstep
