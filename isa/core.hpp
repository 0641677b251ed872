// SPDX-License-Identifier: MIT
// What a processor core promises to the machine around it, and the little it needs from it.
//
// A core is one processor's architectural state over a private memory. It knows neither time nor
// topology nor other cores; all its mutable state is inside it. The machine lets it run for a
// budget of cycles; the core comes back when the budget is spent or when something concerns the
// machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace rasterloom::isa {

// Why a core came back from run() or step().
enum class StopReason : std::uint8_t {
    budget,  // the budget is spent; the next instruction has not begun
    io,      // the next instruction touches the I/O page; it has had no effect yet: finish it with
             // step()
    retry,   // step() only: a device was not ready; the instruction has had no effect, try again
             // when it is
    wait,  // a wait-for-interrupt instruction has completed; nothing happens until an interrupt is
           // requested
    halt,  // a halt instruction has completed
    trap,  // the guest did what it may not and has no handler for: see Stop::trap
    tap,   // run() only: the instruction at a tapped address comes next; it has not begun
};

// A guest error as a value: what the machine reports with node, cycle and source line.
struct Trap {
    std::string what;           // "odd address", "reserved instruction", ...
    std::uint32_t pc = 0;       // address of the instruction that did it
    std::uint32_t address = 0;  // the offending address or instruction word
    std::uint32_t vector = 0;   // where the architecture would have vectored to
};

struct Stop {
    StopReason reason = StopReason::budget;
    std::int64_t cycles =
        0;  // spent in this call; may exceed the budget by at most one instruction
    std::optional<Trap> trap;
};

// The I/O page as the machine offers it to step(). Addresses are byte addresses, values
// right-justified.
class Bus {
  public:
    enum class Status : std::uint8_t {
        ok,
        retry,  // the device is not ready: the instruction must be undone and tried again later
        fault,  // nothing answers at this address: the architecture's bus error
    };
    struct Read {
        Status status = Status::fault;
        std::uint32_t value = 0;
    };
    virtual ~Bus() = default;
    virtual Read read(std::uint32_t address, int bytes) = 0;
    virtual Status write(std::uint32_t address, std::uint32_t value, int bytes) = 0;
};

// The part of the I/O page that can be used while the core runs on: what needs nobody else to have
// come to the same time. Its reads have no effect; what it answers retry or fault to has had none
// and is asked of the Bus in step().
class PromptBus : public Bus {
  public:
    // Where the access comes from; set by the core.
    std::int64_t cycles_before = 0;  // of this run, spent before its instruction
    std::uint32_t pc = 0;            // address of that
};

class Core {
  public:
    virtual ~Core() = default;

    // Executes private instructions until a StopReason arises. Never touches the I/O page.
    virtual Stop run(std::int64_t budget_cycles) = 0;

    // The same, but accesses to the I/O page are offered to `bus`, and the run goes on where that
    // answers ok. A core need not make use of it.
    virtual Stop run_with(PromptBus& /*bus*/, std::int64_t budget_cycles) {
        return run(budget_cycles);
    }

    // Executes exactly one instruction, its I/O-page accesses going to `bus`. On retry the
    // architectural state is what it was before (auto-increments included) and no cycles are spent;
    // a device must not change state when it answers retry, and an instruction that has already
    // performed one I/O access may not be answered retry on a later one.
    virtual Stop step(Bus& bus) = 0;

    // An interrupt request stays pending until taken (at an instruction boundary, when the priority
    // allows) or withdrawn. `level` and `vector` have the architecture's meaning (PDP-11: 4..7 and
    // a vector address).
    virtual void request_interrupt(int level, std::uint32_t vector) = 0;
    virtual void withdraw_interrupt(int level, std::uint32_t vector) = 0;
    // Whether an interrupt could be taken at all now: if not, the machine may let the core run
    // ahead of its horizon.
    virtual bool interruptible() const = 0;

    virtual std::uint32_t program_counter() const = 0;
    virtual void set_program_counter(std::uint32_t address) = 0;
    virtual std::uint32_t reg(int index) const = 0;  // index into Isa::register_names()
    virtual void set_reg(int index, std::uint32_t value) = 0;

    // Private memory as bytes, from address 0. Direct memory access goes through these, so that a
    // core which keeps decoded instructions notices writes into code.
    virtual std::span<const std::uint8_t> memory() const = 0;
    virtual void write_memory(std::uint32_t address, std::span<const std::uint8_t> bytes) = 0;

    virtual std::int64_t instructions_retired() const = 0;

    // Taps: places of the program where the machine wants to look at registers and memory. Each
    // time the instruction at one of these addresses is about to begin (no interrupt goes before
    // it, the budget is not spent), run() comes back with StopReason::tap, which takes no cycles;
    // the next run() or step() passes over it. step() heeds no taps. An interrupt requested between
    // the two goes first, and the tap is told of again when the handler returns to it. Nothing else
    // changes, and without taps run() is as fast as ever. Replaces the taps set before; to be
    // called between runs. Throws std::invalid_argument for an address at which no instruction of
    // private memory can begin.
    virtual void set_taps(std::span<const std::uint32_t> addresses) = 0;
};

}  // namespace rasterloom::isa
