// SPDX-License-Identifier: MIT
// The PDP-11/40 as a Core. Which quirks it follows: interpreter.hpp. How it is fast: decoded.hpp,
// dispatch.hpp.
#pragma once

#include "isa/isa.hpp"
#include "isa/pdp11/code_cache.hpp"
#include "isa/pdp11/machine.hpp"
#include "isa/pdp11/program.hpp"

#include <memory>
#include <span>
#include <vector>

namespace rasterloom::isa::pdp11 {

// reg() and set_reg(): r0 to r5, sp, pc, psw.
inline constexpr int kStatusRegister = 8;

class Pdp11Core final : public Core {
  public:
    // Throws std::invalid_argument when the memory is not even, below 01000 bytes, above 56 KiB, or
    // too small for the program.
    Pdp11Core(std::shared_ptr<const Program> program, const CoreOptions& options);
    ~Pdp11Core() override;
    Pdp11Core(const Pdp11Core&) = delete;
    Pdp11Core& operator=(const Pdp11Core&) = delete;

    Stop run(std::int64_t budget_cycles) override;
    Stop run_with(PromptBus& bus, std::int64_t budget_cycles) override;
    Stop step(Bus& bus) override;

    void request_interrupt(int level, std::uint32_t vector) override;
    void withdraw_interrupt(int level, std::uint32_t vector) override;
    bool interruptible() const override { return m_->priority < 7; }

    std::uint32_t program_counter() const override { return m_->r[kProgramCounter]; }
    void set_program_counter(std::uint32_t address) override;
    std::uint32_t reg(int index) const override;
    void set_reg(int index, std::uint32_t value) override;

    std::span<const std::uint8_t> memory() const override;
    void write_memory(std::uint32_t address, std::span<const std::uint8_t> bytes) override;

    std::int64_t instructions_retired() const override { return retired_; }

    void set_taps(std::span<const std::uint32_t> addresses) override;

    // For tests: traps and interrupts taken, and blocks of decoded code not shared with other
    // cores.
    std::int64_t traps_taken() const { return m_->traps; }
    // Times the program used what this model has not: processor modes, a stack in the I/O page.
    std::int64_t beyond_model() const { return m_->beyond_model; }
    std::size_t own_blocks() const { return cache_.own_blocks(); }

  private:
    struct Unmap {
        void operator()(Machine* machine) const;
    };
    struct Request {
        int level;
        std::uint16_t vector;
    };

    static std::unique_ptr<Machine, Unmap> map_machine();
    bool interrupt_due() const { return m_->requested > m_->priority; }
    bool tap_due() const { return !tap_told_ && cache_.tapped(m_->r[kProgramCounter]); }
    Exit take_interrupt(std::int64_t& cycles);
    Exit run_chunk(std::int64_t budget, std::int64_t& cycles);
    Exit step_privately(std::int64_t& cycles);
    Stop stop(Exit exit, std::int64_t cycles);
    void update_requested();

    std::shared_ptr<const Program> program_;
    std::unique_ptr<Machine, Unmap> m_;
    CodeCache cache_;
    std::vector<Request> requests_;
    bool waiting_ = false;
    bool tap_told_ = false;  // of the instruction that comes next
    std::int64_t retired_ = 0;
};

}  // namespace rasterloom::isa::pdp11
