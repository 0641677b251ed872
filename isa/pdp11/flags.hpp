// SPDX-License-Identifier: MIT
// The condition codes in the form in which arithmetic leaves them, turned into N Z V C only when
// somebody looks.
//
//   nz   N is bit 31; Z is "the low 16 bits are zero". A 16-bit result, sign-extended, is such a
//   value as it stands. c    C is bit 16: where a 16-bit sum carries to. v    V is bit 15: where
//   the sign of a 16-bit operand stands.
#pragma once

#include <cstdint>

namespace rasterloom::isa::pdp11 {

struct Flags {
    std::int32_t nz;
    std::uint32_t c;
    std::uint32_t v;

    bool negative() const { return nz < 0; }
    bool zero() const { return static_cast<std::uint16_t>(nz) == 0; }
    bool overflow() const { return (v & 0x8000U) != 0; }
    bool carry() const { return (c & 0x10000U) != 0; }

    void set_negative_zero(bool n, bool z) {
        nz = static_cast<std::int32_t>((n ? 0x80000000U : 0U) | (z ? 0U : 1U));
    }
    void set_overflow(bool on) { v = on ? 0x8000U : 0U; }
    void set_carry(bool on) { c = on ? 0x10000U : 0U; }

    // N Z V C as bits 3 to 0 of the processor status word.
    std::uint16_t codes() const {
        return static_cast<std::uint16_t>((negative() ? 010U : 0U) | (zero() ? 4U : 0U) |
                                          (overflow() ? 2U : 0U) | (carry() ? 1U : 0U));
    }
    void set_codes(unsigned codes) {
        set_negative_zero((codes & 010U) != 0, (codes & 4U) != 0);
        set_overflow((codes & 2U) != 0);
        set_carry((codes & 1U) != 0);
    }
};

}  // namespace rasterloom::isa::pdp11
