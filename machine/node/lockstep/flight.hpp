// SPDX-License-Identifier: MIT
// Records that lanes hand on through the ring. Most are handed on again and again before anybody
// looks at them, so they are not copied from lane memory to lane memory: they fly. A record in
// flight has a place; where a transfer hands all records on, lane i finds its new one one place
// further, which is a change of one number. Lane memory has the record as soon as something else
// than a transfer would find it there: then the block of lanes lands.
//
// Words that somebody looks at - registers that end with one, the ring - have rows of their own,
// a place beside the other.
#pragma once

#include "machine/node/lockstep/lane_lines.hpp"
#include "machine/node/lockstep/transfer.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rasterloom::lockstep {

struct LaneBlock;

// Of all lanes; each thread touches the places of its own lanes only, which change with each
// transfer.
class Flight {
  public:
    // Places for so many lanes' records of any of the transfers.
    void reserve(std::size_t lanes, std::span<const Transfer> transfers);

    std::uint16_t* record(std::size_t place) { return records_.data() + place * kMostRecordWords; }
    // A source's words by place. What comes from registers has two rows: of records as they have
    // come, and as they are to be handed on.
    std::uint16_t* row(const Transfer& transfer, int source, bool second) {
        const auto index = static_cast<std::size_t>(source);
        const bool changes = transfer.sources[index].in_register;
        return rows_.data() + (index * 2 + (changes && second ? 1 : 0)) * lanes_;
    }

  private:
    std::size_t lanes_ = 0;
    std::vector<std::uint16_t> records_;
    std::vector<std::uint16_t> rows_;
};

// How the flight stands, for all lanes alike.
struct FlightStand {
    std::size_t offset = 0;  // place of lane 0's record
    bool second = false;     // which of two rows has words of records as they have come
};

// Of a block: all its lanes have a record in flight, or none.
struct Flying {
    const Transfer* transfer = nullptr;  // by which they came; none: there are none
    FlightStand stand;
    // First words' addresses in the bank, less the first offset.
    alignas(64) std::array<std::uint16_t, kMaxWidth> at{};
    std::vector<std::uint16_t> own;  // rows of words that were the lanes' own, the ring's last
};

// Whether all records of the block can be handed on at once: all lanes awake, all words along the
// lanes, no word stored where another is still to be loaded.
bool can_board(const LaneBlock& block, const Transfer& transfer);
// The two halves; between them all blocks have to be through the first. If they are not to go on
// then, nothing has happened. `after`: how the flight stands after the transfer. `ring_offset`:
// as in Piece, at the last put.
void board(LaneBlock& block, const Transfer& transfer, const FlightStand& stand);
void arrive(LaneBlock& block, const Transfer& transfer, const FlightStand& after,
            std::size_t ring_offset);
// Brings the block's records into lane memory.
void land(LaneBlock& block);

}  // namespace rasterloom::lockstep
