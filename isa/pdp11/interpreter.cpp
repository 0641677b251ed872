// SPDX-License-Identifier: MIT
#include "isa/pdp11/interpreter.hpp"

#include "isa/pdp11/alu.hpp"
#include "isa/pdp11/code_cache.hpp"
#include "isa/pdp11/program.hpp"

namespace rasterloom::isa::pdp11 {
namespace {

std::uint16_t word16(std::uint32_t value) {
    return static_cast<std::uint16_t>(value);
}

}  // namespace

// --- Operands
// ------------------------------------------------------------------------------------------------------

bool Interpreter::fetch(std::uint32_t& word) {
    const std::uint16_t address = m_.r[kProgramCounter];
    if ((address & 1U) != 0)
        return fail(Abort::odd, address);
    // Code is private: what a device answers is no instruction.
    if (Machine::word_index(address) >= m_.memory_words)
        return fail(Abort::nonexistent, address);
    word = m_.load_word(address);
    m_.r[kProgramCounter] = word16(address + 2U);
    return true;
}

bool Interpreter::push(std::uint16_t value) {
    const std::uint16_t address = word16(m_.r[kStackPointer] - 2U);
    m_.r[kStackPointer] = address;
    if (!write_word(address, value))
        return false;
    if (address < kStackLimit)
        pending_ |= stack_limit;
    return true;
}

// Modes 1 to 7. Byte operands move a register by one, the stack pointer and the program counter
// always by two.
bool Interpreter::effective_address(unsigned spec, bool byte, std::uint16_t& address) {
    const unsigned mode = spec >> 3;
    const unsigned reg = spec & 7U;
    std::uint16_t& r = m_.r[reg];
    const bool deferred = (mode & 1U) != 0 && mode != 1;
    const unsigned step = byte && !deferred && reg < kStackPointer ? 1U : 2U;
    switch (mode) {
        case 1:
            address = r;
            return true;
        case 2:
        case 3:
            address = r;
            r = word16(r + step);
            break;
        case 4:
        case 5:
            address = r = word16(r - step);
            if (reg == kStackPointer && address < kStackLimit)
                pending_ |= stack_limit;
            break;
        default: {
            std::uint32_t index = 0;
            if (!fetch(index))
                return false;
            address = word16(r + index);
        }
    }
    if (deferred) {
        std::uint32_t pointer = 0;
        if (!read_word(address, pointer))
            return false;
        address = word16(pointer);
    }
    return true;
}

// Resolves an operand once and reads it.
bool Interpreter::operand(unsigned spec, bool byte, std::uint32_t& value, std::uint16_t& address) {
    if (spec < 010) {
        value = byte ? m_.r[spec] & 0xFFU : m_.r[spec];
        return true;
    }
    return effective_address(spec, byte, address) && read(address, byte, value);
}

bool Interpreter::store(unsigned spec, bool byte, std::uint16_t address, std::uint32_t value) {
    if (spec >= 010)
        return write(address, byte, value);
    std::uint16_t& r = m_.r[spec];
    r = byte ? word16((r & 0xFF00U) | (value & 0xFFU)) : word16(value);
    return true;
}

// --- Instructions
// --------------------------------------------------------------------------------------------------

template <Operation op>
bool Interpreter::twofold(unsigned word) {
    constexpr bool byte = is_byte(op);
    const unsigned src_spec = (word >> 6) & 077U;
    const unsigned dst_spec = word & 077U;
    std::uint32_t src = 0;
    std::uint32_t dst = 0;
    std::uint16_t address = 0;
    const bool register_last = src_spec < 010 && dst_spec >= 010;
    if (!register_last && !operand(src_spec, byte, src, address))
        return false;
    if constexpr (only_writes(op)) {
        if (dst_spec >= 010 && !effective_address(dst_spec, byte, address))
            return false;
    } else {
        if (!operand(dst_spec, byte, dst, address))
            return false;
    }
    if (register_last)
        src = byte ? m_.r[src_spec] & 0xFFU : m_.r[src_spec];
    const std::uint32_t result = combine<op>(src, dst, m_.flags);
    if constexpr (only_reads(op))
        return true;
    if (op == Operation::movb && dst_spec < 010) {
        m_.r[dst_spec] = word16(static_cast<std::uint32_t>(static_cast<std::int8_t>(result)));
        return true;
    }
    return store(dst_spec, byte, address, result);
}

template <Operation op>
bool Interpreter::single(unsigned word) {
    constexpr bool byte = is_byte(op);
    const unsigned spec = word & 077U;
    std::uint32_t dst = 0;
    std::uint16_t address = 0;
    if constexpr (only_writes(op)) {
        // CLR and SXT set their condition codes before they find their operand.
        const std::uint32_t result = change<op>(0, m_.flags);
        if (spec >= 010 && !effective_address(spec, byte, address))
            return false;
        return store(spec, byte, address, result);
    } else {
        if (!operand(spec, byte, dst, address))
            return false;
        const std::uint32_t result = change<op>(dst, m_.flags);
        return only_reads(op) || store(spec, byte, address, result);
    }
}

bool Interpreter::exclusive_or(unsigned word) {
    std::uint32_t dst = 0;
    std::uint16_t address = 0;
    if (!operand(word & 077U, false, dst, address))
        return false;
    const std::uint32_t result = combine<Operation::xor_>(m_.r[(word >> 6) & 7U], dst, m_.flags);
    return store(word & 077U, false, address, result);
}

// MUL, DIV, ASH, ASHC: the register is read after the source operand. Long results go to an even
// register and the next; with an odd one, the low half wins.
bool Interpreter::extended(Operation op, unsigned word) {
    using enum Operation;
    std::uint32_t src = 0;
    std::uint16_t address = 0;
    if (!operand(word & 077U, false, src, address))
        return false;
    std::uint16_t& high = m_.r[(word >> 6) & 7U];
    std::uint16_t& low = m_.r[((word >> 6) & 7U) | 1U];
    const auto pair = static_cast<std::int32_t>((std::uint32_t{high} << 16) | low);
    if (op == mul) {
        const auto product = static_cast<std::uint32_t>(multiply(src, high, m_.flags));
        high = word16(product >> 16);
        low = word16(product);
    } else if (op == div) {
        std::int32_t quotient = 0;
        std::int32_t remainder = 0;
        if (divide(pair, src, m_.flags, quotient, remainder)) {
            high = word16(static_cast<std::uint32_t>(quotient));
            low = word16(static_cast<std::uint32_t>(remainder));
        }
    } else if (op == ash) {
        high = word16(
            static_cast<std::uint32_t>(shift(static_cast<std::int16_t>(high), src, 16, m_.flags)));
    } else {
        const auto result = static_cast<std::uint32_t>(shift(pair, src, 32, m_.flags));
        high = word16(result >> 16);
        low = word16(result);
    }
    return true;
}

bool Interpreter::jump(Operation op, unsigned word) {
    if ((word & 077U) < 010) {
        pending_ |= jump_to_register;
        return true;
    }
    std::uint16_t target = 0;
    if (!effective_address(word & 077U, false, target))
        return false;
    if (op == Operation::jsr) {
        const unsigned link = (word >> 6) & 7U;
        // JSR SP saves the stack pointer as the push has left it.
        if (!push(word16(m_.r[link] - (link == kStackPointer ? 2U : 0U))))
            return false;
        m_.r[link] = m_.r[kProgramCounter];
    }
    m_.r[kProgramCounter] = target;
    return true;
}

bool Interpreter::return_from_interrupt(bool immediate_trace) {
    const std::uint16_t sp = m_.r[kStackPointer];
    std::uint32_t pc = 0;
    std::uint32_t status = 0;
    if (!read_word(sp, pc) || !read_word(word16(sp + 2U), status))
        return false;
    m_.r[kStackPointer] = word16(sp + 4U);
    m_.set_status_word(status);
    m_.r[kProgramCounter] = word16(pc);
    if (immediate_trace && m_.trace)
        pending_ |= trace;
    return true;
}

void Interpreter::branch(unsigned word) {
    const auto offset = static_cast<std::uint32_t>(static_cast<std::int8_t>(word));
    m_.r[kProgramCounter] = word16(m_.r[kProgramCounter] + 2U * offset);
}

bool Interpreter::control(Operation op, unsigned word) {
    using enum Operation;
    std::uint16_t& pc = m_.r[kProgramCounter];
    switch (op) {
        case halt:
            exit_ = Exit::halt;
            return true;
        case wait:
            exit_ = Exit::wait;
            return true;
        case bpt:
            pending_ |= breakpoint;
            return true;
        case iot:
            pending_ |= input_output;
            return true;
        case emt:
            pending_ |= emulator;
            return true;
        case trap:
            pending_ |= trap_instruction;
            return true;
        case rti:
            return return_from_interrupt(true);
        case rtt:
            return return_from_interrupt(false);
        case condition_codes: {
            const unsigned codes = m_.flags.codes();
            const unsigned selected = word & 017U;
            m_.flags.set_codes((word & 020U) != 0 ? codes | selected : codes & ~selected);
            return true;
        }
        case rts: {
            const unsigned link = word & 7U;
            pc = m_.r[link];
            std::uint32_t popped = 0;
            if (!read_word(m_.r[kStackPointer], popped))
                return false;
            m_.r[link] = word16(popped);
            if (link != kStackPointer)
                m_.r[kStackPointer] = word16(m_.r[kStackPointer] + 2U);
            return true;
        }
        case mark: {
            const std::uint16_t frame = word16(pc + 2U * (word & 077U));
            pc = m_.r[5];
            std::uint32_t popped = 0;
            if (!read_word(frame, popped))
                return false;
            m_.r[5] = word16(popped);
            m_.r[kStackPointer] = word16(frame + 2U);
            return true;
        }
        case sob: {
            std::uint16_t& counter = m_.r[(word >> 6) & 7U];
            counter = word16(counter - 1U);
            if (counter != 0)
                pc = word16(pc - 2U * (word & 077U));
            return true;
        }
        default:
            return true;  // NOP; RESET: the bus is the machine's, a node's devices have nothing to
                          // reset
    }
}

bool Interpreter::execute(unsigned word) {
    const InstructionRow* row = find_instruction(word);
    if (row == nullptr) {
        pending_ |= reserved;
        return true;
    }
    using enum Operation;
    const auto op = static_cast<Operation>(row->operation);
#define RASTERLOOM_BRANCH(name)       \
    case name:                        \
        if (branches<name>(m_.flags)) \
            branch(word);             \
        return true;
#define RASTERLOOM_SINGLE(name) \
    case name:                  \
        return single<name>(word);
#define RASTERLOOM_TWOFOLD(name) \
    case name:                   \
        return twofold<name>(word);
    switch (op) {
        RASTERLOOM_BRANCH(br)
        RASTERLOOM_BRANCH(bne)
        RASTERLOOM_BRANCH(beq)
        RASTERLOOM_BRANCH(bge) RASTERLOOM_BRANCH(blt) RASTERLOOM_BRANCH(bgt) RASTERLOOM_BRANCH(
            ble) RASTERLOOM_BRANCH(bpl) RASTERLOOM_BRANCH(bmi) RASTERLOOM_BRANCH(bhi)
            RASTERLOOM_BRANCH(blos) RASTERLOOM_BRANCH(bvc) RASTERLOOM_BRANCH(bvs) RASTERLOOM_BRANCH(
                bcc) RASTERLOOM_BRANCH(bcs) RASTERLOOM_SINGLE(swab) RASTERLOOM_SINGLE(sxt)
                RASTERLOOM_SINGLE(clr) RASTERLOOM_SINGLE(com) RASTERLOOM_SINGLE(
                    inc) RASTERLOOM_SINGLE(dec) RASTERLOOM_SINGLE(neg) RASTERLOOM_SINGLE(adc)
                    RASTERLOOM_SINGLE(sbc) RASTERLOOM_SINGLE(tst) RASTERLOOM_SINGLE(
                        ror) RASTERLOOM_SINGLE(rol) RASTERLOOM_SINGLE(asr) RASTERLOOM_SINGLE(asl)
                        RASTERLOOM_SINGLE(clrb) RASTERLOOM_SINGLE(comb) RASTERLOOM_SINGLE(incb)
                            RASTERLOOM_SINGLE(decb) RASTERLOOM_SINGLE(negb) RASTERLOOM_SINGLE(
                                adcb) RASTERLOOM_SINGLE(sbcb) RASTERLOOM_SINGLE(tstb)
                                RASTERLOOM_SINGLE(rorb) RASTERLOOM_SINGLE(rolb) RASTERLOOM_SINGLE(
                                    asrb) RASTERLOOM_SINGLE(aslb) RASTERLOOM_TWOFOLD(mov)
                                    RASTERLOOM_TWOFOLD(cmp) RASTERLOOM_TWOFOLD(bit)
                                        RASTERLOOM_TWOFOLD(bic) RASTERLOOM_TWOFOLD(bis)
                                            RASTERLOOM_TWOFOLD(add) RASTERLOOM_TWOFOLD(sub)
                                                RASTERLOOM_TWOFOLD(movb) RASTERLOOM_TWOFOLD(cmpb)
                                                    RASTERLOOM_TWOFOLD(bitb)
                                                        RASTERLOOM_TWOFOLD(bicb)
                                                            RASTERLOOM_TWOFOLD(bisb) case xor_
            : return exclusive_or(word);
        case mul:
        case div:
        case ash:
        case ashc:
            return extended(op, word);
        case jmp:
        case jsr:
            return jump(op, word);
        default:
            return control(op, word);
    }
#undef RASTERLOOM_BRANCH
#undef RASTERLOOM_SINGLE
#undef RASTERLOOM_TWOFOLD
}

Interpreter::Outcome Interpreter::step() {
    const auto registers = m_.r;
    const Flags flags = m_.flags;
    Outcome outcome;
    pc_ = m_.r[kProgramCounter];
    if (m_.trace)
        pending_ |= trace;
    std::uint32_t word = 0;
    bool part_of_cost = false;
    if (fetch(word)) {
        outcome.cycles = m_.program->costs().attempt(word);
        if (execute(word)) {
            address_ = word16(word);
            part_of_cost =
                (pending_ & (breakpoint | input_output | emulator | trap_instruction)) != 0;
        }
    } else {
        outcome.cycles = m_.program->costs().attempt(0240);  // the attempt to fetch
    }
    if (abort_ == Abort::io || abort_ == Abort::retry) {
        m_.r = registers;
        m_.flags = flags;
        return {Exit::io, 0};
    }
    // A bus error makes an end of the instruction: neither its trace trap nor its stack warning is
    // taken.
    if (abort_ != Abort::none)
        pending_ = bus_error;
    outcome.exit = exit_;
    take_pending(outcome, part_of_cost);
    return outcome;
}

}  // namespace rasterloom::isa::pdp11
