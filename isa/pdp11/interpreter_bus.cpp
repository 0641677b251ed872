// SPDX-License-Identifier: MIT
// The interpreter's accesses (private memory, the status word, the machine's bus) and its trap
// sequence.
#include "isa/pdp11/code_cache.hpp"
#include "isa/pdp11/interpreter.hpp"
#include "isa/pdp11/program.hpp"

namespace rasterloom::isa::pdp11 {

bool Interpreter::fail(Abort why, std::uint16_t address) {
    abort_ = why;
    address_ = address;
    return false;
}

// --- Accesses
// ------------------------------------------------------------------------------------------------------

bool Interpreter::read_word(std::uint16_t address, std::uint32_t& value) {
    if (Machine::word_index(address) < m_.memory_words) {
        value = m_.load_word(address);
        return true;
    }
    if ((address & 1U) != 0)
        return fail(Abort::odd, address);
    if (address == kStatusWord) {
        value = m_.status_word();
        return true;
    }
    return bus_read(address, 2, value);
}

bool Interpreter::read_byte(std::uint16_t address, std::uint32_t& value) {
    if (address / 2U < m_.memory_words) {
        value = m_.memory[address];
        return true;
    }
    if (address >= kStatusWord) {
        value = address == kStatusWord ? m_.status_word() : 0U;
        return true;
    }
    return bus_read(address, 1, value);
}

bool Interpreter::write_word(std::uint16_t address, std::uint32_t value) {
    const std::uint32_t index = Machine::word_index(address);
    if (index < m_.memory_words) {
        m_.store_word(address, value);
        if (m_.is_code(index))
            m_.cache->written(index);
        return true;
    }
    if ((address & 1U) != 0)
        return fail(Abort::odd, address);
    if (address == kStatusWord) {
        write_status(address, value, false);
        return true;
    }
    return bus_write(address, value, 2);
}

bool Interpreter::write_byte(std::uint16_t address, std::uint32_t value) {
    const std::uint32_t index = address / 2U;
    if (index < m_.memory_words) {
        m_.memory[address] = static_cast<std::uint8_t>(value);
        if (m_.is_code(index))
            m_.cache->written(index);
        return true;
    }
    if (address >= kStatusWord) {
        write_status(address, value, true);
        return true;
    }
    return bus_write(address, value, 1);
}

bool Interpreter::read(std::uint16_t address, bool byte, std::uint32_t& value) {
    return byte ? read_byte(address, value) : read_word(address, value);
}

bool Interpreter::write(std::uint16_t address, bool byte, std::uint32_t value) {
    return byte ? write_byte(address, value & 0xFFU) : write_word(address, value);
}

bool Interpreter::bus_read(std::uint16_t address, int bytes, std::uint32_t& value) {
    if (address < kIoPage)
        return fail(Abort::nonexistent, address);
    if (bus_ == nullptr)
        return fail(Abort::io, address);
    const Bus::Read answer = bus_->read(address, bytes);
    if (answer.status == Bus::Status::retry)
        return fail(Abort::retry, address);
    if (answer.status == Bus::Status::fault)
        return fail(Abort::nonexistent, address);
    value = answer.value & (bytes == 1 ? 0xFFU : 0xFFFFU);
    return true;
}

bool Interpreter::bus_write(std::uint16_t address, std::uint32_t value, int bytes) {
    if (address < kIoPage)
        return fail(Abort::nonexistent, address);
    if (bus_ == nullptr)
        return fail(Abort::io, address);
    const Bus::Status answer = bus_->write(address, value, bytes);
    if (answer == Bus::Status::retry)
        return fail(Abort::retry, address);
    if (answer == Bus::Status::fault)
        return fail(Abort::nonexistent, address);
    return true;
}

// The T bit cannot be written here, only by RTI, RTT and traps. The upper byte holds nothing on
// this model.
void Interpreter::write_status(std::uint16_t address, std::uint32_t value, bool byte) {
    if (byte && address != kStatusWord) {
        m_.beyond_model += value != 0 ? 1 : 0;
        return;
    }
    const bool trace_bit = m_.trace;
    m_.set_status_word(value);
    m_.trace = trace_bit;
}

// --- Traps
// ---------------------------------------------------------------------------------------------------------

void Interpreter::report(Outcome& outcome, const char* what, std::uint16_t vector) {
    m_.fault = {what, pc_, address_, vector};
    outcome.exit = Exit::trap;
}

// Pushes status and address, loads both from the vector. False when that ends the run.
bool Interpreter::vector_through(std::uint16_t vector, Outcome& outcome) {
    ++m_.traps;
    const std::uint16_t old_status = m_.status_word();
    const std::uint16_t old_pc = m_.r[kProgramCounter];
    const std::uint16_t new_pc = m_.load_word(vector);
    const std::uint16_t new_status = m_.load_word(static_cast<std::uint16_t>(vector + 2U));
    const auto sp = static_cast<std::uint16_t>(m_.r[kStackPointer] - 2U);
    const auto top = static_cast<std::uint16_t>(m_.r[kStackPointer] - 4U);
    const auto can_hold = [this](std::uint16_t address) {
        return Machine::word_index(address) < m_.memory_words || address == kStatusWord;
    };
    if (!can_hold(sp) || !can_hold(top)) {
        m_.beyond_model += top >= kIoPage ? 1 : 0;
        if (m_.report_unhandled && m_.load_word(4) == 0) {
            address_ = sp;
            report(outcome, "the stack pointer is no place to save status and address", 4);
            return false;
        }
        m_.r[kStackPointer] = 4;  // red zone: the words at 0 and 2 are the emergency stack
        red_zone_ = true;
        return vector_through(4, outcome);
    }
    write_word(sp, old_status);
    write_word(top, old_pc);
    m_.r[kStackPointer] = top;
    m_.r[kProgramCounter] = new_pc;
    m_.set_status_word(new_status);
    return true;
}

// After a trap's pushes: the yellow zone, unless the red one has been dealt with already.
void Interpreter::warn_of_stack() {
    if (!red_zone_ && m_.r[kStackPointer] < kStackLimit)
        pending_ |= stack_limit;
    red_zone_ = false;
}

void Interpreter::take_pending(Outcome& outcome, bool part_of_cost) {
    struct Kind {
        unsigned bit;
        std::uint16_t vector;
        const char* what;
    };
    static constexpr Kind kKinds[] = {
        {bus_error, 4, nullptr},
        {jump_to_register, 4, "jump to a register"},
        {reserved, 010, "reserved instruction"},
        {breakpoint, 014, "BPT instruction"},
        {input_output, 020, "IOT instruction"},
        {emulator, 030, "EMT instruction"},
        {trap_instruction, 034, "TRAP instruction"},
        {trace, 014, "trace trap"},
        {stack_limit, 4, "stack below its limit"},
    };
    for (const Kind& kind : kKinds) {
        if ((pending_ & kind.bit) == 0)
            continue;
        // An instruction's own trap comes instead of its trace trap.
        pending_ &= ~(kind.bit | (kind.bit < trace ? trace : 0U));
        const char* what = kind.what;
        if (kind.bit == bus_error) {
            what = abort_ == Abort::odd ? "odd address" : "no memory and no device at this address";
            if (abort_ == Abort::nonexistent && address_ == pc_)
                what = "the program ran off its memory";
        }
        if (kind.bit == stack_limit)
            address_ = m_.r[kStackPointer];
        if (m_.report_unhandled && m_.load_word(kind.vector) == 0) {
            report(outcome, what, kind.vector);
            return;
        }
        if (!vector_through(kind.vector, outcome))
            return;
        if (outcome.exit == Exit::wait)
            outcome.exit = Exit::proceed;  // a trap ends a wait
        if (kind.bit != stack_limit)
            warn_of_stack();
        if (!part_of_cost)
            outcome.cycles += m_.program->costs().trap();
        part_of_cost = false;
    }
}

Interpreter::Outcome Interpreter::interrupt(std::uint16_t vector) {
    Outcome outcome;
    pc_ = m_.r[kProgramCounter];
    address_ = vector;
    if (m_.report_unhandled && m_.load_word(vector) == 0) {
        report(outcome, "interrupt", vector);
        return outcome;
    }
    if (!vector_through(vector, outcome))
        return outcome;
    outcome.cycles = m_.program->costs().trap();
    warn_of_stack();
    take_pending(outcome, false);
    return outcome;
}

}  // namespace rasterloom::isa::pdp11
