// SPDX-License-Identifier: MIT
#include "tests/node/lockstep/agreement.hpp"

#include "tests/isa/vliw_random_programs.hpp"

#include <utility>

#include <fmt/format.h>

namespace rasterloom::testing {
namespace {

using isa::vliw::Interpreter;
using isa::vliw::testing::kWindow;
using isa::vliw::testing::kWindowWords;

// Keeps the first difference that it is shown.
class Comparison {
  public:
    void operator()(std::string_view what, std::int64_t number, std::int64_t is,
                    std::int64_t wanted) {
        if (is != wanted && text_.empty()) {
            text_ = fmt::format("{}{:x} is {} instead of {}", what, number, is, wanted);
        }
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

void compare_lane(const LockstepArray& array, const Interpreter& interpreter, std::int64_t lane,
                  Comparison& compare) {
    for (int reg = 0; reg < isa::vliw::kRegisters; ++reg) {
        compare("register ", reg, array.reg(lane, reg), interpreter.reg(lane, reg));
    }
    compare("C of lane ", lane, array.carry(lane), interpreter.carry(lane));
    compare("T of lane ", lane, array.test(lane), interpreter.test(lane));
    compare("sleep of lane ", lane, array.asleep(lane), interpreter.asleep(lane));
    compare("X of lane ", lane, array.communication(lane), interpreter.communication(lane));
    compare("video of lane ", lane, array.video(lane), interpreter.video(lane));
    compare("cycles awake of lane ", lane, array.awake_cycles(lane),
            interpreter.awake_cycles(lane));
    for (std::uint32_t bank = 0; bank <= isa::vliw::kSlowBanks; ++bank) {
        for (std::uint32_t i = 0; i < kWindowWords; ++i) {
            const std::uint32_t address = bank * isa::vliw::kBankWords + kWindow + i;
            compare("word ", address, array.read(lane, address), interpreter.read(lane, address));
        }
    }
}

}  // namespace

std::shared_ptr<const isa::vliw::Program> program_of(std::vector<isa::vliw::Bundle> bundles,
                                                     std::uint16_t entry) {
    auto program = std::make_shared<isa::vliw::Program>();
    program->bundles = std::move(bundles);
    program->entry = entry;
    return program;
}

isa::vliw::Bundle::Memory memory(isa::vliw::MemOp op, int bank, int reg, int base, int offset) {
    return {op, static_cast<std::uint8_t>(bank), static_cast<std::uint8_t>(reg),
            static_cast<std::uint8_t>(base), static_cast<std::uint16_t>(offset)};
}

std::string difference(const LockstepArray& array, const Interpreter& interpreter) {
    Comparison compare;
    compare("program counter ", 0, array.program_counter(), interpreter.program_counter());
    compare("procedure ", 0, array.procedure(), interpreter.procedure());
    compare("bundles ", 0, array.bundles_executed(), interpreter.bundles_executed());
    compare("operations ", 0, array.operations_executed(), interpreter.operations_executed());
    for (int counter = 0; counter < isa::vliw::kCounters; ++counter) {
        compare("counter ", counter, array.counter(counter), interpreter.counter(counter));
    }
    for (std::int64_t lane = 0; lane < array.lanes(); ++lane) {
        compare_lane(array, interpreter, lane, compare);
        if (!compare.text().empty()) {
            return fmt::format("lane {}: {}", lane, compare.text());
        }
    }
    return {};
}

LockstepArray::Stop run(Interpreter& interpreter, std::int64_t budget_cycles) {
    LockstepArray::Stop all;
    while (all.cycles < budget_cycles && all.reason == LockstepArray::Reason::budget) {
        const Interpreter::Stop stop = interpreter.step();
        all.reason = static_cast<LockstepArray::Reason>(stop.reason);
        all.cycles += stop.cycles;
        all.phase = stop.phase;
        all.trap = stop.trap;
    }
    return all;
}

bool same(const LockstepArray::Stop& a, const LockstepArray::Stop& b) {
    return a.reason == b.reason && a.cycles == b.cycles && a.phase == b.phase && a.trap == b.trap;
}

}  // namespace rasterloom::testing
