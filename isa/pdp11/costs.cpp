// SPDX-License-Identifier: MIT
#include "isa/pdp11/costs.hpp"

#include "isa/cost_choice.hpp"
#include "isa/pdp11/alu.hpp"
#include "isa/pdp11/instruction_table.hpp"

#include <map>
#include <string_view>

namespace rasterloom::isa::pdp11 {
namespace {

const std::vector<CostModelInfo>& models() {
    static const std::vector<CostModelInfo> table = {
        {"parks",
         "memory cycles, Parks 1982, appendix B",
         {{"autoincrement", 1, "more for an auto-increment operand; a real PDP-11 spends 0"},
          {"multiply", 10, "MUL in all, whatever its operands"},
          {"divide", 10, "DIV in all, whatever its operands"},
          {"trap", 4, "taking a trap or interrupt: two words pushed, two fetched"}}},
        {"strothotte",
         "units u, Strothotte 1981, 5.3",
         {{"arithmetic", 1, "add, subtract, compare, logic, shift, test"},
          {"multiply", 10, "MUL"},
          {"divide", 10, "DIV"},
          {"move", 1, "MOV, CLR, SWAB; the thesis counts 0"},
          {"branch", 1, "branches, jumps, calls, returns; the thesis counts 0"},
          {"trap", 4, "taking a trap or interrupt"}}},
    };
    return table;
}

bool is_trap_instruction(Operation op) {
    using enum Operation;
    return op == bpt || op == iot || op == emt || op == trap;
}

bool is_branch_class(const InstructionRow& row, Operation op) {
    using enum Operation;
    if (static_cast<Format>(row.format) == Format::branch)
        return true;
    switch (op) {
        case jmp:
        case jsr:
        case rts:
        case mark:
        case rti:
        case rtt:
        case bpt:
        case iot:
        case emt:
        case trap:
        case halt:
        case wait:
        case reset:
            return true;
        default:
            return false;
    }
}

bool is_move_class(Operation op) {
    using enum Operation;
    return op == mov || op == movb || op == clr || op == clrb || op == swab;
}

}  // namespace

std::span<const CostModelInfo> cost_models() {
    return models();
}

CostModel::CostModel(const CostChoice& choice) {
    const ResolvedCosts resolved = resolve_costs("pdp11", models(), choice);
    const CostModelInfo& info = models()[resolved.model];
    kind_ = info.name == "parks" ? Kind::parks : Kind::strothotte;
    std::map<std::string_view, std::int64_t> values;
    for (std::size_t i = 0; i < resolved.values.size(); ++i)
        values.emplace(info.parameters[i].name, resolved.values[i]);
    // A parameter the model does not have stays 0 and is not used.
    autoincrement_ = values["autoincrement"];
    arithmetic_ = values["arithmetic"];
    multiply_ = values["multiply"];
    divide_ = values["divide"];
    move_ = values["move"];
    branch_ = values["branch"];
    trap_ = values["trap"];
}

std::optional<InstructionCost> CostModel::cost_of(unsigned word) const {
    const InstructionRow* row = find_instruction(word);
    if (row == nullptr)
        return std::nullopt;
    return kind_ == Kind::parks ? parks_cost(*row, word) : strothotte_cost(*row);
}

std::int64_t CostModel::attempt() const {
    return kind_ == Kind::parks ? 1 : branch_;
}

InstructionCost CostModel::parks_operand(int mode_and_register, bool written, bool jump) const {
    const int mode = mode_and_register >> 3;
    const bool pc = (mode_and_register & 7) == 7;
    // A jump goes to its operand's address and does not access what is there.
    const std::int64_t target = jump ? 0 : 1;
    switch (mode) {
        case 0:
            return {0, 0};
        case 2:
            return pc ? InstructionCost{1, written ? target : 0}
                      : InstructionCost{autoincrement_, target};
        case 3:
            return pc ? InstructionCost{1, target} : InstructionCost{autoincrement_, 1 + target};
        case 5:
            return {0, 1 + target};
        case 6:
            return {1, target};
        case 7:
            return {1, 1 + target};
        default:
            return {0, target};
    }
}

InstructionCost CostModel::parks_cost(const InstructionRow& row, unsigned word) const {
    using enum Operation;
    const auto op = static_cast<Operation>(row.operation);
    InstructionCost cost{1, 0};
    const auto add_operand = [&](unsigned bits, bool written, bool jump) {
        const InstructionCost operand = parks_operand(static_cast<int>(bits & 077U), written, jump);
        cost.fetch += operand.fetch;
        cost.data += operand.data;
    };
    if (op == mul)
        return {multiply_, 0};
    if (op == div)
        return {divide_, 0};
    if (is_trap_instruction(op))
        return {1, trap_};
    if (op == rts || op == mark)
        return {1, 1};
    if (op == rti || op == rtt)
        return {1, 2};
    switch (static_cast<Format>(row.format)) {
        case Format::twofold:
            add_operand(word >> 6, false, false);
            add_operand(word, !only_reads(op), false);
            break;
        case Format::single:
            add_operand(word, !only_reads(op), op == jmp);
            break;
        case Format::register_dst:
            add_operand(word, true, op == jsr);
            if (op == jsr)
                cost.data += 1;
            break;
        case Format::register_src:
            add_operand(word, false, false);
            break;
        default:
            break;
    }
    return cost;
}

InstructionCost CostModel::strothotte_cost(const InstructionRow& row) const {
    const auto op = static_cast<Operation>(row.operation);
    if (op == Operation::mul)
        return {0, multiply_};
    if (op == Operation::div)
        return {0, divide_};
    if (op == Operation::sob)
        return {0, arithmetic_ + branch_};
    if (is_trap_instruction(op))
        return {0, branch_ + trap_};
    if (is_branch_class(row, op))
        return {0, branch_};
    if (is_move_class(op))
        return {0, move_};
    return {0, arithmetic_};
}

CostTable::CostTable(const CostChoice& choice) {
    const CostModel model(choice);
    trap_ = model.trap();
    for (unsigned word = 0; word < cycles_.size(); ++word) {
        const auto cost = model.cost_of(word);
        cycles_[word] = static_cast<std::uint16_t>(cost ? cost->total() : model.attempt());
    }
}

}  // namespace rasterloom::isa::pdp11
