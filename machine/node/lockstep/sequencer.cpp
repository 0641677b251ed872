// SPDX-License-Identifier: MIT
#include "machine/node/lockstep/sequencer.hpp"

#include "machine/node/lockstep/broadcast.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include <fmt/format.h>

namespace rasterloom::lockstep {
namespace {

using isa::vliw::Bundle;
using isa::vliw::CommOp;
using isa::vliw::SeqOp;

// Bits that members say about their lanes.
constexpr std::uint32_t kAnySet = 1;      // T on a lane that is awake
constexpr std::uint32_t kAnyClear = 2;    // no T on a lane that is awake
constexpr std::uint32_t kFirstSet = 4;    // T on lane 0
constexpr std::uint32_t kNoTransfer = 8;  // a block cannot hand its words on at once

// Pieces on the list, at the most: a list is to stay in the host's caches.
constexpr std::size_t kMaxPieces = 256;

bool asks_lanes(const Bundle& bundle) {
    return (bundle.seq.op >= SeqOp::bt && bundle.seq.op <= SeqOp::bnand) ||
           bundle.seq.op == SeqOp::ldc || bundle.comm.op == CommOp::cast;
}

LockstepArray::Stop stop_for(LockstepArray::Reason reason) {
    LockstepArray::Stop stop;
    stop.reason = reason;
    return stop;
}

LockstepArray::Stop trap_for(std::string trap) {
    LockstepArray::Stop stop = stop_for(LockstepArray::Reason::trap);
    stop.trap = std::move(trap);
    return stop;
}

}  // namespace

Sequencer::Sequencer(const isa::vliw::Program& program, const Translation& translation,
                     LaneState& lanes, Meeting& meeting, int member, std::span<LaneBlock> blocks,
                     std::span<const Transfer> transfers)
    : program_(&program),
      translation_(&translation),
      lanes_(&lanes),
      meeting_(&meeting),
      member_(member),
      blocks_(blocks),
      transfers_(transfers),
      entries_(program.bundles.size() + 1) {
    state_.program_counter = program.entry;
    pieces_.reserve(kMaxPieces);
}

Sequencer::Stop Sequencer::run(std::int64_t budget_cycles) {
    const std::int64_t start = state_.cycles;
    Stop stop = run_to_stop(start + budget_cycles);
    compute_lanes();
    for (LaneBlock& block : blocks_) {
        end_run(block, kernels());
    }
    meet_lanes();
    stop.cycles = state_.cycles - start;
    return stop;
}

Sequencer::Stop Sequencer::run_to_stop(std::int64_t end) {
    while (state_.cycles < end) {
        const std::uint32_t at = state_.program_counter;
        if (at >= translation_->bundles()) {
            return trap_for(fmt::format("no bundle at address {}", at));
        }
        if (const Transfer* transfer = transfer_at(at, end);
            transfer != nullptr && hand_on(*transfer)) {
            continue;
        }
        if (const std::uint32_t plain = translation_->plain_end(at); plain > at) {
            run_plain(plain, end);
        } else if (auto stop = step(program_->bundles[at])) {
            return *stop;
        }
    }
    return stop_for(Reason::budget);
}

void Sequencer::run_plain(std::uint32_t end_bundle, std::int64_t end) {
    const std::uint32_t first = state_.program_counter;
    const std::int64_t off = state_.cycles - translation_->cycles_before(first);
    while (translation_->cycles_before(end_bundle - 1) + off >= end) {
        --end_bundle;  // it would begin after the budget's end
    }
    add(translation_->first_operation(first), translation_->first_operation(end_bundle));
    count(first, end_bundle);
    state_.program_counter = static_cast<std::uint16_t>(end_bundle);
}

void Sequencer::count(std::uint32_t first_bundle, std::uint32_t end_bundle) {
    state_.cycles +=
        translation_->cycles_before(end_bundle) - translation_->cycles_before(first_bundle);
    state_.operations +=
        translation_->slots_before(end_bundle) - translation_->slots_before(first_bundle);
    state_.bundles += end_bundle - first_bundle;
    ++entries_[first_bundle];
    --entries_[end_bundle];
}

std::vector<std::int64_t> Sequencer::profile() const {
    std::vector<std::int64_t> executed(entries_.size() - 1);
    std::partial_sum(entries_.begin(), entries_.end() - 1, executed.begin());
    return executed;
}

void Sequencer::add(std::uint32_t first_op, std::uint32_t end_op) {
    if (first_op == end_op) {
        return;
    }
    const std::int64_t off = state_.cycles - translation_->cycles_before(state_.program_counter);
    if (!pieces_.empty()) {
        Piece& last = pieces_.back();
        if (last.end == first_op && last.cycles_off == off &&
            last.ring_offset == state_.ring_offset) {
            last.end = end_op;
            return;
        }
    }
    if (pieces_.size() == kMaxPieces) {
        compute_lanes();
    }
    pieces_.push_back({first_op, end_op, off, state_.ring_offset});
}

// Between a lane's put and another's get all lanes have to be computed, and between a get and the
// next put that would overwrite what was to be got.
void Sequencer::add_ring_use(CommOp op) {
    if (op != CommOp::put && op != CommOp::get) {
        return;
    }
    const bool write = op == CommOp::put;
    const bool elsewhere = ring_use_ != RingUse::none && ring_use_offset_ != state_.ring_offset;
    if (ring_use_ == RingUse::written ? elsewhere
                                      : write && (elsewhere || ring_use_ == RingUse::read_apart)) {
        meet_lanes();
    }
    if (write) {
        ring_use_ = RingUse::written;
    } else if (ring_use_ == RingUse::none) {
        ring_use_ = RingUse::read;
    } else if (ring_use_ == RingUse::read && elsewhere) {
        ring_use_ = RingUse::read_apart;
    }
    ring_use_offset_ = state_.ring_offset;
}

void Sequencer::compute_lanes() {
    const Kernels& variants = kernels();
    for (LaneBlock& block : blocks_) {
        run_pieces(block, pieces_, *translation_, variants);
    }
    pieces_.clear();
}

std::uint32_t Sequencer::meet_lanes() {
    compute_lanes();
    std::uint64_t set = 0;
    std::uint64_t clear = 0;
    for (const LaneBlock& block : blocks_) {
        for (std::size_t word = 0; word < block.bit_words(); ++word) {
            set |= block.test[word] & block.awake[word];
            clear |= ~block.test[word] & block.awake[word];
        }
    }
    std::uint32_t answer = (set != 0 ? kAnySet : 0) | (clear != 0 ? kAnyClear : 0);
    if (member_ == 0 && (blocks_.front().test.front() & 1U) != 0) {
        answer |= kFirstSet;
    }
    ring_use_ = RingUse::none;
    return meeting_->exchange(member_, answer);
}

std::optional<Sequencer::Stop> Sequencer::trap(const Bundle& bundle) const {
    const SeqOp op = bundle.seq.op;
    if ((op == SeqOp::call || op == SeqOp::callp) && state_.depth == state_.returns.size()) {
        return trap_for("call stack is full");
    }
    if (op == SeqOp::ret && state_.depth == 0) {
        return trap_for("call stack is empty");
    }
    return std::nullopt;
}

std::optional<Sequencer::Stop> Sequencer::step(const Bundle& bundle) {
    if (auto stop = trap(bundle)) {
        return stop;
    }
    const std::uint32_t at = state_.program_counter;
    std::uint32_t first_op = translation_->first_operation(at);
    std::uint32_t answer = 0;
    if (asks_lanes(bundle)) {
        add(first_op, translation_->after_waking(at));
        first_op = translation_->after_waking(at);
        answer = meet_lanes();
        if (bundle.seq.op == SeqOp::ldc) {
            state_.counters[bundle.seq.counter] = lanes_->ring[state_.ring_offset];
            meet_lanes();  // nobody puts before all have looked
        }
        if (bundle.comm.op == CommOp::cast) {
            broadcast();
        }
    }
    add_ring_use(bundle.comm.op);
    add(first_op, translation_->first_operation(at + 1));
    count(at, at + 1);
    if (bundle.comm.op == CommOp::right || bundle.comm.op == CommOp::left) {
        shift(bundle.comm.op == CommOp::right ? bundle.comm.count : -bundle.comm.count);
    }
    return go_on(bundle.seq, answer);
}

// What moves right is found further left than before.
std::size_t Sequencer::moved_right(std::size_t offset, std::int64_t places) const {
    const auto ring = static_cast<std::int64_t>(lanes_->ring.size());
    const std::int64_t moved = (static_cast<std::int64_t>(offset) - places) % ring;
    return static_cast<std::size_t>(moved < 0 ? moved + ring : moved);
}

void Sequencer::shift(std::int64_t places_right) {
    state_.ring_offset = moved_right(state_.ring_offset, places_right);
}

const Transfer* Sequencer::transfer_at(std::uint32_t bundle, std::int64_t end) const {
    const auto found = std::lower_bound(
        transfers_.begin(), transfers_.end(), bundle,
        [](const Transfer& transfer, std::uint32_t at) { return transfer.first_bundle < at; });
    if (found == transfers_.end() || found->first_bundle != bundle) {
        return nullptr;
    }
    const std::int64_t cycles =
        translation_->cycles_before(found->end_bundle) - translation_->cycles_before(bundle);
    return state_.cycles + cycles <= end ? &*found : nullptr;
}

bool Sequencer::hand_on(const Transfer& transfer) {
    compute_lanes();
    bool can = std::abs(transfer.distance) < lanes_->lanes();
    for (LaneBlock& block : blocks_) {
        kernels().full[kCloseLine](block, {});
        can = can && can_board(block, transfer);
    }
    for (LaneBlock& block : blocks_) {
        if (can) {
            board(block, transfer, flight_);
        }
    }
    const std::uint32_t answer = meeting_->exchange(member_, can ? 0 : kNoTransfer);
    ring_use_ = RingUse::none;
    if ((answer & kNoTransfer) != 0) {
        return false;
    }
    ring_use_ = RingUse::written;
    ring_use_offset_ = moved_right(state_.ring_offset, transfer.shift_before_put);
    flight_ = {moved_right(flight_.offset, transfer.distance), !flight_.second};
    for (LaneBlock& block : blocks_) {
        arrive(block, transfer, flight_, ring_use_offset_);
    }
    add(translation_->first_work(transfer), translation_->end_work(transfer));
    count(transfer.first_bundle, transfer.end_bundle);
    shift(transfer.shift);
    state_.program_counter = static_cast<std::uint16_t>(transfer.end_bundle);
    return true;
}

void Sequencer::broadcast() {
    if (member_ == 0) {
        broadcast_communication(*lanes_, state_.ring_offset);
    }
    meet_lanes();
}

bool Sequencer::branches(SeqOp op, std::uint32_t answer) const {
    switch (op) {
        case SeqOp::bt:
            return (answer & kFirstSet) != 0;
        case SeqOp::bf:
            return (answer & kFirstSet) == 0;
        case SeqOp::bor:
            return (answer & kAnySet) != 0;
        case SeqOp::bnor:
            return (answer & kAnySet) == 0;
        case SeqOp::band:
            return (answer & kAnyClear) == 0;
        default:  // bnand
            return (answer & kAnyClear) != 0;
    }
}

void Sequencer::push_return() {
    state_.returns[state_.depth++] = static_cast<std::uint16_t>(state_.program_counter + 1);
}

std::optional<Sequencer::Stop> Sequencer::go_on(const Bundle::Sequencer& seq,
                                                std::uint32_t answer) {
    auto next = static_cast<std::uint16_t>(state_.program_counter + 1);
    std::optional<Stop> stop;
    switch (seq.op) {
        case SeqOp::none:
        case SeqOp::ldc:
            break;
        case SeqOp::halt:
            stop = stop_for(Reason::halt);
            break;
        case SeqOp::jump:
            next = seq.target;
            break;
        case SeqOp::call:
            push_return();
            next = seq.target;
            break;
        case SeqOp::callp:
            push_return();
            next = state_.procedure;
            break;
        case SeqOp::ret:
            next = state_.returns[--state_.depth];
            break;
        case SeqOp::setc:
            state_.counters[seq.counter] = seq.target;
            break;
        case SeqOp::dec:
            next = --state_.counters[seq.counter] != 0 ? seq.target : next;
            break;
        case SeqOp::setp:
            state_.procedure = seq.target;
            break;
        case SeqOp::line:
            next = 0;
            state_.depth = 0;
            stop = stop_for(Reason::line);
            break;
        case SeqOp::frame:
            stop = stop_for(Reason::frame);
            break;
        case SeqOp::phase:
            stop = stop_for(Reason::phase);
            stop->phase = seq.target;
            break;
        default:
            next = branches(seq.op, answer) ? seq.target : next;
    }
    state_.program_counter = next;
    return stop;
}

}  // namespace rasterloom::lockstep
