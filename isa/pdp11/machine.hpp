// SPDX-License-Identifier: MIT
// A PDP-11's whole state, laid out for the handlers that run it: registers, condition codes,
// memory, and what is known about the code in memory. It stands in zeroed pages of its own, which
// cost nothing until they are touched.
//
// Decoded code is kept in blocks of 128 instruction words. `code` has a bit for each word of memory
// that a decoded instruction may have been made from; a store looks at it.
#pragma once

#include "isa/pdp11/flags.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace rasterloom::isa {
class PromptBus;
}

namespace rasterloom::isa::pdp11 {

inline constexpr std::uint32_t kIoPage = 0160000;      // first byte address of the I/O page
inline constexpr std::uint16_t kStatusWord = 0177776;  // the processor status word's address
inline constexpr std::uint16_t kStackLimit = 0400;     // the stack below it traps (yellow zone)
inline constexpr unsigned kStackPointer = 6;
inline constexpr unsigned kProgramCounter = 7;
inline constexpr std::uint32_t kBlockWords =
    128;  // instruction words a block of decoded code covers
inline constexpr std::uint32_t kBlocks = kIoPage / 2 / kBlockWords;

struct Entry;
class CodeCache;
class Program;

// Why the handlers came back.
enum class Exit : std::uint8_t {
    proceed,  // nothing: the next handler is due (builds without tail calls only)
    budget,
    recheck,  // priority, trace bit or pending traps may have changed
    io,
    halt,
    wait,
    trap,     // Machine::fault
    endless,  // a loop of instructions that cost nothing
};

struct Fault {
    const char* what = nullptr;
    std::uint16_t pc = 0;
    std::uint16_t address = 0;
    std::uint16_t vector = 0;
};

struct Machine {
    std::array<std::uint16_t, 8>
        r;                       // r[7] is stale while handlers run: their entry knows the address
    std::uint32_t memory_words;  // private memory; at most kIoPage / 2
    Flags flags;                 // stale while handlers run: they carry them
    std::uint8_t priority;       // 0 to 7
    bool trace;                  // the T bit
    bool report_unhandled;
    std::uint8_t requested;      // highest level of a pending interrupt, 0 for none
    std::int64_t left;           // budget while outside handlers: cycles in the upper 32 bits
    std::int64_t budget;         // what `left` began with
    std::int64_t cycles_before;  // of this run, before that
    PromptBus* bus;              // for accesses while handlers run; null for none
    std::int64_t
        free_branches;  // taken branches that cost nothing, until the run is called endless
    const Entry* next;  // where to go on (builds without tail calls only)
    const Program* program;
    CodeCache* cache;
    Fault fault;
    std::int64_t traps;         // taken, interrupts included
    std::int64_t beyond_model;  // uses of processor modes, of a stack in the I/O page
    std::array<const Entry*, kBlocks + 1>
        blocks;  // decoded code by address; null where none is yet
    std::array<std::uint32_t, kIoPage / 64 + 2> code;
    std::array<std::uint8_t, kIoPage + 8> memory;

    std::uint16_t status_word() const {
        return static_cast<std::uint16_t>(flags.codes() | (trace ? 020U : 0U) |
                                          (unsigned{priority} << 5));
    }
    void set_status_word(unsigned value) {
        if ((value & 0177400U) != 0) {
            ++beyond_model;
        }
        flags.set_codes(value);
        trace = (value & 020U) != 0;
        priority = static_cast<std::uint8_t>((value >> 5) & 7U);
    }

    // An address as a word index, odd addresses far out of range: one comparison tells what is
    // private and even.
    static std::uint32_t word_index(std::uint16_t address) { return std::rotr(address, 1); }

    std::uint16_t load_word(std::uint16_t address) const {
        std::uint16_t value = 0;
        std::memcpy(&value, memory.data() + address, 2);
        return to_guest(value);
    }
    void store_word(std::uint16_t address, std::uint32_t value) {
        const std::uint16_t guest = to_guest(static_cast<std::uint16_t>(value));
        std::memcpy(memory.data() + address, &guest, 2);
    }
    // Whether a decoded instruction may have been made from this word.
    bool is_code(std::uint32_t index) const {
        return ((code[index >> 5] >> (index & 31U)) & 1U) != 0;
    }
    // The same of any of the 32 words from index & ~31 on.
    bool is_code_near(std::uint32_t index) const { return code[index >> 5] != 0; }

  private:
    // The guest is little-endian whatever the host is.
    static std::uint16_t to_guest(std::uint16_t value) {
        if constexpr (std::endian::native == std::endian::big) {
            return static_cast<std::uint16_t>((value << 8) | (value >> 8));
        } else {
            return value;
        }
    }
};

}  // namespace rasterloom::isa::pdp11
