// SPDX-License-Identifier: MIT
#include "isa/toy/core.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::isa::toy {

InstructionCost cost_of_instruction(const InstructionRow& row, unsigned byte, const Costs& costs) {
    const auto format = static_cast<Format>(row.format);
    const bool immediate = format == Format::load && static_cast<Mode>(byte & 3) == Mode::immediate;
    const bool in_memory = format == Format::store || (format == Format::load && !immediate);
    return {length_of(row, byte) * costs.fetch, in_memory ? costs.data : 0};
}

ToyCore::ToyCore(std::shared_ptr<const Program> program, std::uint32_t memory_bytes)
    : program_(std::move(program)), memory_(memory_bytes) {
    for (const Segment& segment : program_->image.segments) {
        if (segment.address > memory_.size() ||
            segment.bytes.size() > memory_.size() - segment.address) {
            throw std::invalid_argument(fmt::format(
                "{}: the program reaches 0x{:x}, memory ends at 0x{:x}", program_->image.name,
                segment.address + segment.bytes.size() - 1, memory_.size() - 1));
        }
        write_memory(segment.address, segment.bytes);
    }
    state_.pc = program_->image.entry;
}

Stop ToyCore::run(std::int64_t budget_cycles) {
    std::int64_t cycles = 0;
    while (cycles < budget_cycles) {
        take_interrupt();
        if (tap_due()) {
            tap_told_ = true;
            return {StopReason::tap, cycles, std::nullopt};
        }
        Stop stop = execute(nullptr);
        cycles += stop.cycles;
        if (stop.reason != StopReason::budget) {
            stop.cycles = cycles;
            return stop;
        }
    }
    return {StopReason::budget, cycles, std::nullopt};
}

Stop ToyCore::step(Bus& bus) {
    return execute(&bus);
}

Stop ToyCore::trap(std::string what, std::uint32_t address) const {
    return {StopReason::trap, 0, Trap{std::move(what), state_.pc, address, 0}};
}

// `before` is what an instruction that cannot be finished goes back to.
Stop ToyCore::execute(Bus* bus) {
    take_interrupt();
    const State before = state_;
    if (state_.pc >= memory_.size()) {
        return trap("no memory to fetch from", state_.pc);
    }
    const unsigned byte = memory_[state_.pc];
    const InstructionRow* row = find_instruction(byte);
    if (row == nullptr) {
        return trap("reserved instruction", byte);
    }
    std::uint32_t address = 0;
    const Access access = perform(*row, byte, bus, address);
    if (access != Access::done) {
        state_ = before;
        if (access == Access::nothing_there) {
            return trap("nothing answers at this address", address);
        }
        return {access == Access::io ? StopReason::io : StopReason::retry, 0, std::nullopt};
    }
    const auto operation = static_cast<Operation>(row->operation);
    state_.pc = (before.pc + static_cast<std::uint32_t>(length_of(*row, byte))) & 0xffff;
    branch(operation);
    ++retired_;
    tap_told_ = false;
    const StopReason reason = operation == Operation::hlt   ? StopReason::halt
                              : operation == Operation::wai ? StopReason::wait
                                                            : StopReason::budget;
    return {reason, cost_of_instruction(*row, byte, program_->costs).total(), std::nullopt};
}

// What an instruction does beside going on; `address` becomes the one it accesses, if it does.
ToyCore::Access ToyCore::perform(const InstructionRow& row, unsigned byte, Bus* bus,
                                 std::uint32_t& address) {
    switch (static_cast<Operation>(row.operation)) {
        case Operation::ei:
            set_flag(kInterrupts, true);
            return Access::done;
        case Operation::di:
            set_flag(kInterrupts, false);
            return Access::done;
        case Operation::ldx:
            state_.x = word_at(state_.pc + 1);
            return Access::done;
        case Operation::lda:
        case Operation::add:
        case Operation::sub:
            return load(row, byte, bus, address);
        case Operation::sta:
            return store(byte, bus, address);
        default:
            return Access::done;
    }
}

void ToyCore::take_interrupt() {
    if (interruptible() && !requests_.empty()) {
        state_.l = std::exchange(state_.pc, requests_.front().vector & 0xffff);
        set_flag(kInterrupts, false);
        requests_.erase(requests_.begin());
        tap_told_ = false;
    }
}

std::uint32_t ToyCore::word_at(std::uint32_t address) const {
    const auto byte = [&](std::uint32_t at) {
        return at < memory_.size() ? std::uint32_t{memory_[at]} : 0;
    };
    return byte(address) | byte(address + 1) << 8;
}

// Where a load or store finds its byte; x goes on or back.
std::uint32_t ToyCore::operand_address(unsigned byte, bool load) {
    switch (static_cast<Mode>(byte & 3)) {
        case Mode::absolute:
            return word_at(state_.pc + 1);
        case Mode::indirect:
            return state_.x;
        case Mode::increment:
            return std::exchange(state_.x, (state_.x + 1) & 0xffff);
        case Mode::immediate:
            break;
    }
    if (load) {
        return (state_.pc + 1) & 0xffff;
    }
    return state_.x = (state_.x - 1) & 0xffff;
}

ToyCore::Access ToyCore::read(std::uint32_t address, std::uint32_t& value, Bus* bus) const {
    if (address < memory_.size()) {
        value = memory_[address];
        return Access::done;
    }
    if (address < kPrivateBytes) {
        return Access::nothing_there;
    }
    if (bus == nullptr) {
        return Access::io;
    }
    const Bus::Read answer = bus->read(address, 1);
    value = answer.value & 0xff;
    return answer.status == Bus::Status::ok      ? Access::done
           : answer.status == Bus::Status::retry ? Access::retry
                                                 : Access::nothing_there;
}

ToyCore::Access ToyCore::write(std::uint32_t address, std::uint32_t value, Bus* bus) {
    if (address < memory_.size()) {
        memory_[address] = static_cast<std::uint8_t>(value);
        return Access::done;
    }
    if (address < kPrivateBytes) {
        return Access::nothing_there;
    }
    if (bus == nullptr) {
        return Access::io;
    }
    const Bus::Status answer = bus->write(address, value, 1);
    return answer == Bus::Status::ok      ? Access::done
           : answer == Bus::Status::retry ? Access::retry
                                          : Access::nothing_there;
}

ToyCore::Access ToyCore::load(const InstructionRow& row, unsigned byte, Bus* bus,
                              std::uint32_t& address) {
    address = operand_address(byte, true);
    std::uint32_t value = 0;
    const Access access = read(address, value, bus);
    if (access == Access::done) {
        calculate(static_cast<Operation>(row.operation), value);
    }
    return access;
}

ToyCore::Access ToyCore::store(unsigned byte, Bus* bus, std::uint32_t& address) {
    address = operand_address(byte, false);
    return write(address, state_.a, bus);
}

void ToyCore::calculate(Operation operation, std::uint32_t value) {
    std::uint32_t result = value;
    if (operation == Operation::add) {
        result = state_.a + value;
        set_flag(kCarry, result > 0xff);
    } else if (operation == Operation::sub) {
        result = state_.a - value;
        set_flag(kCarry, value > state_.a);
    }
    state_.a = result & 0xff;
    set_flag(kZero, state_.a == 0);
}

// The program counter stands behind the instruction, its address in the two bytes before.
void ToyCore::branch(Operation operation) {
    const bool zero = (state_.f & kZero) != 0;
    const bool carry = (state_.f & kCarry) != 0;
    if (operation == Operation::jmp || (operation == Operation::beq && zero) ||
        (operation == Operation::bne && !zero) || (operation == Operation::bcs && carry) ||
        (operation == Operation::bcc && !carry)) {
        state_.pc = word_at(state_.pc - 2);
    } else if (operation == Operation::rti) {
        state_.pc = state_.l;
        set_flag(kInterrupts, true);
    }
}

void ToyCore::request_interrupt(int level, std::uint32_t vector) {
    const auto place = std::find_if(requests_.begin(), requests_.end(),
                                    [&](const Request& r) { return r.level < level; });
    requests_.insert(place, {level, vector});
}

void ToyCore::withdraw_interrupt(int level, std::uint32_t vector) {
    std::erase_if(requests_,
                  [&](const Request& r) { return r.level == level && r.vector == vector; });
}

std::uint32_t ToyCore::reg(int index) const {
    const std::array<std::uint32_t, 5> values = {state_.a, state_.x, state_.pc, state_.l, state_.f};
    return values.at(static_cast<std::size_t>(index));
}

void ToyCore::set_reg(int index, std::uint32_t value) {
    const std::array<std::uint32_t*, 5> registers = {&state_.a, &state_.x, &state_.pc, &state_.l,
                                                     &state_.f};
    const std::array<std::uint32_t, 5> masks = {0xff, 0xffff, 0xffff, 0xffff, 7};
    *registers.at(static_cast<std::size_t>(index)) =
        value & masks.at(static_cast<std::size_t>(index));
    tap_told_ = tap_told_ && registers.at(static_cast<std::size_t>(index)) != &state_.pc;
}

void ToyCore::set_program_counter(std::uint32_t address) {
    state_.pc = address & 0xffff;
    tap_told_ = false;
}

void ToyCore::set_taps(std::span<const std::uint32_t> addresses) {
    std::vector<bool> taps(addresses.empty() ? 0 : memory_.size());
    for (const std::uint32_t address : addresses) {
        if (address >= memory_.size()) {
            throw std::invalid_argument(
                fmt::format("a tap at 0x{:x}; memory ends at 0x{:x}", address, memory_.size() - 1));
        }
        taps[address] = true;
    }
    taps_ = std::move(taps);
    tap_told_ = false;
}

void ToyCore::write_memory(std::uint32_t address, std::span<const std::uint8_t> bytes) {
    if (address > memory_.size() || bytes.size() > memory_.size() - address) {
        throw std::out_of_range(
            fmt::format("{} bytes from 0x{:x} pass the memory's end", bytes.size(), address));
    }
    std::copy(bytes.begin(), bytes.end(), memory_.begin() + static_cast<std::ptrdiff_t>(address));
}

}  // namespace rasterloom::isa::toy
