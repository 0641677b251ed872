// SPDX-License-Identifier: MIT
// What an instruction costs, by its first word alone: cost never depends on operands.
//
// Model `parks` (Parks 1982, appendix B): memory cycles. Every word of the instruction is one
// fetch; every access to memory data is one data cycle, and a memory operand that is read and
// written back counts once (core memory's read-pause-write). An immediate or absolute word is an
// instruction word, not data. JMP and JSR access their target's pointers only; pushes, pops and the
// four accesses of a trap are data.
//
// Model `strothotte` (Strothotte 1981, 5.3): units u, by class of operation:
//   multiply    MUL
//   divide      DIV
//   move        MOV CLR SWAB and their byte forms
//   branch      branches, JMP, JSR, RTS, MARK, RTI, RTT, traps, HALT, WAIT, RESET
//   arithmetic  everything else; SOB is one arithmetic and one branch
#pragma once

#include "isa/isa.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace rasterloom::isa::pdp11 {

std::span<const CostModelInfo> cost_models();

// A model with its parameters: the cost of any instruction, worked out.
class CostModel {
  public:
    // Throws std::invalid_argument as Isa::prepare does.
    explicit CostModel(const CostChoice& choice);

    // Empty for a reserved instruction.
    std::optional<InstructionCost> cost_of(unsigned word) const;
    // Of a word that is no instruction: the attempt to execute it.
    std::int64_t attempt() const;
    // Of the sequence that takes a trap or an interrupt; for the trap instructions it is part of
    // their cost.
    std::int64_t trap() const { return trap_; }

  private:
    enum class Kind { parks, strothotte };

    InstructionCost parks_cost(const InstructionRow& row, unsigned word) const;
    InstructionCost parks_operand(int mode_and_register, bool written, bool jump) const;
    InstructionCost strothotte_cost(const InstructionRow& row) const;

    Kind kind_ = Kind::parks;
    std::int64_t autoincrement_ = 0;
    std::int64_t arithmetic_ = 0;
    std::int64_t multiply_ = 0;
    std::int64_t divide_ = 0;
    std::int64_t move_ = 0;
    std::int64_t branch_ = 0;
    std::int64_t trap_ = 0;
};

// The same looked up.
class CostTable {
  public:
    explicit CostTable(const CostChoice& choice);

    // Cycles of any first word; a reserved instruction costs the attempt.
    std::int64_t attempt(unsigned word) const { return cycles_[word & 0xFFFFU]; }
    std::int64_t trap() const { return trap_; }

  private:
    std::int64_t trap_ = 0;
    std::array<std::uint16_t, 65536> cycles_{};
};

}  // namespace rasterloom::isa::pdp11
