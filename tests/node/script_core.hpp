// SPDX-License-Identifier: MIT
// A core for tests: eight registers, a private memory, and a program that is a list of operations,
// one cycle each unless said otherwise. It keeps the contract of isa/core.hpp, and no more.
#pragma once

#include "isa/core.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <vector>

namespace rasterloom {

class ScriptCore final : public isa::Core {
  public:
    enum class Verb : std::uint8_t {
        work,           // c cycles; of nothing
        set,            // r[a] = c
        add,            // r[a] += c, 16 bits
        random,         // r[a] = 0 to c - 1
        poke,           // memory[c] = low byte of r[a]
        peek,           // r[a] = memory[c]
        jump,           // to c
        jump_if_zero,   // to c if r[a] == 0
        jump_if_equal,  // to c if r[a] == r[b]
        jump_if_clear,  // to c if (r[a] & b) == 0
        load,           // r[a] = I/O register c + 020 * r[b]
        store,          // I/O register c + 020 * r[b] = r[a]
        move,           // I/O register b = I/O register c: two accesses in an instruction
        store_byte,     // low byte of I/O register c = r[a]
        wait,
        halt,
        trap,
        interrupts_off,
        interrupts_on,
        return_from_interrupt,
    };
    struct Operation {
        Verb verb = Verb::halt;
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        std::uint32_t c = 0;
    };
    using Program = std::vector<Operation>;
    static constexpr std::uint32_t kZero =
        7;  // a register that programs leave at zero, for unindexed accesses

    explicit ScriptCore(Program program, std::uint32_t seed = 1, std::size_t memory_bytes = 2048)
        : program_(std::move(program)), random_(seed), memory_(memory_bytes) {}

    // Entry points of interrupt handlers.
    std::map<std::uint32_t, std::uint32_t> handlers;

    isa::Stop run(std::int64_t budget) override {
        std::int64_t cycles = 0;
        while (cycles < budget) {
            take_interrupt();
            if (taps_.contains(pc_) && !tap_told_) {
                tap_told_ = true;
                return {isa::StopReason::tap, cycles, {}};
            }
            const Operation& op = program_[pc_];
            switch (op.verb) {
                case Verb::load:
                case Verb::store:
                case Verb::move:
                case Verb::store_byte:
                    return {isa::StopReason::io, cycles, {}};
                case Verb::wait:
                    retire();
                    if (!pending_.empty() && !masked_) {
                        ++cycles;
                        continue;
                    }
                    return {isa::StopReason::wait, cycles + 1, {}};
                case Verb::halt:
                    retire();
                    return {isa::StopReason::halt, cycles + 1, {}};
                case Verb::trap:
                    return {isa::StopReason::trap, cycles + 1,
                            isa::Trap{"odd address", pc_, 0123, 4}};
                default:
                    cycles += op.verb == Verb::work ? op.c : 1;
                    execute(op);
            }
        }
        return {isa::StopReason::budget, cycles, {}};
    }

    isa::Stop step(isa::Bus& bus) override {
        take_interrupt();
        const Operation& op = program_[pc_];
        const std::uint32_t address = op.c + 020 * registers_[op.b & 7U];
        isa::Bus::Status status = isa::Bus::Status::ok;
        if (op.verb == Verb::load) {
            const auto read = bus.read(address, 2);
            status = read.status;
            if (status == isa::Bus::Status::ok) {
                registers_[op.a] = read.value;
            }
        } else if (op.verb == Verb::store) {
            status = bus.write(address, registers_[op.a], 2);
        } else if (op.verb == Verb::store_byte) {
            status = bus.write(address, registers_[op.a] & 0377U, 1);
        } else if (op.verb == Verb::move) {
            const auto read = bus.read(op.c, 2);
            status =
                read.status == isa::Bus::Status::ok ? bus.write(op.b, read.value, 2) : read.status;
        } else {
            tap_told_ = true;
            return run(1);  // an interrupt came first
        }
        if (status == isa::Bus::Status::retry) {
            return {isa::StopReason::retry, 0, {}};
        }
        if (status == isa::Bus::Status::fault) {
            return {isa::StopReason::trap, 1, isa::Trap{"bus error", pc_, address, 4}};
        }
        retire();
        return {isa::StopReason::budget, 1, {}};
    }

    void request_interrupt(int, std::uint32_t vector) override { pending_.insert(vector); }
    void withdraw_interrupt(int, std::uint32_t vector) override { pending_.erase(vector); }
    bool interruptible() const override { return !masked_; }
    std::uint32_t program_counter() const override { return pc_; }
    void set_program_counter(std::uint32_t address) override { pc_ = address; }
    std::uint32_t reg(int index) const override {
        return registers_[static_cast<std::size_t>(index)];
    }
    void set_reg(int index, std::uint32_t value) override {
        registers_[static_cast<std::size_t>(index)] = value;
    }
    std::span<const std::uint8_t> memory() const override { return memory_; }
    void write_memory(std::uint32_t address, std::span<const std::uint8_t> bytes) override {
        std::copy(bytes.begin(), bytes.end(), memory_.begin() + address);
    }
    std::int64_t instructions_retired() const override { return retired_; }
    void set_taps(std::span<const std::uint32_t> addresses) override {
        taps_ = {addresses.begin(), addresses.end()};
        tap_told_ = false;
    }

  private:
    void retire() {
        tap_told_ = false;
        ++pc_;
        ++retired_;
    }
    void take_interrupt() {
        if (!masked_ && !pending_.empty()) {
            return_to_ = pc_;
            pc_ = handlers.at(*pending_.begin());
            pending_.erase(pending_.begin());
            masked_ = true;
            tap_told_ = false;
        }
    }
    void execute(const Operation& op) {
        std::uint32_t& a = registers_[op.a & 7U];
        retire();
        switch (op.verb) {
            case Verb::set:
                a = op.c;
                break;
            case Verb::add:
                a = (a + op.c) & 0177777U;
                break;
            case Verb::random:
                random_ = random_ * 1664525U + 1013904223U;
                a = (random_ >> 8U) % op.c;
                break;
            case Verb::poke:
                memory_[op.c] = static_cast<std::uint8_t>(a & 0377U);
                break;
            case Verb::peek:
                a = memory_[op.c];
                break;
            case Verb::jump:
                pc_ = op.c;
                break;
            case Verb::jump_if_zero:
                pc_ = a == 0 ? op.c : pc_;
                break;
            case Verb::jump_if_equal:
                pc_ = a == registers_[op.b] ? op.c : pc_;
                break;
            case Verb::jump_if_clear:
                pc_ = (a & op.b) == 0 ? op.c : pc_;
                break;
            case Verb::interrupts_off:
                masked_ = true;
                break;
            case Verb::interrupts_on:
                masked_ = false;
                break;
            case Verb::return_from_interrupt:
                pc_ = return_to_;
                masked_ = false;
                break;
            default:
                break;
        }
    }

    Program program_;
    std::uint32_t random_;
    std::array<std::uint32_t, 8> registers_{};
    std::vector<std::uint8_t> memory_;
    std::uint32_t pc_ = 0;
    std::uint32_t return_to_ = 0;
    std::int64_t retired_ = 0;
    bool masked_ = false;
    std::set<std::uint32_t> pending_;
    std::set<std::uint32_t> taps_;
    bool tap_told_ = false;
};

}  // namespace rasterloom
