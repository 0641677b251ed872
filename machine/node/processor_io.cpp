// SPDX-License-Identifier: MIT
// The processor as its core's bus: what the registers of programs/README.md do.
#include "machine/node/processor.hpp"

#include <fmt/format.h>

namespace rasterloom {

// Registers that say nothing about the rest of the machine, so that the core may run on with them.
bool Processor::needs_exact_time(const RegisterAddress& address, bool writes) {
    if (address.port) {
        return static_cast<PortRegister>(address.offset) != PortRegister::txaddr;
    }
    switch (static_cast<NodeRegister>(address.offset)) {
        case NodeRegister::node:
        case NodeRegister::ports:
            return false;
        case NodeRegister::credit:
        case NodeRegister::mark:
            return !writes;
        default:
            return true;
    }
}

// A message that waits now still does at the core's own time.
bool Processor::is_known_to_wait(int port) const {
    return ports_.receives(port) && ports_.waiting(port) > 0;
}

// And it has waited longer than any that comes later; others may yet come at this very time.
bool Processor::is_longest_known() const {
    const auto port = ports_.longest_waiting();
    return port && ports_.oldest(*port).delivered < now();
}

bool Processor::runs_freely() const {
    return settings_.run_ahead && enabled_interrupts_ == 0;
}

bool Processor::is_foreseen_read(const RegisterAddress& address) const {
    if (!runs_freely()) {
        return false;
    }
    if (address.port) {
        const auto which = static_cast<PortRegister>(address.offset);
        return (which == PortRegister::rxstat || which == PortRegister::rxlen) &&
               is_known_to_wait(*address.port);
    }
    return static_cast<NodeRegister>(address.offset) == NodeRegister::rxany && is_longest_known();
}

// What RXADDR and WAITFOR wait for stays once it is there. So it does not matter when it comes, as
// long as it is not after the core's own time; else the processor stalls from then on.
bool Processor::is_foreseen_write(const RegisterAddress& address) const {
    if (!runs_freely()) {
        return false;
    }
    if (address.port) {
        return static_cast<PortRegister>(address.offset) == PortRegister::rxaddr;
    }
    return static_cast<NodeRegister>(address.offset) == NodeRegister::waitfor;
}

isa::Bus::Read Processor::read(std::uint32_t address, int bytes) {
    const auto where = decode_register(address);
    if (!where || bytes != 2) {
        return {Status::fault, 0};
    }
    if (needs_exact_time(*where, false) && !is_foreseen_read(*where) && !reach_local_time()) {
        must_catch_up_ = true;
        return {Status::retry, 0};
    }
    ++accesses_;
    const auto value = where->port
                           ? read_port(*where->port, static_cast<PortRegister>(where->offset))
                           : read_node(static_cast<NodeRegister>(where->offset));
    return value ? Read{Status::ok, *value} : Read{Status::fault, 0};
}

isa::Bus::Status Processor::write(std::uint32_t address, std::uint32_t value, int bytes) {
    const auto where = decode_register(address);
    if (!where && bytes == 2) {
        return write_frame_buffer(address, value);
    }
    if (!where || bytes != 2) {
        return Status::fault;
    }
    if (needs_exact_time(*where, true) && !is_foreseen_write(*where) && !reach_local_time()) {
        must_catch_up_ = true;
        return Status::retry;
    }
    const Status status =
        where->port ? write_port(*where->port, static_cast<PortRegister>(where->offset), value)
                    : write_node(static_cast<NodeRegister>(where->offset), value);
    ++accesses_;
    return status;
}

// Empty for a register that cannot be read.
std::optional<std::uint32_t> Processor::read_port(int port, PortRegister which) const {
    // The registers of all sixteen ports are there, linked or not.
    const bool outward = which < PortRegister::rxstat;
    if (outward ? !ports_.transmits(port) : !ports_.receives(port)) {
        switch (which) {
            case PortRegister::txstat:
                return kStatNoLink;
            case PortRegister::txaddr:
            case PortRegister::txused:
            case PortRegister::rxstat:
            case PortRegister::rxlen:
                return 0;
            default:
                return std::nullopt;
        }
    }
    const PortState& state = port_states_[static_cast<std::size_t>(port)];
    const auto status = [](bool ready, bool enabled) {
        return (ready ? kStatReady : 0) | (enabled ? kStatInterruptEnable : 0);
    };
    switch (which) {
        case PortRegister::txstat:
            return status(ports_.has_room(port), state.transmit_interrupt);
        case PortRegister::txaddr:
            return state.transmit_address;
        case PortRegister::txused:
            return static_cast<std::uint32_t>(ports_.used(port));
        case PortRegister::rxstat:
            return status(ports_.waiting(port) > 0, state.receive_interrupt);
        case PortRegister::rxlen:
            return ports_.waiting(port) > 0
                       ? static_cast<std::uint32_t>(ports_.oldest(port).bytes.size())
                       : 0U;
        default:
            return std::nullopt;
    }
}

std::optional<std::uint32_t> Processor::read_node(NodeRegister which) {
    switch (which) {
        case NodeRegister::node:
            return settings_.node & 0xffffU;
        case NodeRegister::ports:
            return static_cast<std::uint32_t>(ports_.count());
        case NodeRegister::rxany: {
            const auto port = ports_.longest_waiting();
            return port ? static_cast<std::uint32_t>(*port) : kNoPort;
        }
        case NodeRegister::txroom:
            return ports_.room();
        case NodeRegister::phase:
            phase_read_ = phase_;
            meter_.see_phase(executed());
            return phase_;
        default:
            return std::nullopt;
    }
}

isa::Bus::Status Processor::write_port(int port, PortRegister which, std::uint32_t value) {
    const bool linked =
        which < PortRegister::rxstat ? ports_.transmits(port) : ports_.receives(port);
    switch (which) {
        case PortRegister::txstat:
        case PortRegister::rxstat:
            if (linked) {
                enable_interrupt(port, which == PortRegister::rxstat,
                                 (value & kStatInterruptEnable) != 0);
            }
            return Status::ok;
        case PortRegister::txaddr:
            if (linked) {
                port_states_[static_cast<std::size_t>(port)].transmit_address = value;
            }
            return Status::ok;
        case PortRegister::txlen:
            return linked ? write_txlen(port, value)
                          : refuse(fmt::format("send to port {}, which has no link", port));
        case PortRegister::rxaddr:
            return linked ? write_rxaddr(port, value)
                          : refuse(fmt::format("receive from port {}, which has no link", port));
        default:
            return Status::fault;
    }
}

isa::Bus::Status Processor::write_node(NodeRegister which, std::uint32_t value) {
    switch (which) {
        case NodeRegister::waitfor:
            return write_waitfor(value);
        case NodeRegister::credit:
            return write_credit(value);
        case NodeRegister::mark:
            if (value >= kActivities) {
                return refuse(
                    fmt::format("MARK {}: activities are 0 to {}", value, kActivities - 1));
            }
            meter_.mark(static_cast<std::uint8_t>(value), local_time_);
            return Status::ok;
        case NodeRegister::fault:
            return refuse(fmt::format("the program gave up with FAULT {}",
                                      format_word(value, settings_.radix)));
        default:
            return Status::fault;
    }
}

isa::Bus::Status Processor::write_txlen(int port, std::uint32_t bytes) {
    if (bytes < 1 || bytes > static_cast<std::uint32_t>(settings_.max_message)) {
        return refuse(fmt::format("send {} bytes to port {}: a message has 1 to {}", bytes, port,
                                  settings_.max_message));
    }
    const std::uint32_t address = port_states_[static_cast<std::size_t>(port)].transmit_address;
    const auto memory = core_->memory();
    if (address > memory.size() || bytes > memory.size() - address) {
        return refuse(fmt::format("send {} bytes from {}: beyond the end of memory", bytes,
                                  format_word(address, settings_.radix)));
    }
    if (!ports_.has_room(port)) {
        return stall(Stall::transmit, static_cast<std::uint32_t>(port));
    }
    const int queued = ports_.queued(port);
    ports_.enqueue(port, memory.subspan(address, bytes), now());
    if (!ports_.has_room(port)) {
        core_->withdraw_interrupt(kInterruptLevel, transmit_vector(port));
    }
    transmit(port);
    if (ports_.queued(port) > queued) {
        tell_queue(peer(transmit_port(port)), QueuePlace::at_sender, 1);
    }
    return Status::ok;
}

isa::Bus::Status Processor::write_rxaddr(int port, std::uint32_t address) {
    if (ports_.waiting(port) == 0) {
        return stall(Stall::receive, static_cast<std::uint32_t>(port));
    }
    const Message& message = ports_.oldest(port);
    const auto memory_bytes = core_->memory().size();
    if (address > memory_bytes || message.bytes.size() > memory_bytes - address) {
        return refuse(fmt::format("receive {} bytes at {}: beyond the end of memory",
                                  message.bytes.size(), format_word(address, settings_.radix)));
    }
    core_->write_memory(address, message.bytes);
    tell_consumed(port, message);
    ports_.consume_oldest(port, local_time_);
    send(receive_port(port), static_cast<EventKind>(MessageEvent::credit), 0, local_time_);
    if (ports_.waiting(port) == 0) {
        core_->withdraw_interrupt(kInterruptLevel, receive_vector(port));
    } else if (port_states_[static_cast<std::size_t>(port)].receive_interrupt) {
        request(receive_vector(port));
    }
    return Status::ok;
}

isa::Bus::Status Processor::write_waitfor(std::uint32_t mask) {
    if (wait_mask_holds(mask)) {
        return Status::ok;
    }
    return stall(Stall::wait_for, mask);
}

bool Processor::wait_mask_holds(std::uint32_t mask) const {
    return ((mask & kWaitMessage) != 0 && ports_.any_waiting()) ||
           ((mask & kWaitPhase) != 0 && phase_ != phase_read_) ||
           (mask & kWaitRoom & ports_.room()) != 0;
}

isa::Bus::Status Processor::write_credit(std::uint32_t value) {
    if (!settings_.supervised) {
        return refuse("CREDIT in a machine without a supervisor");
    }
    send(supervisor_port(), static_cast<EventKind>(SupervisorEvent::credit),
         credit_payload({static_cast<std::int16_t>(value), step_at_}), local_time_);
    return Status::ok;
}

// The first access of an instruction only can be put off: what an earlier one did could not be
// undone.
isa::Bus::Status Processor::stall(Stall kind, std::uint32_t argument) {
    if (accesses_ > 0) {
        return refuse("an instruction with two accesses to the I/O page stalls at the second");
    }
    stall_ = kind;
    stall_argument_ = argument;
    return Status::retry;
}

// The instruction is undone, so that the registers are shown as it found them.
isa::Bus::Status Processor::refuse(std::string what) {
    error_ = std::move(what);
    return Status::retry;
}

// A message that goes as soon as it has come, by `fresh_port`, was in no queue.
void Processor::transmit(std::optional<int> fresh_port) {
    while (const auto transmission = ports_.next_transmission(now())) {
        if (transmission->port != fresh_port) {
            tell_queue(peer(transmit_port(transmission->port)), QueuePlace::at_sender, -1);
        }
        send(transmit_port(transmission->port), static_cast<EventKind>(MessageEvent::transmit),
             to_payload(transmission->message), now());
    }
}

void Processor::tell_queue(ComponentId component, QueuePlace place, int change) const {
    meter_.probe().tell([&](NodeListener& listener) {
        listener.queue_changed({component, place, now(), change});
    });
}

void Processor::tell_consumed(int port, const Message& message) const {
    meter_.probe().tell([&](NodeListener& listener) {
        listener.message_consumed(
            record_of(message, peer(receive_port(port)), settings_.node, local_time_));
    });
}

void Processor::enable_interrupt(int port, bool receive, bool enable) {
    PortState& state = port_states_[static_cast<std::size_t>(port)];
    bool& enabled = receive ? state.receive_interrupt : state.transmit_interrupt;
    if (enabled == enable) {
        return;
    }
    enabled = enable;
    enabled_interrupts_ += enable ? 1 : -1;
    const std::uint32_t vector = receive ? receive_vector(port) : transmit_vector(port);
    if (!enable) {
        core_->withdraw_interrupt(kInterruptLevel, vector);
    } else if (receive ? ports_.waiting(port) > 0 : ports_.has_room(port)) {
        request(vector);
    }
}

void Processor::request(std::uint32_t vector) {
    interrupt_requested_ = true;
    core_->request_interrupt(kInterruptLevel, vector);
}

}  // namespace rasterloom
