// SPDX-License-Identifier: MIT
// What each operation computes and how it sets the condition codes, once, for the interpreter and
// the fast handlers. Operands are unsigned and right-justified (16 bits, or 8 for byte forms); so
// are the results. A byte operation moves its operands to the upper half of a word, where carry and
// sign stand in the same bits as a word's. Source: DEC, PDP-11/40 Processor Handbook, chapter 4;
// division's condition codes after an overflow as SIMH 3.8 has them.
#pragma once

#include "isa/pdp11/flags.hpp"
#include "isa/pdp11/instruction_table.hpp"

#include <cstdint>

namespace rasterloom::isa::pdp11 {

constexpr bool is_byte(Operation op) {
    using enum Operation;
    return (op >= clrb && op <= aslb) || (op >= movb && op <= bisb);
}

// Whether the operation only looks at its last operand.
constexpr bool only_reads(Operation op) {
    using enum Operation;
    return op == cmp || op == cmpb || op == bit || op == bitb || op == tst || op == tstb;
}

// Whether the operation replaces its last operand without looking at it.
constexpr bool only_writes(Operation op) {
    using enum Operation;
    return op == mov || op == movb || op == clr || op == clrb || op == sxt;
}

// The word operation a byte operation does.
constexpr Operation word_form(Operation op) {
    using enum Operation;
    switch (op) {
        case clrb:
            return clr;
        case comb:
            return com;
        case incb:
            return inc;
        case decb:
            return dec;
        case negb:
            return neg;
        case adcb:
            return adc;
        case sbcb:
            return sbc;
        case tstb:
            return tst;
        case rorb:
            return ror;
        case rolb:
            return rol;
        case asrb:
            return asr;
        case aslb:
            return asl;
        case movb:
            return mov;
        case cmpb:
            return cmp;
        case bitb:
            return bit;
        case bicb:
            return bic;
        case bisb:
            return bis;
        default:
            return op;
    }
}

namespace alu {

inline std::int32_t extend_word(std::uint32_t value) {
    return static_cast<std::int16_t>(value);
}

// Two-operand word operations. Bits above the result's 16 mean nothing: whoever stores it cuts them
// off.
template <Operation op>
[[gnu::always_inline]] inline std::uint32_t combine(std::uint32_t src, std::uint32_t dst,
                                                    Flags& f) {
    using enum Operation;
    if constexpr (op == add) {
        const std::uint32_t sum = dst + src;
        f = {extend_word(sum), sum, (dst ^ sum) & (src ^ sum)};
        return sum;
    } else if constexpr (op == sub) {
        const std::uint32_t difference = dst - src;
        f = {extend_word(difference), difference, (dst ^ src) & (dst ^ difference)};
        return difference;
    } else if constexpr (op == cmp) {
        const std::uint32_t difference = src - dst;
        f = {extend_word(difference), difference, (src ^ dst) & (src ^ difference)};
        return dst;
    } else {
        std::uint32_t result = 0;
        if constexpr (op == mov) {
            result = src;
        } else if constexpr (op == bit) {
            result = src & dst;
        } else if constexpr (op == bic) {
            result = dst & ~src;
        } else if constexpr (op == bis) {
            result = dst | src;
        } else {
            static_assert(op == xor_);
            result = dst ^ src;
        }
        f.nz = extend_word(result);
        f.v = 0;
        return result;
    }
}

// One-operand word operations. `unit` is the last place's value: 0400 when a byte stands in the
// upper half.
template <Operation op, std::uint32_t unit>
[[gnu::always_inline]] inline std::uint32_t change(std::uint32_t d, Flags& f) {
    using enum Operation;
    const std::uint32_t carry_in = (f.c >> 16) & 1U;
    std::uint32_t r = d;
    if constexpr (op == clr) {
        r = 0;
        f.c = f.v = 0;
    } else if constexpr (op == tst) {
        f.c = f.v = 0;
    } else if constexpr (op == com) {
        r = ~d & (0x10000U - unit);
        f.c = 0x10000U;
        f.v = 0;
    } else if constexpr (op == inc) {
        r = d + unit;
        f.v = r & ~d;
    } else if constexpr (op == dec) {
        r = d - unit;
        f.v = d & ~r;
    } else if constexpr (op == neg) {
        r = 0U - d;
        f.c = r;
        f.v = d & r;
    } else if constexpr (op == adc) {
        r = d + carry_in * unit;
        f.c = r;
        f.v = r & ~d;
    } else if constexpr (op == sbc) {
        r = d - carry_in * unit;
        f.c = r;
        f.v = d & ~r;
    } else if constexpr (op == asl || op == rol) {
        r = (d << 1) | (op == rol ? carry_in * unit : 0U);
        f.c = r;
        f.v = r ^ d;
    } else {
        static_assert(op == asr || op == ror);
        const std::uint32_t out = d & unit;
        r = (d >> 1) | (op == ror ? carry_in << 15 : d & 0x8000U);
        r &= 0x10000U - unit;
        f.c = (out / unit) << 16;
        f.v = r ^ ((out / unit) << 15);
    }
    f.nz = extend_word(r);
    return r;
}

}  // namespace alu

// The two-operand operations and XOR: the new destination (for CMP and BIT: the old one).
template <Operation op>
[[gnu::always_inline]] inline std::uint32_t combine(std::uint32_t src, std::uint32_t dst,
                                                    Flags& f) {
    if constexpr (is_byte(op)) {
        return (alu::combine<word_form(op)>(src << 8, dst << 8, f) >> 8) & 0xFFU;
    } else {
        return alu::combine<op>(src, dst, f);
    }
}

// The one-operand operations: the new destination (for TST: the old one).
template <Operation op>
[[gnu::always_inline]] inline std::uint32_t change(std::uint32_t dst, Flags& f) {
    if constexpr (op == Operation::swab) {
        const std::uint32_t r = ((dst << 8) | (dst >> 8)) & 0xFFFFU;
        f = {static_cast<std::int8_t>(r), 0, 0};
        return r;
    } else if constexpr (op == Operation::sxt) {
        f.nz = f.nz < 0 ? -1 : 0;
        f.v = 0;
        return static_cast<std::uint16_t>(f.nz);
    } else if constexpr (is_byte(op)) {
        return (alu::change<word_form(op), 0x100U>(dst << 8, f) >> 8) & 0xFFU;
    } else {
        return alu::change<op, 1U>(dst, f);
    }
}

// MUL's product, as 32 bits.
[[gnu::always_inline]] inline std::int32_t multiply(std::uint32_t a, std::uint32_t b, Flags& f) {
    const std::int32_t product = alu::extend_word(a) * alu::extend_word(b);
    f.set_negative_zero(product < 0, product == 0);
    f.v = 0;
    f.set_carry(product != alu::extend_word(static_cast<std::uint32_t>(product)));
    return product;
}

// DIV: false when the quotient does not exist or does not fit; the registers then stay.
[[gnu::always_inline]] inline bool divide(std::int32_t dividend, std::uint32_t divisor_word,
                                          Flags& f, std::int32_t& quotient,
                                          std::int32_t& remainder) {
    const std::int32_t divisor = alu::extend_word(divisor_word);
    if (divisor == 0) [[unlikely]] {
        f.set_codes(7);  // Z V C
        return false;
    }
    if (divisor == -1 && dividend == INT32_MIN) [[unlikely]] {
        f.set_codes(2);  // V
        return false;
    }
    quotient = dividend / divisor;
    remainder = dividend % divisor;
    f.c = 0;
    if (quotient != static_cast<std::int16_t>(quotient)) [[unlikely]] {
        f.set_negative_zero(quotient < 0, false);
        f.v = 0x8000U;
        return false;
    }
    f.nz = quotient;
    f.v = 0;
    return true;
}

// ASH and ASHC: shifts `value` (sign-extended) of `bits` bits, 16 or 32, by the signed 6-bit count
// of `count_word`. V: a bit shifted out, or the sign that was, differs from the sign that is. C:
// the last bit shifted out.
[[gnu::always_inline]] inline std::int64_t shift(std::int64_t value, std::uint32_t count_word,
                                                 int bits, Flags& f) {
    const int count = static_cast<int>((count_word & 037U) | -(count_word & 040U));
    std::int64_t result = value;
    f.c = f.v = 0;
    if (count > 0) {
        const std::int64_t wide = value * (std::int64_t{1} << count);
        result = bits == 16 ? static_cast<std::int16_t>(wide) : static_cast<std::int32_t>(wide);
        f.set_overflow(wide != result);
        f.set_carry(((wide >> bits) & 1) != 0);
    } else if (count < 0) {
        result = value >> -count;
        f.set_carry(((value >> (-count - 1)) & 1) != 0);
    }
    f.set_negative_zero(result < 0, result == 0);
    return result;
}

// Whether the conditional branch `op` is taken.
template <Operation op>
[[gnu::always_inline]] inline bool branches(const Flags& f) {
    using enum Operation;
    const bool less = ((static_cast<std::uint32_t>(f.nz) >> 16) ^ f.v) & 0x8000U;
    if constexpr (op == br)
        return true;
    else if constexpr (op == bne)
        return !f.zero();
    else if constexpr (op == beq)
        return f.zero();
    else if constexpr (op == bge)
        return !less;
    else if constexpr (op == blt)
        return less;
    else if constexpr (op == bgt)
        return !less && !f.zero();
    else if constexpr (op == ble)
        return less || f.zero();
    else if constexpr (op == bpl)
        return !f.negative();
    else if constexpr (op == bmi)
        return f.negative();
    else if constexpr (op == bhi)
        return !f.carry() && !f.zero();
    else if constexpr (op == blos)
        return f.carry() || f.zero();
    else if constexpr (op == bvc)
        return !f.overflow();
    else if constexpr (op == bvs)
        return f.overflow();
    else if constexpr (op == bcc)
        return !f.carry();
    else {
        static_assert(op == bcs);
        return f.carry();
    }
}

}  // namespace rasterloom::isa::pdp11
