// SPDX-License-Identifier: MIT
// A lock-step array and the interpreter side by side.
#pragma once

#include "isa/vliw/interpreter.hpp"
#include "machine/node/lockstep/lockstep_array.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace rasterloom::testing {

std::shared_ptr<const isa::vliw::Program> program_of(std::vector<isa::vliw::Bundle> bundles,
                                                     std::uint16_t entry = 0);

constexpr std::int64_t kMuch = 1'000'000;  // cycles; more than a test's program takes

isa::vliw::Bundle::Memory memory(isa::vliw::MemOp op, int bank, int reg, int base, int offset);

// The first difference in what both know of sequencer and lanes, memory 0x100 ... 0x13f of all
// banks included; empty if there is none.
std::string difference(const LockstepArray& array, const isa::vliw::Interpreter& interpreter);

// The interpreter does what array.run(budget) has to do.
LockstepArray::Stop run(isa::vliw::Interpreter& interpreter, std::int64_t budget_cycles);
bool same(const LockstepArray::Stop& a, const LockstepArray::Stop& b);

// All arrays compute by this path for as long as the object lives.
class OnPath {
  public:
    explicit OnPath(const std::string& path) { LockstepArray::use_path(path); }
    ~OnPath() { LockstepArray::use_path(before_); }
    OnPath(const OnPath&) = delete;
    OnPath& operator=(const OnPath&) = delete;

  private:
    std::string before_ = LockstepArray::paths().front();
};

}  // namespace rasterloom::testing
