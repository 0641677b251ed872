// SPDX-License-Identifier: MIT
// Executes one instruction the plain way: everything the architecture says, in the order in which
// an 11/40 does it. The fast handlers fall back on it for whatever is rare (traps, the I/O page,
// the program counter as an operand), and the machine steps with it.
//
// Which of the family's differences it follows: PDP-11/40 with KE11-E and without memory
// management, as SIMH 3.8 shows them after `set cpu 11/40`:
//   - MOV R,(R)+ and its like (two operands, register source, memory destination) read the register
//   after the
//     destination's auto-increment or auto-decrement.
//   - JMP and JSR to a register trap to 4. JMP (R)+ goes where R pointed before.
//   - A word access to an odd address traps to 4, registers already incremented staying so.
//   - The stack limit is fixed at 0400: -(SP), JSR and traps below it complete, then trap to 4
//   (yellow zone). When a
//     trap's own push fails, SP becomes 4 and the trap goes through 4 (red zone).
//   - RTI that sets T traps before the next instruction, RTT after it. Writing the status word
//   leaves T alone.
//   - DIV by zero sets Z V C; a quotient that does not fit sets V and leaves the registers.
//   - SWAB and SXT clear V. MFPI and MTPI, which need memory management, are reserved, and so is
//   SPL.
#pragma once

#include "isa/core.hpp"
#include "isa/pdp11/instruction_table.hpp"
#include "isa/pdp11/machine.hpp"

#include <cstdint>

namespace rasterloom::isa::pdp11 {

class Interpreter {
  public:
    // Without a bus, an instruction that touches the I/O page ends with Exit::io before it has had
    // any effect.
    explicit Interpreter(Machine& machine, Bus* bus = nullptr) : m_(machine), bus_(bus) {}

    struct Outcome {
        Exit exit = Exit::proceed;
        std::int64_t cycles = 0;
    };
    // The instruction at r[7], and the traps it leads to.
    Outcome step();

    // Takes an interrupt through `vector`; the caller has checked that it may be taken.
    Outcome interrupt(std::uint16_t vector);

  private:
    enum class Abort : std::uint8_t { none, io, retry, odd, nonexistent };
    // Traps waiting for the end of the instruction, in the order in which they are taken.
    enum Pending : unsigned {
        bus_error = 1,
        jump_to_register = 2,
        reserved = 4,
        breakpoint = 8,
        input_output = 16,
        emulator = 32,
        trap_instruction = 64,
        trace = 128,
        stack_limit = 256,
    };

    bool fail(Abort why, std::uint16_t address);
    bool read_word(std::uint16_t address, std::uint32_t& value);
    bool read_byte(std::uint16_t address, std::uint32_t& value);
    bool write_word(std::uint16_t address, std::uint32_t value);
    bool write_byte(std::uint16_t address, std::uint32_t value);
    bool read(std::uint16_t address, bool byte, std::uint32_t& value);
    bool write(std::uint16_t address, bool byte, std::uint32_t value);
    bool bus_read(std::uint16_t address, int bytes, std::uint32_t& value);
    bool bus_write(std::uint16_t address, std::uint32_t value, int bytes);
    void write_status(std::uint16_t address, std::uint32_t value, bool byte);

    bool fetch(std::uint32_t& word);
    bool push(std::uint16_t value);
    bool effective_address(unsigned spec, bool byte, std::uint16_t& address);
    bool operand(unsigned spec, bool byte, std::uint32_t& value, std::uint16_t& address);
    bool store(unsigned spec, bool byte, std::uint16_t address, std::uint32_t value);

    bool execute(unsigned word);
    template <Operation op>
    bool twofold(unsigned word);
    template <Operation op>
    bool single(unsigned word);
    bool exclusive_or(unsigned word);
    bool extended(Operation op, unsigned word);
    bool jump(Operation op, unsigned word);
    bool return_from_interrupt(bool immediate_trace);
    bool control(Operation op, unsigned word);
    void branch(unsigned word);

    void warn_of_stack();
    void take_pending(Outcome& outcome, bool part_of_cost);
    bool vector_through(std::uint16_t vector, Outcome& outcome);
    void report(Outcome& outcome, const char* what, std::uint16_t vector);

    Machine& m_;
    Bus* bus_;
    Abort abort_ = Abort::none;
    unsigned pending_ = 0;
    bool red_zone_ = false;
    Exit exit_ = Exit::proceed;
    std::uint16_t pc_ = 0;       // of the instruction
    std::uint16_t address_ = 0;  // that caused the abort, or the instruction word
};

}  // namespace rasterloom::isa::pdp11
