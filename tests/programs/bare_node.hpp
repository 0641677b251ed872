// SPDX-License-Identifier: MIT
// One node's core with the program in its memory, whose routines a test calls one by one. Its ports
// always have room, no message ever waits, and what the program sends is kept.
#pragma once

#include "isa/core.hpp"
#include "isa/image.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::test {

class BareNode final : private isa::Bus {
  public:
    struct Sent {
        int port = 0;
        std::vector<std::uint8_t> bytes;
    };
    struct Registers {
        std::array<std::uint16_t, 6> r{};
        std::uint16_t& operator[](int index) { return r[static_cast<std::size_t>(index)]; }
        std::uint16_t operator[](int index) const { return r[static_cast<std::size_t>(index)]; }
    };

    // The program of strothotte_image() with `segments` written over it.
    explicit BareNode(const std::vector<isa::Segment>& segments);

    // Calls the routine of that name as `jsr pc` would; returns its registers. Throws
    // std::runtime_error when it traps, halts elsewhere or does not return within a million
    // instructions.
    Registers call(std::string_view routine, const Registers& registers);
    Registers call(std::string_view routine) { return call(routine, Registers()); }

    std::uint16_t word(std::uint32_t address) const;
    std::uint16_t word(std::string_view symbol, std::uint32_t offset = 0) const;
    void set_word(std::uint32_t address, int value);
    void set_word(std::string_view symbol, int value, std::uint32_t offset = 0);
    void set_bytes(std::uint32_t address, std::span<const std::uint8_t> bytes);
    std::uint8_t byte(std::uint32_t address) const { return core_->memory()[address]; }
    static std::uint32_t symbol(std::string_view name);

    const std::vector<Sent>& sent() const { return sent_; }
    int credit() const { return credit_; }
    std::int64_t cycles() const { return cycles_; }

  private:
    Read read(std::uint32_t address, int bytes) override;
    Status write(std::uint32_t address, std::uint32_t value, int bytes) override;

    std::unique_ptr<isa::Core> core_;
    std::uint32_t transmit_address_ = 0;
    std::vector<Sent> sent_;
    int credit_ = 0;
    std::int64_t cycles_ = 0;
};

}  // namespace rasterloom::test
