// SPDX-License-Identifier: MIT
// The pieces fast handlers are made of. A body runs one instruction of known operation and places,
// or returns false having changed nothing; the interpreter then does what is rare: odd addresses,
// the I/O page, the stack limit, stores into code.
#pragma once

#include "isa/pdp11/alu.hpp"
#include "isa/pdp11/dispatch.hpp"

namespace rasterloom::isa::pdp11 {

constexpr bool is_memory(Place p) {
    return p != Place::reg && p != Place::immediate;
}
constexpr bool moves_register(Place p) {
    return p == Place::increment || p == Place::decrement || p == Place::push ||
           p == Place::increment_deferred;
}
// Instruction words the operand adds.
constexpr int extra_words(Place p) {
    using enum Place;
    return p == absolute || p == indexed || p == indexed_deferred || p == absolute_deferred ||
                   p == immediate
               ? 1
               : 0;
}

// An entry's operand fields. Where the decoder knows that two instructions name the same register,
// one copy of its number lets the compiler keep the value in a register of the host.
struct Operands {
    std::uint16_t a;
    std::uint16_t b;
    std::uint8_t src;
    std::uint8_t dst;
};

[[gnu::always_inline]] inline Operands operands_of(const Entry* e) {
    return {e->a, e->b, e->src, e->dst};
}

[[gnu::always_inline]] inline bool load_pointer(const Machine* m, std::uint16_t from,
                                                std::uint16_t& address) {
    if (Machine::word_index(from) >= m->memory_words) [[unlikely]]
        return false;
    address = m->load_word(from);
    return true;
}

// The operand's address; the register moves. False, nothing changed, for the interpreter's cases.
template <Place p, unsigned step>
[[gnu::always_inline]] inline bool locate(Machine* m, unsigned reg, std::uint16_t extension,
                                          std::uint16_t& address) {
    std::uint16_t& r = m->r[reg];
    if constexpr (p == Place::absolute) {
        address = extension;
    } else if constexpr (p == Place::deferred) {
        address = r;
    } else if constexpr (p == Place::increment) {
        address = r;
        r = static_cast<std::uint16_t>(address + step);
    } else if constexpr (p == Place::decrement || p == Place::push) {
        address = static_cast<std::uint16_t>(r - step);
        if (p == Place::push && address < kStackLimit) [[unlikely]]
            return false;
        r = address;
    } else if constexpr (p == Place::indexed) {
        address = static_cast<std::uint16_t>(r + extension);
    } else if constexpr (p == Place::increment_deferred) {
        const std::uint16_t from = r;
        if (!load_pointer(m, from, address))
            return false;
        r = static_cast<std::uint16_t>(from + 2U);
    } else if constexpr (p == Place::indexed_deferred) {
        return load_pointer(m, static_cast<std::uint16_t>(r + extension), address);
    } else {
        static_assert(p == Place::absolute_deferred);
        return load_pointer(m, extension, address);
    }
    return true;
}

template <bool byte>
[[gnu::always_inline]] inline std::uint32_t index_of(std::uint16_t address) {
    return byte ? address / 2U : Machine::word_index(address);
}

template <bool byte>
[[gnu::always_inline]] inline bool readable(const Machine* m, std::uint16_t address) {
    return index_of<byte>(address) < m->memory_words;
}

template <bool byte>
[[gnu::always_inline]] inline bool writable(const Machine* m, std::uint16_t address) {
    const std::uint32_t index = index_of<byte>(address);
    return index < m->memory_words && !m->is_code(index);
}

template <bool byte>
[[gnu::always_inline]] inline std::uint32_t load(const Machine* m, std::uint16_t address) {
    return byte ? m->memory[address] : m->load_word(address);
}

template <bool byte>
[[gnu::always_inline]] inline void put(Machine* m, std::uint16_t address, std::uint32_t value) {
    if constexpr (byte) {
        m->memory[address] = static_cast<std::uint8_t>(value);
    } else {
        m->store_word(address, value);
    }
}

template <bool byte>
[[gnu::always_inline]] inline std::uint32_t get_register(const Machine* m, unsigned reg) {
    return byte ? m->r[reg] & 0xFFU : m->r[reg];
}

template <Operation op>
[[gnu::always_inline]] inline void set_register(Machine* m, unsigned reg, std::uint32_t value) {
    if constexpr (op == Operation::movb) {
        value = static_cast<std::uint32_t>(static_cast<std::int8_t>(value));
    } else if constexpr (is_byte(op)) {
        value |= m->r[reg] & 0xFF00U;
    }
    m->r[reg] = static_cast<std::uint16_t>(value);
}

// A source operand, immediate or from memory.
template <bool byte, Place p>
[[gnu::always_inline]] inline bool fetch_source(Machine* m, unsigned reg, std::uint16_t extension,
                                                std::uint32_t& value) {
    if constexpr (p == Place::immediate) {
        value = byte ? extension & 0xFFU : extension;
    } else if constexpr (p == Place::reg) {
        value = get_register<byte>(m, reg);
    } else {
        const std::uint16_t before = m->r[reg];
        std::uint16_t address = 0;
        if (!locate < p, byte ? 1U : 2U > (m, reg, extension, address)) [[unlikely]]
            return false;
        if (!readable<byte>(m, address)) [[unlikely]] {
            if constexpr (moves_register(p))
                m->r[reg] = before;
            return false;
        }
        value = load<byte>(m, address);
    }
    return true;
}

template <Operation op, Place s, Place d>
[[gnu::always_inline]] inline bool twofold_body(Machine* m, const Operands& o, Flags& f) {
    constexpr bool byte = is_byte(op);
    std::uint32_t src = 0;
    const std::uint16_t src_before = moves_register(s) ? m->r[o.src] : std::uint16_t{0};
    // A register source is read last: see the operand order in interpreter.hpp.
    if constexpr (s != Place::reg) {
        if (!fetch_source<byte, s>(m, o.src, o.a, src)) [[unlikely]]
            return false;
    }
    if constexpr (d == Place::immediate) {
        static_assert(only_reads(op));
        if constexpr (s == Place::reg) {
            src = get_register<byte>(m, o.src);
        }
        combine<op>(src, byte ? o.b & 0xFFU : o.b, f);
        return true;
    } else if constexpr (d == Place::reg) {
        if constexpr (s == Place::reg)
            src = get_register<byte>(m, o.src);
        const std::uint32_t dst = only_writes(op) ? 0U : get_register<byte>(m, o.dst);
        const std::uint32_t result = combine<op>(src, dst, f);
        if constexpr (!only_reads(op))
            set_register<op>(m, o.dst, result);
        return true;
    } else {
        const std::uint16_t dst_before = moves_register(d) ? m->r[o.dst] : std::uint16_t{0};
        std::uint16_t address = 0;
        const bool located = locate < d, byte ? 1U : 2U > (m, o.dst, o.b, address);
        if (!located || !(only_reads(op) ? readable<byte>(m, address) : writable<byte>(m, address)))
            [[unlikely]] {
            if constexpr (moves_register(d))
                m->r[o.dst] = dst_before;
            if constexpr (moves_register(s))
                m->r[o.src] = src_before;
            return false;
        }
        if constexpr (s == Place::reg)
            src = get_register<byte>(m, o.src);
        const std::uint32_t dst = only_writes(op) ? 0U : load<byte>(m, address);
        const std::uint32_t result = combine<op>(src, dst, f);
        if constexpr (!only_reads(op))
            put<byte>(m, address, result);
        return true;
    }
}

template <Operation op, Place d>
[[gnu::always_inline]] inline bool single_body(Machine* m, const Operands& o, Flags& f) {
    constexpr bool byte = is_byte(op);
    if constexpr (d == Place::immediate) {
        static_assert(only_reads(op));
        change<op>(byte ? o.b & 0xFFU : o.b, f);
        return true;
    } else if constexpr (d == Place::reg) {
        const std::uint32_t dst = only_writes(op) ? 0U : get_register<byte>(m, o.dst);
        const std::uint32_t result = change<op>(dst, f);
        if constexpr (!only_reads(op))
            set_register<op>(m, o.dst, result);
        return true;
    } else {
        const std::uint16_t before = moves_register(d) ? m->r[o.dst] : std::uint16_t{0};
        std::uint16_t address = 0;
        const bool located = locate < d, byte ? 1U : 2U > (m, o.dst, o.b, address);
        if (!located || !(only_reads(op) ? readable<byte>(m, address) : writable<byte>(m, address)))
            [[unlikely]] {
            if constexpr (moves_register(d))
                m->r[o.dst] = before;
            return false;
        }
        const std::uint32_t dst = only_writes(op) ? 0U : load<byte>(m, address);
        const std::uint32_t result = change<op>(dst, f);
        if constexpr (!only_reads(op))
            put<byte>(m, address, result);
        return true;
    }
}

// MUL, DIV, ASH, ASHC: operand in the destination's fields, register in the source's.
template <Operation op, Place p>
[[gnu::always_inline]] inline bool extended_body(Machine* m, const Operands& o, Flags& f) {
    std::uint32_t src = 0;
    if (!fetch_source<false, p>(m, o.dst, o.b, src)) [[unlikely]]
        return false;
    std::uint16_t& high = m->r[o.src];
    std::uint16_t& low = m->r[o.src | 1U];
    if constexpr (op == Operation::mul) {
        const auto product = static_cast<std::uint32_t>(multiply(src, high, f));
        high = static_cast<std::uint16_t>(product >> 16);
        low = static_cast<std::uint16_t>(product);
    } else if constexpr (op == Operation::div) {
        std::int32_t quotient = 0;
        std::int32_t remainder = 0;
        const auto pair = static_cast<std::int32_t>((std::uint32_t{high} << 16) | low);
        if (divide(pair, src, f, quotient, remainder)) {
            high = static_cast<std::uint16_t>(quotient);
            low = static_cast<std::uint16_t>(remainder);
        }
    } else if constexpr (op == Operation::ash) {
        high = static_cast<std::uint16_t>(shift(static_cast<std::int16_t>(high), src, 16, f));
    } else {
        const auto pair = static_cast<std::int32_t>((std::uint32_t{high} << 16) | low);
        const auto result = static_cast<std::uint32_t>(shift(pair, src, 32, f));
        high = static_cast<std::uint16_t>(result >> 16);
        low = static_cast<std::uint16_t>(result);
    }
    return true;
}

// Whether the operation can have this destination.
constexpr bool has_handler(Operation op, Place d) {
    return d != Place::immediate || only_reads(op);
}

template <Operation op, Place s, Place d>
Exit run_twofold(RASTERLOOM_STATE) {
    Flags f{nz, c, v};
    if (!twofold_body<op, s, d>(m, operands_of(e), f)) [[unlikely]]
        RASTERLOOM_TAIL interpret(RASTERLOOM_UNCHANGED);
    left -= e->cost;
    e += 1 + extra_words(s) + extra_words(d);
    RASTERLOOM_NEXT;
}

template <Operation op, Place d>
Exit run_single(RASTERLOOM_STATE) {
    Flags f{nz, c, v};
    if (!single_body<op, d>(m, operands_of(e), f)) [[unlikely]]
        RASTERLOOM_TAIL interpret(RASTERLOOM_UNCHANGED);
    left -= e->cost;
    e += 1 + extra_words(d);
    RASTERLOOM_NEXT;
}

}  // namespace rasterloom::isa::pdp11
