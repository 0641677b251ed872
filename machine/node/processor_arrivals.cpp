// SPDX-License-Identifier: MIT
// What reaches a processor from outside, and the stalls that it ends.
#include "machine/node/processor.hpp"

#include <fmt/format.h>

namespace rasterloom {

bool Processor::stall_is_over() const {
    switch (stall_) {
        case Stall::none:
            return false;
        case Stall::transmit:
            return ports_.has_room(static_cast<int>(stall_argument_));
        case Stall::receive:
            return ports_.waiting(static_cast<int>(stall_argument_)) > 0;
        case Stall::wait_for:
            return wait_mask_holds(stall_argument_);
        case Stall::interrupt:
            return interrupt_requested_;
        case Stall::pixel:
            return pixel_written_;
    }
    return false;
}

// What ended the stall, or while it lasts what it is most likely to be.
NodeState Processor::kind_of_stall() const {
    switch (stall_) {
        case Stall::transmit:
        case Stall::pixel:
            return NodeState::waiting_output;
        case Stall::receive:
            return NodeState::waiting_input;
        case Stall::interrupt:
            return NodeState::waiting_interrupt;
        case Stall::none:
        case Stall::wait_for:
            break;
    }
    if ((stall_argument_ & kWaitMessage) != 0 && ports_.any_waiting()) {
        return NodeState::waiting_input;
    }
    if ((stall_argument_ & kWaitRoom & ports_.room()) != 0) {
        return NodeState::waiting_output;
    }
    if ((stall_argument_ & kWaitPhase) != 0) {
        return NodeState::waiting_phase;
    }
    return (stall_argument_ & kWaitRoom) != 0 ? NodeState::waiting_output
                                              : NodeState::waiting_input;
}

// What the processor waits for may come before it has got there, in its own time: then it never
// stalls. So a stall is told when time has passed in it.
void Processor::begin_stall_before(Time time) {
    if (stall_ != Stall::none && local_time_ < time) {
        meter_.begin_stall(local_time_, executed());
    }
}

void Processor::resume() {
    const NodeState was = kind_of_stall();
    const std::int64_t cycle = settings_.clock.edge_at_or_after(now()).count();
    if (cycle > cycle_) {
        begin_stall_before(now());
        bound_by_ = scheduler().handling();
        cycle_ = cycle;
        local_time_ = settings_.clock.edge(Cycles(cycle_));
        meter_.end_stall(was, local_time_, bound_by_);
    }
    stall_ = Stall::none;
    if (runs_freely() || (settings_.run_ahead && scheduler().advance_to(own_key(local_time_)))) {
        proceed();
    } else {
        wake_at(local_time_, 0);
    }
}

void Processor::handle_arrival(const Event& event) {
    if (event.port < supervisor_port()) {
        handle_message(event);
    } else if (settings_.supervised && event.port == supervisor_port()) {
        handle_phase(static_cast<std::uint16_t>(event.payload));
    } else {
        pixel_written_ = true;
    }
    if (stall_is_over()) {
        resume();
    }
}

void Processor::handle_message(const Event& event) {
    const int port = static_cast<int>(event.port) / 2;
    const PortState& state = port_states_[static_cast<std::size_t>(port)];
    switch (static_cast<MessageEvent>(event.kind)) {
        case MessageEvent::deliver:
            if (!ports_.deliver(port, delivered_message(event), now())) {
                throw InvariantError(now(), name(), fmt::format("input queue {} overflows", port));
            }
            tell_queue(id(), QueuePlace::input, 1);
            if (state.receive_interrupt && ports_.waiting(port) == 1) {
                request(receive_vector(port));
            }
            break;
        case MessageEvent::done:
            if (state.transmit_interrupt && !ports_.has_room(port)) {
                request(transmit_vector(port));
            }
            ports_.transfer_done(port, event.payload != 0, now());
            transmit();
            break;
        case MessageEvent::ready:
            ports_.link_ready(port, now());
            transmit();
            break;
        default:
            throw InvariantError(now(), name(), "an event that no node expects");
    }
}

void Processor::handle_phase(std::uint16_t phase) {
    phase_ = phase;
    if (phase != kRunOver) {
        begin_stall_before(now());
        meter_.begin_phase(now(), kind_of_stall());
    }
}

}  // namespace rasterloom
