// SPDX-License-Identifier: MIT
// The sequencer of a lock-step array. It runs ahead of the lanes: it keeps a list of the pieces of
// program that it came through and has lanes computed only where it needs an answer from them or
// where they meet in the ring. Then each block of lanes goes through all the pieces at once.
//
// Every thread of the host has a sequencer of its own for its blocks; all of them come through
// the program alike and meet for answers and in the ring.
#pragma once

#include "machine/node/lockstep/block_runner.hpp"
#include "machine/node/lockstep/lane_state.hpp"
#include "machine/node/lockstep/lockstep_array.hpp"
#include "machine/node/lockstep/meeting.hpp"
#include "machine/node/lockstep/transfer.hpp"
#include "machine/node/lockstep/translation.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rasterloom::lockstep {

struct SequencerState {
    std::uint16_t program_counter = 0;
    std::uint16_t procedure = 0;
    std::array<std::uint16_t, isa::vliw::kCounters> counters{};
    std::array<std::uint16_t, isa::vliw::kCallDepth> returns{};
    std::size_t depth = 0;        // return addresses in use
    std::size_t ring_offset = 0;  // see Piece
    std::int64_t cycles = 0;      // since the start
    std::int64_t bundles = 0;
    std::int64_t operations = 0;
};

class Sequencer {
  public:
    using Stop = LockstepArray::Stop;
    using Reason = LockstepArray::Reason;

    Sequencer(const isa::vliw::Program& program, const Translation& translation, LaneState& lanes,
              Meeting& meeting, int member, std::span<LaneBlock> blocks,
              std::span<const Transfer> transfers);

    // Ends with all lanes computed, by all members.
    Stop run(std::int64_t budget_cycles);

    SequencerState& state() { return state_; }
    const SequencerState& state() const { return state_; }
    std::vector<std::int64_t> profile() const;

  private:
    // read_apart: by pieces between which the ring was shifted.
    enum class RingUse : std::uint8_t { none, read, read_apart, written };

    Stop run_to_stop(std::int64_t end);
    void run_plain(std::uint32_t end_bundle, std::int64_t end);
    std::optional<Stop> step(const isa::vliw::Bundle& bundle);
    std::optional<Stop> go_on(const isa::vliw::Bundle::Sequencer& seq, std::uint32_t answer);
    std::optional<Stop> trap(const isa::vliw::Bundle& bundle) const;
    bool branches(isa::vliw::SeqOp op, std::uint32_t answer) const;
    void push_return();

    // Puts micro-operations on the list.
    void add(std::uint32_t first_op, std::uint32_t end_op);
    void add_ring_use(isa::vliw::CommOp op);
    void count(std::uint32_t first_bundle, std::uint32_t end_bundle);
    // Empties the list. The answer is about the lanes as they then are.
    void compute_lanes();
    std::uint32_t meet_lanes();
    // Whether it could be done at once.
    bool hand_on(const Transfer& transfer);
    const Transfer* transfer_at(std::uint32_t bundle, std::int64_t end) const;
    std::size_t moved_right(std::size_t offset, std::int64_t places) const;
    void shift(std::int64_t places_right);
    void broadcast();

    const isa::vliw::Program* program_;
    const Translation* translation_;
    LaneState* lanes_;
    Meeting* meeting_;
    int member_;
    std::span<LaneBlock> blocks_;
    std::span<const Transfer> transfers_;
    SequencerState state_;
    std::vector<Piece> pieces_;
    RingUse ring_use_ = RingUse::none;  // by pieces on the list, or since the latest meeting
    std::size_t ring_use_offset_ = 0;
    FlightStand flight_;
    std::vector<std::int64_t> entries_;  // into bundles by address, less exits before them
};

}  // namespace rasterloom::lockstep
