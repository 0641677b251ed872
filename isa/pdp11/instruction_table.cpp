// SPDX-License-Identifier: MIT
// Source: DEC, PDP-11/40 Processor Handbook (1972), chapter 4, with the Extended Instruction Set
// option KE11-E.
#include "isa/pdp11/instruction_table.hpp"

#include <array>
#include <bit>
#include <memory>

namespace rasterloom::isa::pdp11 {
namespace {

constexpr InstructionRow row(std::uint32_t mask, std::uint32_t match, std::string_view mnemonic,
                             Format format, Operation operation, std::string_view summary) {
    return {mask, match, mnemonic, static_cast<int>(format), static_cast<int>(operation), summary};
}

using enum Format;
using O = Operation;

constexpr std::array kRows = {
    row(0177777, 0000000, "halt", none, O::halt, "stop the processor"),
    row(0177777, 0000001, "wait", none, O::wait, "wait for an interrupt"),
    row(0177777, 0000002, "rti", none, O::rti, "return from interrupt"),
    row(0177777, 0000003, "bpt", none, O::bpt, "breakpoint trap through 14"),
    row(0177777, 0000004, "iot", none, O::iot, "input/output trap through 20"),
    row(0177777, 0000005, "reset", none, O::reset, "reset the bus"),
    row(0177777, 0000006, "rtt", none, O::rtt, "return from trap, inhibiting one trace trap"),
    row(0177700, 0000100, "jmp", single, O::jmp, "jump"),
    row(0177770, 0000200, "rts", Format::rts, O::rts, "return from subroutine"),
    row(0177777, 0000240, "nop", none, O::nop, "no operation"),
    row(0177777, 0000241, "clc", none, O::condition_codes, "clear C"),
    row(0177777, 0000242, "clv", none, O::condition_codes, "clear V"),
    row(0177777, 0000244, "clz", none, O::condition_codes, "clear Z"),
    row(0177777, 0000250, "cln", none, O::condition_codes, "clear N"),
    row(0177777, 0000257, "ccc", none, O::condition_codes, "clear all condition codes"),
    row(0177777, 0000261, "sec", none, O::condition_codes, "set C"),
    row(0177777, 0000262, "sev", none, O::condition_codes, "set V"),
    row(0177777, 0000264, "sez", none, O::condition_codes, "set Z"),
    row(0177777, 0000270, "sen", none, O::condition_codes, "set N"),
    row(0177777, 0000277, "scc", none, O::condition_codes, "set all condition codes"),
    row(0177740, 0000240, "ccodes", condition, O::condition_codes,
        "clear or set the selected condition codes"),
    row(0177700, 0000300, "swab", single, O::swab, "swap bytes"),
    row(0177400, 0000400, "br", branch, O::br, "branch"),
    row(0177400, 0001000, "bne", branch, O::bne, "branch if not equal"),
    row(0177400, 0001400, "beq", branch, O::beq, "branch if equal"),
    row(0177400, 0002000, "bge", branch, O::bge, "branch if greater or equal (signed)"),
    row(0177400, 0002400, "blt", branch, O::blt, "branch if less (signed)"),
    row(0177400, 0003000, "bgt", branch, O::bgt, "branch if greater (signed)"),
    row(0177400, 0003400, "ble", branch, O::ble, "branch if less or equal (signed)"),
    row(0177000, 0004000, "jsr", register_dst, O::jsr, "jump to subroutine"),
    row(0177700, 0005000, "clr", single, O::clr, "clear"),
    row(0177700, 0005100, "com", single, O::com, "one's complement"),
    row(0177700, 0005200, "inc", single, O::inc, "increment"),
    row(0177700, 0005300, "dec", single, O::dec, "decrement"),
    row(0177700, 0005400, "neg", single, O::neg, "negate"),
    row(0177700, 0005500, "adc", single, O::adc, "add carry"),
    row(0177700, 0005600, "sbc", single, O::sbc, "subtract carry"),
    row(0177700, 0005700, "tst", single, O::tst, "test"),
    row(0177700, 0006000, "ror", single, O::ror, "rotate right through C"),
    row(0177700, 0006100, "rol", single, O::rol, "rotate left through C"),
    row(0177700, 0006200, "asr", single, O::asr, "arithmetic shift right"),
    row(0177700, 0006300, "asl", single, O::asl, "arithmetic shift left"),
    row(0177700, 0006400, "mark", Format::mark, O::mark, "clean up the stack after a call"),
    row(0177700, 0006700, "sxt", single, O::sxt, "extend N through the destination"),
    row(0170000, 0010000, "mov", twofold, O::mov, "move"),
    row(0170000, 0020000, "cmp", twofold, O::cmp, "compare: source minus destination"),
    row(0170000, 0030000, "bit", twofold, O::bit, "test bits"),
    row(0170000, 0040000, "bic", twofold, O::bic, "clear bits"),
    row(0170000, 0050000, "bis", twofold, O::bis, "set bits"),
    row(0170000, 0060000, "add", twofold, O::add, "add"),
    row(0177000, 0070000, "mul", register_src, O::mul,
        "multiply: 32-bit product in an even register and the next"),
    row(0177000, 0071000, "div", register_src, O::div,
        "divide the 32-bit dividend in an even register and the next"),
    row(0177000, 0072000, "ash", register_src, O::ash, "shift by -32 to 31 places"),
    row(0177000, 0073000, "ashc", register_src, O::ashc,
        "shift a register pair by -32 to 31 places"),
    row(0177000, 0074000, "xor", register_dst, O::xor_, "exclusive or"),
    row(0177000, 0077000, "sob", Format::sob, O::sob, "subtract one and branch if not zero"),
    row(0177400, 0100000, "bpl", branch, O::bpl, "branch if plus"),
    row(0177400, 0100400, "bmi", branch, O::bmi, "branch if minus"),
    row(0177400, 0101000, "bhi", branch, O::bhi, "branch if higher (unsigned)"),
    row(0177400, 0101400, "blos", branch, O::blos, "branch if lower or same (unsigned)"),
    row(0177400, 0102000, "bvc", branch, O::bvc, "branch if V is clear"),
    row(0177400, 0102400, "bvs", branch, O::bvs, "branch if V is set"),
    row(0177400, 0103000, "bcc", branch, O::bcc, "branch if C is clear; also written bhis"),
    row(0177400, 0103400, "bcs", branch, O::bcs, "branch if C is set; also written blo"),
    row(0177400, 0104000, "emt", trap_number, O::emt, "emulator trap through 30"),
    row(0177400, 0104400, "trap", trap_number, O::trap, "trap through 34"),
    row(0177700, 0105000, "clrb", single, O::clrb, "clear byte"),
    row(0177700, 0105100, "comb", single, O::comb, "one's complement of a byte"),
    row(0177700, 0105200, "incb", single, O::incb, "increment byte"),
    row(0177700, 0105300, "decb", single, O::decb, "decrement byte"),
    row(0177700, 0105400, "negb", single, O::negb, "negate byte"),
    row(0177700, 0105500, "adcb", single, O::adcb, "add carry to byte"),
    row(0177700, 0105600, "sbcb", single, O::sbcb, "subtract carry from byte"),
    row(0177700, 0105700, "tstb", single, O::tstb, "test byte"),
    row(0177700, 0106000, "rorb", single, O::rorb, "rotate byte right through C"),
    row(0177700, 0106100, "rolb", single, O::rolb, "rotate byte left through C"),
    row(0177700, 0106200, "asrb", single, O::asrb, "arithmetic shift of a byte right"),
    row(0177700, 0106300, "aslb", single, O::aslb, "arithmetic shift of a byte left"),
    row(0170000, 0110000, "movb", twofold, O::movb,
        "move byte; into a register it extends the sign"),
    row(0170000, 0120000, "cmpb", twofold, O::cmpb, "compare bytes"),
    row(0170000, 0130000, "bitb", twofold, O::bitb, "test bits of a byte"),
    row(0170000, 0140000, "bicb", twofold, O::bicb, "clear bits of a byte"),
    row(0170000, 0150000, "bisb", twofold, O::bisb, "set bits of a byte"),
    row(0170000, 0160000, "sub", twofold, O::sub, "subtract"),
};

// Index of the row of each first word, plus one; 0 for a reserved instruction.
struct Lookup {
    std::array<std::uint8_t, 65536> index{};

    Lookup() {
        static_assert(kRows.size() < 255);
        for (unsigned word = 0; word < index.size(); ++word) {
            int best = -1;
            for (std::size_t i = 0; i < kRows.size(); ++i) {
                if ((word & kRows[i].mask) == kRows[i].match &&
                    std::popcount(kRows[i].mask) > best) {
                    best = std::popcount(kRows[i].mask);
                    index[word] = static_cast<std::uint8_t>(i + 1);
                }
            }
        }
    }
};

}  // namespace

std::span<const InstructionRow> instruction_table() {
    return kRows;
}

const InstructionRow* find_instruction(unsigned word) {
    static const Lookup lookup;  // immutable after its first use
    const unsigned index = lookup.index[word & 0177777];
    return index == 0 ? nullptr : &kRows[index - 1];
}

}  // namespace rasterloom::isa::pdp11
