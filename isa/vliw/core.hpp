// SPDX-License-Identifier: MIT
// One lane with a sequencer of its own as a processor core. Its private memory is the lane's: the
// fast memory, then the slow banks, words with the low byte first; the program is not in it. There
// is no I/O page and no interrupt. `line`, `frame` and `phase` stop nothing: the machine is not
// line-locked.
#pragma once

#include "isa/core.hpp"
#include "isa/vliw/interpreter.hpp"

#include <memory>
#include <vector>

namespace rasterloom::isa::vliw {

inline constexpr std::uint32_t kMemoryBytes = 2 * kMemoryWords;

class LaneCore final : public Core {
  public:
    explicit LaneCore(std::shared_ptr<const Program> program);

    Stop run(std::int64_t budget_cycles) override;
    Stop step(Bus& bus) override;
    void request_interrupt(int, std::uint32_t) override {}
    void withdraw_interrupt(int, std::uint32_t) override {}
    bool interruptible() const override { return false; }

    std::uint32_t program_counter() const override { return lane_.program_counter(); }
    void set_program_counter(std::uint32_t address) override;
    std::uint32_t reg(int index) const override;  // counters follow the registers
    void set_reg(int index, std::uint32_t value) override;

    // Valid until the next call of any function of this core.
    std::span<const std::uint8_t> memory() const override;
    // Throws std::out_of_range behind the last byte.
    void write_memory(std::uint32_t address, std::span<const std::uint8_t> bytes) override;
    std::int64_t instructions_retired() const override { return lane_.bundles_executed(); }
    void set_taps(std::span<const std::uint32_t> addresses) override;

  private:
    Stop execute();

    std::shared_ptr<const Program> program_;
    Interpreter lane_;
    mutable std::vector<std::uint8_t> bytes_;  // what memory() shows
    std::vector<bool> tapped_;                 // by address; empty without taps
    bool tap_told_ = false;                    // of the bundle that comes next
};

}  // namespace rasterloom::isa::vliw
