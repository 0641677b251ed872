// SPDX-License-Identifier: MIT
// SIMH's PDP-11 as a reference: a script of sequences is run by one process, and its printout read
// back.
#pragma once

#include "tests/isa/pdp11_random.hpp"
#include "tests/temporary_folder.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace rasterloom::isa::testing {

// What a machine looks like after a sequence: r0 to r5, sp, pc, psw, and chosen words of memory.
struct SimhState {
    std::array<std::uint16_t, 9> registers{};
    std::vector<std::uint16_t> words;
    friend bool operator==(const SimhState&, const SimhState&) = default;
};

class SimhScript {
  public:
    static bool available();

    // The machine starts with this memory.
    explicit SimhScript(const std::vector<std::uint8_t>& memory);
    SimhScript(const SimhScript&) = delete;
    SimhScript& operator=(const SimhScript&) = delete;

    void deposit(std::uint32_t address, std::uint16_t word);
    void start(const RandomStart& start);
    void step(std::size_t instructions);
    // Prints the registers and these words; an answer in run()'s result.
    void examine(const std::vector<std::uint32_t>& addresses);

    std::vector<SimhState> run();

  private:
    TemporaryFolder folder_;
    std::string text_;
    std::vector<std::size_t> counts_;  // words each examine asks for
};

}  // namespace rasterloom::isa::testing
