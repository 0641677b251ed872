// SPDX-License-Identifier: MIT
// What the PDP-11 core's tests share: a core made from source text or words, and a bus to script.
#pragma once

#include "isa/assembler.hpp"
#include "isa/pdp11/core.hpp"
#include "isa/pdp11/pdp11.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace rasterloom::isa::testing {

inline constexpr int kSp = 6;
inline constexpr int kPc = 7;
inline constexpr int kPsw = pdp11::kStatusRegister;

inline Image image_of(std::string_view source) {
    const Assembly assembly = assemble_text(pdp11::pdp11_isa(), "t.s", source);
    EXPECT_TRUE(assembly.ok()) << to_string(assembly.diagnostics);
    return assembly.image;
}

inline std::unique_ptr<pdp11::Pdp11Core> core_of(const Image& image,
                                                 const CoreOptions& options = {},
                                                 const CostChoice& cost = {}) {
    return std::make_unique<pdp11::Pdp11Core>(std::make_shared<const pdp11::Program>(image, cost),
                                              options);
}

// The source starts at 01000 unless it says otherwise; the stack stands below.
inline std::unique_ptr<pdp11::Pdp11Core> core_of(std::string_view source,
                                                 const CoreOptions& options = {},
                                                 const CostChoice& cost = {}) {
    auto core =
        core_of(image_of(std::string("        . = 1000\n") + std::string(source)), options, cost);
    core->set_program_counter(01000);
    core->set_reg(kSp, 01000);
    core->set_reg(kPsw, 0);
    return core;
}

inline unsigned word_at(const Core& core, std::uint32_t address) {
    return core.memory()[address] | unsigned{core.memory()[address + 1]} << 8;
}

inline void put_word(Core& core, std::uint32_t address, unsigned value) {
    const std::uint8_t bytes[] = {static_cast<std::uint8_t>(value),
                                  static_cast<std::uint8_t>(value >> 8)};
    core.write_memory(address, bytes);
}

// Answers from a map of words; keeps a list of what was asked.
class ScriptedBus : public Bus {
  public:
    Read read(std::uint32_t address, int bytes) override {
        asked.push_back({'r', address});
        if (retries > 0 && retries-- > 0)
            return {Status::retry, 0};
        const auto found = words.find(address);
        if (found == words.end())
            return {Status::fault, 0};
        return {Status::ok, bytes == 1 ? found->second & 0377U : found->second};
    }
    Status write(std::uint32_t address, std::uint32_t value, int) override {
        asked.push_back({'w', address});
        if (retries > 0 && retries-- > 0)
            return Status::retry;
        if (!words.contains(address))
            return Status::fault;
        words[address] = value;
        return Status::ok;
    }
    std::map<std::uint32_t, std::uint32_t> words;
    std::vector<std::pair<char, std::uint32_t>> asked;
    int retries = 0;
};

}  // namespace rasterloom::isa::testing
