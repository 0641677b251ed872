// SPDX-License-Identifier: MIT
#include "isa/vliw/core.hpp"

#include <array>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::isa::vliw {

LaneCore::LaneCore(std::shared_ptr<const Program> program)
    : program_(std::move(program)), lane_(program_, 1) {}

Stop LaneCore::run(std::int64_t budget_cycles) {
    std::int64_t cycles = 0;
    while (cycles < budget_cycles) {
        const std::size_t pc = lane_.program_counter();
        if (!tap_told_ && pc < tapped_.size() && tapped_[pc]) {
            tap_told_ = true;
            return {StopReason::tap, cycles, std::nullopt};
        }
        Stop stop = execute();
        cycles += stop.cycles;
        if (stop.reason != StopReason::budget) {
            stop.cycles = cycles;
            return stop;
        }
    }
    return {StopReason::budget, cycles, std::nullopt};
}

Stop LaneCore::step(Bus&) {
    return execute();
}

Stop LaneCore::execute() {
    const std::uint32_t pc = lane_.program_counter();
    Interpreter::Stop stop = lane_.step();
    if (stop.reason == Interpreter::Reason::trap) {
        return {StopReason::trap, 0, Trap{std::move(stop.trap), pc, pc, 0}};
    }
    tap_told_ = false;
    const bool halted = stop.reason == Interpreter::Reason::halt;
    return {halted ? StopReason::halt : StopReason::budget, stop.cycles, std::nullopt};
}

void LaneCore::set_program_counter(std::uint32_t address) {
    lane_.set_program_counter(static_cast<std::uint16_t>(address));
    tap_told_ = false;
}

std::uint32_t LaneCore::reg(int index) const {
    return index < kRegisters ? lane_.reg(0, index) : lane_.counter(index - kRegisters);
}

void LaneCore::set_reg(int index, std::uint32_t value) {
    const auto word = static_cast<std::uint16_t>(value);
    if (index < kRegisters) {
        lane_.set_reg(0, index, word);
    } else {
        lane_.set_counter(index - kRegisters, word);
    }
}

std::span<const std::uint8_t> LaneCore::memory() const {
    bytes_.clear();
    bytes_.reserve(kMemoryBytes);
    for (std::uint32_t address = 0; address < kMemoryWords; ++address) {
        const std::uint16_t word = lane_.read(0, address);
        bytes_.push_back(static_cast<std::uint8_t>(word & 0xff));
        bytes_.push_back(static_cast<std::uint8_t>(word >> 8));
    }
    return bytes_;
}

void LaneCore::write_memory(std::uint32_t address, std::span<const std::uint8_t> bytes) {
    if (address > kMemoryBytes || bytes.size() > kMemoryBytes - address) {
        throw std::out_of_range(
            fmt::format("{} bytes at {}: a lane has {}", bytes.size(), address, kMemoryBytes));
    }
    for (const std::uint8_t byte : bytes) {
        const std::uint32_t word = address / 2;
        const int shift = address % 2 == 0 ? 0 : 8;
        const unsigned others = lane_.read(0, word) & (0xff00U >> shift);
        lane_.write(0, word,
                    std::array{static_cast<std::uint16_t>(others | unsigned{byte} << shift)});
        ++address;
    }
}

void LaneCore::set_taps(std::span<const std::uint32_t> addresses) {
    std::vector<bool> tapped(addresses.empty() ? 0 : program_->bundles.size());
    for (const std::uint32_t address : addresses) {
        if (address >= tapped.size()) {
            throw std::invalid_argument(fmt::format("a tap at {}, where no bundle is", address));
        }
        tapped[address] = true;
    }
    tapped_ = std::move(tapped);
    tap_told_ = false;
}

}  // namespace rasterloom::isa::vliw
