// SPDX-License-Identifier: MIT
#include "isa/pdp11/core.hpp"

#include "isa/pdp11/interpreter.hpp"

#include <algorithm>
#include <new>
#include <stdexcept>
#include <string>

#include <sys/mman.h>

namespace rasterloom::isa::pdp11 {
namespace {

constexpr std::uint32_t kLeastMemory = 01000;  // vectors and the stack limit
// Cycles run at a stretch: `left` must hold them in its upper half. A program that takes sixteen
// free branches for each of them is in an endless loop.
constexpr std::int64_t kChunk = std::int64_t{1} << 20;
constexpr std::int64_t kFreeBranches = 16 * kChunk;

}  // namespace

void Pdp11Core::Unmap::operator()(Machine* machine) const {
    ::munmap(machine, sizeof(Machine));
}

// Zeroed by the system when first touched; thousands of cores share the machine's memory.
std::unique_ptr<Machine, Pdp11Core::Unmap> Pdp11Core::map_machine() {
    void* pages = ::mmap(nullptr, sizeof(Machine), PROT_READ | PROT_WRITE,
                         MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (pages == MAP_FAILED)
        throw std::bad_alloc();
    return std::unique_ptr<Machine, Unmap>(static_cast<Machine*>(pages));
}

Pdp11Core::Pdp11Core(std::shared_ptr<const Program> program, const CoreOptions& options)
    : program_(std::move(program)), m_(map_machine()), cache_(*m_, *program_) {
    const std::uint32_t bytes = options.memory_bytes == 0 ? kIoPage : options.memory_bytes;
    if (bytes % 2 != 0 || bytes < kLeastMemory || bytes > kIoPage) {
        throw std::invalid_argument("a PDP-11 cannot have " + std::to_string(bytes) +
                                    " bytes of memory; expected an even number from 512 to 57344");
    }
    if (program_->last_address() > bytes) {
        throw std::invalid_argument("the program needs " +
                                    std::to_string(program_->last_address()) +
                                    " bytes of memory; the processor has " + std::to_string(bytes));
    }
    m_->memory_words = bytes / 2;
    m_->report_unhandled = options.traps == TrapPolicy::report_unhandled;
    m_->program = program_.get();
    m_->cache = &cache_;
    m_->set_status_word(0340);
    m_->r[kProgramCounter] = program_->entry();
    for (const Segment& segment : program_->segments()) {
        std::copy(segment.bytes.begin(), segment.bytes.end(), m_->memory.begin() + segment.address);
    }
}

Pdp11Core::~Pdp11Core() = default;

// --- Running
// -------------------------------------------------------------------------------------------------------

Stop Pdp11Core::run(std::int64_t budget_cycles) {
    std::int64_t cycles = 0;
    m_->free_branches = kFreeBranches;
    Exit exit = Exit::recheck;
    while (true) {
        if (cycles >= budget_cycles)
            return stop(Exit::budget, cycles);
        if (interrupt_due()) {
            exit = take_interrupt(cycles);
        } else if (waiting_) {
            return stop(Exit::wait, cycles);
        } else if (tap_due()) {
            tap_told_ = true;
            return {StopReason::tap, cycles, std::nullopt};
        } else if (tap_told_ || m_->trace ||
                   Machine::word_index(m_->r[kProgramCounter]) >= m_->memory_words) {
            exit = step_privately(cycles);
        } else {
            exit = run_chunk(std::min(budget_cycles - cycles, kChunk), cycles);
        }
        if (exit != Exit::budget && exit != Exit::recheck && exit != Exit::proceed)
            return stop(exit, cycles);
    }
}

Stop Pdp11Core::run_with(PromptBus& bus, std::int64_t budget_cycles) {
    m_->bus = &bus;
    Stop stop = run(budget_cycles);
    m_->bus = nullptr;
    return stop;
}

Exit Pdp11Core::run_chunk(std::int64_t budget, std::int64_t& cycles) {
    const std::int64_t all = cost_units(budget, -1);
    m_->left = all;
    m_->budget = all;
    m_->cycles_before = cycles;
    m_->free_branches = kFreeBranches;
    const Exit exit = run_handlers(*m_);
    const std::int64_t spent = all - m_->left;
    cycles += spent >> kCycleShift;
    retired_ += spent & ((std::int64_t{1} << kCycleShift) - 1);
    return exit;
}

Exit Pdp11Core::step_privately(std::int64_t& cycles) {
    const Interpreter::Outcome outcome = Interpreter(*m_).step();
    if (outcome.exit == Exit::io)
        return Exit::io;
    tap_told_ = false;
    cycles += outcome.cycles;
    ++retired_;
    if (outcome.cycles == 0 && --m_->free_branches <= 0)
        return Exit::endless;
    return outcome.exit;
}

Exit Pdp11Core::take_interrupt(std::int64_t& cycles) {
    const auto first = std::max_element(
        requests_.begin(), requests_.end(), [](const Request& a, const Request& b) {
            return a.level != b.level ? a.level < b.level : a.vector > b.vector;
        });
    const Interpreter::Outcome outcome = Interpreter(*m_).interrupt(first->vector);
    requests_.erase(first);
    update_requested();
    waiting_ = false;
    tap_told_ = false;
    cycles += outcome.cycles;
    return outcome.exit;
}

Stop Pdp11Core::step(Bus& bus) {
    std::int64_t cycles = 0;
    if (interrupt_due()) {
        const Exit exit = take_interrupt(cycles);
        return stop(exit, cycles);
    }
    if (waiting_)
        return stop(Exit::wait, 0);
    const Interpreter::Outcome outcome = Interpreter(*m_, &bus).step();
    if (outcome.exit == Exit::io)
        return {StopReason::retry, 0, std::nullopt};
    tap_told_ = false;
    ++retired_;
    return stop(outcome.exit, outcome.cycles);
}

Stop Pdp11Core::stop(Exit exit, std::int64_t cycles) {
    const auto trapped = [&](const Fault& fault) {
        return Stop{StopReason::trap, cycles,
                    Trap{fault.what, fault.pc, fault.address, fault.vector}};
    };
    switch (exit) {
        case Exit::io:
            return {StopReason::io, cycles, std::nullopt};
        case Exit::halt:
            return {StopReason::halt, cycles, std::nullopt};
        case Exit::wait:
            waiting_ = true;
            return {StopReason::wait, cycles, std::nullopt};
        case Exit::trap:
            return trapped(m_->fault);
        case Exit::endless: {
            const std::uint16_t pc = m_->r[kProgramCounter];
            return trapped({"an endless loop of instructions that cost nothing", pc, pc, 0});
        }
        default:
            return {StopReason::budget, cycles, std::nullopt};
    }
}

// --- Interrupts
// ----------------------------------------------------------------------------------------------------

void Pdp11Core::request_interrupt(int level, std::uint32_t vector) {
    if (level < 4 || level > 7 || vector % 4 != 0 || vector == 0 || vector >= 01000) {
        throw std::invalid_argument("interrupt at level " + std::to_string(level) +
                                    " through vector " + std::to_string(vector) +
                                    "; expected level 4 to 7 and a vector below 01000, a "
                                    "multiple of 4");
    }
    withdraw_interrupt(level, vector);
    requests_.push_back({level, static_cast<std::uint16_t>(vector)});
    update_requested();
}

void Pdp11Core::withdraw_interrupt(int level, std::uint32_t vector) {
    std::erase_if(requests_,
                  [&](const Request& r) { return r.level == level && r.vector == vector; });
    update_requested();
}

void Pdp11Core::update_requested() {
    int highest = 0;
    for (const Request& request : requests_)
        highest = std::max(highest, request.level);
    m_->requested = static_cast<std::uint8_t>(highest);
}

// --- State
// ---------------------------------------------------------------------------------------------------------

void Pdp11Core::set_program_counter(std::uint32_t address) {
    m_->r[kProgramCounter] = static_cast<std::uint16_t>(address);
    waiting_ = false;
    tap_told_ = false;
}

std::uint32_t Pdp11Core::reg(int index) const {
    if (index == kStatusRegister)
        return m_->status_word();
    return m_->r.at(static_cast<std::size_t>(index));
}

void Pdp11Core::set_reg(int index, std::uint32_t value) {
    if (index == kStatusRegister) {
        m_->set_status_word(value);
    } else {
        m_->r.at(static_cast<std::size_t>(index)) = static_cast<std::uint16_t>(value);
        if (index == static_cast<int>(kProgramCounter))
            tap_told_ = false;
    }
}

std::span<const std::uint8_t> Pdp11Core::memory() const {
    return {m_->memory.data(), std::size_t{2} * m_->memory_words};
}

void Pdp11Core::write_memory(std::uint32_t address, std::span<const std::uint8_t> bytes) {
    if (bytes.empty())
        return;
    const std::size_t end = address + bytes.size();
    if (end > memory().size()) {
        throw std::out_of_range("write to memory at " + std::to_string(address) + ", " +
                                std::to_string(bytes.size()) + " bytes; the processor has " +
                                std::to_string(memory().size()));
    }
    std::copy(bytes.begin(), bytes.end(), m_->memory.begin() + address);
    for (std::uint32_t index = address / 2; index <= (end - 1) / 2;) {
        if (!m_->is_code_near(index)) {
            index = (index | 31U) + 1;
            continue;
        }
        if (m_->is_code(index))
            cache_.written(index);
        ++index;
    }
}

void Pdp11Core::set_taps(std::span<const std::uint32_t> addresses) {
    for (const std::uint32_t address : addresses) {
        if (address % 2 != 0 || address >= memory().size()) {
            throw std::invalid_argument("a tap at " + std::to_string(address) +
                                        "; expected an even address below " +
                                        std::to_string(memory().size()));
        }
    }
    cache_.set_taps(addresses);
    tap_told_ = false;
}

}  // namespace rasterloom::isa::pdp11
