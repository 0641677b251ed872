// SPDX-License-Identifier: MIT
// One toy processor.
#pragma once

#include "isa/core.hpp"
#include "isa/isa.hpp"
#include "isa/toy/instruction_table.hpp"

#include <array>
#include <memory>
#include <vector>

namespace rasterloom::isa::toy {

// Cycles of a byte fetched and of a byte of data moved.
struct Costs {
    std::int64_t fetch = 1;
    std::int64_t data = 1;
};

struct Program final : PreparedProgram {
    Image image;
    Costs costs;
};

InstructionCost cost_of_instruction(const InstructionRow& row, unsigned byte, const Costs& costs);

class ToyCore final : public Core {
  public:
    // Throws std::invalid_argument when the program does not fit in the memory.
    ToyCore(std::shared_ptr<const Program> program, std::uint32_t memory_bytes);

    Stop run(std::int64_t budget_cycles) override;
    Stop step(Bus& bus) override;
    void request_interrupt(int level, std::uint32_t vector) override;
    void withdraw_interrupt(int level, std::uint32_t vector) override;
    bool interruptible() const override { return (state_.f & kInterrupts) != 0; }
    std::uint32_t program_counter() const override { return state_.pc; }
    void set_program_counter(std::uint32_t address) override;
    std::uint32_t reg(int index) const override;
    void set_reg(int index, std::uint32_t value) override;
    std::span<const std::uint8_t> memory() const override { return memory_; }
    void write_memory(std::uint32_t address, std::span<const std::uint8_t> bytes) override;
    std::int64_t instructions_retired() const override { return retired_; }
    void set_taps(std::span<const std::uint32_t> addresses) override;

  private:
    static constexpr std::uint32_t kZero = 1;
    static constexpr std::uint32_t kCarry = 2;
    static constexpr std::uint32_t kInterrupts = 4;

    struct State {
        std::uint32_t a = 0;
        std::uint32_t x = 0;
        std::uint32_t pc = 0;
        std::uint32_t l = 0;
        std::uint32_t f = 0;
    };
    struct Request {
        int level = 0;
        std::uint32_t vector = 0;
    };
    enum class Access { done, io, retry, nothing_there };

    Stop execute(Bus* bus);  // one instruction; without a bus it stops before an I/O access
    Access perform(const InstructionRow& row, unsigned byte, Bus* bus, std::uint32_t& address);
    Stop trap(std::string what, std::uint32_t address) const;
    void take_interrupt();
    bool tap_due() const { return !tap_told_ && state_.pc < taps_.size() && taps_[state_.pc]; }
    std::uint32_t operand_address(unsigned byte, bool load);
    std::uint32_t word_at(std::uint32_t address) const;
    Access read(std::uint32_t address, std::uint32_t& value, Bus* bus) const;
    Access write(std::uint32_t address, std::uint32_t value, Bus* bus);
    Access load(const InstructionRow& row, unsigned byte, Bus* bus, std::uint32_t& address);
    Access store(unsigned byte, Bus* bus, std::uint32_t& address);
    void calculate(Operation operation, std::uint32_t value);
    void branch(Operation operation);
    void set_flag(std::uint32_t flag, bool on) {
        state_.f = on ? state_.f | flag : state_.f & ~flag;
    }

    std::shared_ptr<const Program> program_;
    std::vector<std::uint8_t> memory_;
    State state_;
    std::vector<Request> requests_;  // highest level first
    std::int64_t retired_ = 0;
    std::vector<bool> taps_;  // by address; empty without taps
    bool tap_told_ = false;   // of the instruction that comes next
};

}  // namespace rasterloom::isa::toy
