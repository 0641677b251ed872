// SPDX-License-Identifier: MIT
// A lock-step array: one sequencer and 1 to 65 536 lanes that all execute its bundles, on a ring
// of communication registers (Eldridge 1995, chapter 2; isa/vliw/bundle.hpp, docs/vliw.md). It
// knows no time, only cycles; the machine around it says what a cycle is and what a scanline.
#pragma once

#include "isa/vliw/program.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom {

// A lane's memory as one space of word addresses: the fast memory, then the slow banks.
inline constexpr std::uint32_t kLaneWords = isa::vliw::kBankWords * (1 + isa::vliw::kSlowBanks);
constexpr std::uint32_t fast_word(std::uint16_t address) {
    return address;
}
constexpr std::uint32_t slow_word(int bank, std::uint16_t address) {
    return static_cast<std::uint32_t>((bank + 1) * isa::vliw::kBankWords) + address;
}

// How a range of lane memory lies in the host's. Nothing but speed depends on it.
enum class LaneLayout : std::uint8_t {
    across,  // one address of all lanes side by side: for addresses that are the same on all lanes
    along,   // a lane's words side by side: for addresses that differ (tables of pointers, columns
             // of a picture)
    shared,  // stored once while it is the same on all lanes: for tables that the host loads
};

class LockstepArray {
  public:
    struct Settings {
        std::int64_t lanes = 1024;  // 1 ... 65 536
        int threads = 1;            // of the host; one for 256 lanes at the most
    };

    enum class Reason : std::uint8_t {
        budget,  // the cycles are spent; the next bundle has not begun
        halt,    // a `halt` has been executed
        line,    // a `line` has been executed; the program counter is 0, the call stack empty
        frame,   // a `frame` has been executed
        phase,   // a `phase` has been executed: Stop::phase
        trap,    // Stop::trap; the bundle at the program counter has had no effect
    };
    struct Stop {
        Reason reason = Reason::budget;
        std::int64_t cycles = 0;  // spent; may exceed the budget by less than one bundle's
        int phase = 0;
        std::string trap;  // "call stack is full", "no bundle at address 17", ...
    };

    LockstepArray(std::shared_ptr<const isa::vliw::Program> program, const Settings& settings);
    ~LockstepArray();
    LockstepArray(const LockstepArray&) = delete;
    LockstepArray& operator=(const LockstepArray&) = delete;

    std::int64_t lanes() const;
    Stop run(std::int64_t budget_cycles);
    // Goes on at bundle 0 with an empty call stack, as a line-locked machine does at each scanline.
    void restart();
    void set_program_counter(std::uint16_t address);
    std::uint16_t program_counter() const;
    std::uint16_t procedure() const;  // the procedure pointer
    void set_aux(std::uint16_t value);

    // Memory by lane and word address (below kLaneWords); untouched words are zero.
    std::uint16_t read(std::int64_t lane, std::uint32_t address) const;
    void read(std::int64_t lane, std::uint32_t address, std::span<std::uint16_t> words) const;
    void write(std::int64_t lane, std::uint32_t address, std::span<const std::uint16_t> words);
    void write_all(std::uint32_t address, std::span<const std::uint16_t> words);  // to every lane
    // To be called before the range holds anything but zeros. May be widened by the array.
    void set_layout(std::uint32_t first, std::uint32_t words, LaneLayout layout);

    // State of a lane.
    std::uint16_t reg(std::int64_t lane, int index) const;
    void set_reg(std::int64_t lane, int index, std::uint16_t value);
    bool carry(std::int64_t lane) const;
    bool test(std::int64_t lane) const;
    bool asleep(std::int64_t lane) const;
    std::uint16_t communication(std::int64_t lane) const;
    std::uint16_t video(std::int64_t lane) const;
    std::uint16_t counter(int index) const;

    // Bundles executed since the start, of all lanes together; times lanes() it is the number of
    // lane-instructions.
    std::int64_t bundles_executed() const;
    std::int64_t operations_executed() const;  // slots that did something
    // How often each bundle was executed, by address.
    std::vector<std::int64_t> profile() const;
    // Cycles during which the lane was awake, since the start.
    std::int64_t awake_cycles(std::int64_t lane) const;

    // Vector instruction sets of this host that the array can use ("AVX3", "AVX2", "SSE4",
    // "EMU128", ...), the one in use first; use_path makes all arrays use another (for tests and
    // measurements). Results are the same on all of them.
    static std::vector<std::string> paths();
    static void use_path(std::string_view name);

  private:
    class Engine;
    std::unique_ptr<Engine> engine_;
};

}  // namespace rasterloom
