// SPDX-License-Identifier: MIT
// Lanes in lock step, bundle by bundle and lane by lane, straight from the manual (docs/vliw.md):
// slow, and the measure of every faster way.
#pragma once

#include "isa/vliw/program.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace rasterloom::isa::vliw {

// A lane's memory as one space of word addresses: the fast memory, then the slow banks.
inline constexpr std::uint32_t kMemoryWords = kBankWords * (1 + kSlowBanks);
constexpr std::uint32_t slow_address(int bank, std::uint16_t address) {
    return static_cast<std::uint32_t>((bank + 1) * kBankWords) + address;
}

class Interpreter {
  public:
    enum class Reason : std::uint8_t {
        budget,  // all bundles asked for are executed
        halt,
        line,   // the program counter is 0, the call stack empty
        frame,  // the program counter is behind the `frame`, as it is behind a `halt` or `phase`
        phase,  // Stop::phase
        trap,   // Stop::trap; the bundle at the program counter has had no effect
    };
    struct Stop {
        Reason reason = Reason::budget;
        std::int64_t cycles = 0;  // spent
        int phase = 0;
        std::string trap;  // "call stack is full", "call stack is empty", "no bundle at address 17"
    };

    // `lanes`: 1 and more. All state is zero, all lanes are awake, the program counter is at the
    // entry.
    Interpreter(std::shared_ptr<const Program> program, std::int64_t lanes);

    Stop step();                     // one bundle
    Stop run(std::int64_t bundles);  // at most so many
    // Goes on at bundle 0 with an empty call stack.
    void restart();
    void set_program_counter(std::uint16_t address) { pc_ = address; }
    std::uint16_t program_counter() const { return pc_; }
    std::uint16_t procedure() const { return procedure_; }
    void set_aux(std::uint16_t value) { aux_ = value; }
    std::uint16_t counter(int index) const { return counters_.at(static_cast<std::size_t>(index)); }
    void set_counter(int index, std::uint16_t value) {
        counters_.at(static_cast<std::size_t>(index)) = value;
    }

    std::int64_t lanes() const { return static_cast<std::int64_t>(lanes_.size()); }
    std::uint16_t reg(std::int64_t lane, int index) const;
    void set_reg(std::int64_t lane, int index, std::uint16_t value);  // r0 stays zero
    bool carry(std::int64_t lane) const { return at(lane).carry; }
    bool test(std::int64_t lane) const { return at(lane).test; }
    bool asleep(std::int64_t lane) const { return at(lane).asleep; }
    std::uint16_t communication(std::int64_t lane) const { return at(lane).x; }
    std::uint16_t video(std::int64_t lane) const { return at(lane).video; }
    // By word address, below kMemoryWords.
    std::uint16_t read(std::int64_t lane, std::uint32_t address) const;
    void write(std::int64_t lane, std::uint32_t address, std::span<const std::uint16_t> words);

    std::int64_t bundles_executed() const { return bundles_executed_; }
    std::int64_t operations_executed() const { return operations_executed_; }
    // Cycles of the bundles for which the lane was awake.
    std::int64_t awake_cycles(std::int64_t lane) const { return at(lane).awake_cycles; }

  private:
    struct Lane {
        std::array<std::uint16_t, kRegisters> r{};
        bool carry = false;
        bool test = false;
        bool asleep = false;
        std::uint16_t x = 0;
        std::uint16_t video = 0;
        std::int64_t awake_cycles = 0;
        std::array<std::vector<std::uint16_t>, 1 + kSlowBanks> memory;  // zeros behind their ends

        std::uint16_t load(std::uint32_t address) const;
        void store(std::uint32_t address, std::uint16_t value);
    };

    const Lane& at(std::int64_t lane) const { return lanes_.at(static_cast<std::size_t>(lane)); }
    std::string trap_of(const Bundle& bundle) const;
    void wake(SleepOp op);
    bool condition(SeqOp op) const;
    void sequence(const Bundle::Sequencer& seq);
    std::vector<std::uint16_t> moved(const Bundle::Communication& comm) const;
    void execute(const Bundle& bundle, Lane& lane) const;

    std::shared_ptr<const Program> program_;
    std::vector<Lane> lanes_;
    std::uint16_t pc_;
    std::vector<std::uint16_t> calls_;  // return addresses
    std::array<std::uint16_t, kCounters> counters_{};
    std::uint16_t procedure_ = 0;
    std::uint16_t aux_ = 0;
    std::int64_t bundles_executed_ = 0;
    std::int64_t operations_executed_ = 0;
};

}  // namespace rasterloom::isa::vliw
