// SPDX-License-Identifier: MIT
#include "isa/toy/instruction_table.hpp"

#include <algorithm>
#include <array>

namespace rasterloom::isa::toy {
namespace {

constexpr InstructionRow row(std::uint32_t mask, std::uint32_t match, std::string_view mnemonic,
                             Format format, Operation operation, std::string_view summary) {
    return {mask, match, mnemonic, static_cast<int>(format), static_cast<int>(operation), summary};
}

using O = Operation;

constexpr std::array kRows = {
    row(0xff, 0x00, "hlt", Format::none, O::hlt, "stop the processor"),
    row(0xff, 0x01, "wai", Format::none, O::wai, "wait for an interrupt"),
    row(0xff, 0x02, "nop", Format::none, O::nop, "no operation"),
    row(0xff, 0x03, "ei", Format::none, O::ei, "take interrupts from now on"),
    row(0xff, 0x04, "di", Format::none, O::di, "take no interrupts from now on"),
    row(0xff, 0x05, "rti", Format::none, O::rti, "return to l and take interrupts"),
    row(0xfc, 0x10, "lda", Format::load, O::lda, "load the accumulator"),
    row(0xfc, 0x14, "sta", Format::store, O::sta, "store the accumulator"),
    row(0xfc, 0x18, "add", Format::load, O::add, "add to the accumulator"),
    row(0xfc, 0x1c, "sub", Format::load, O::sub, "subtract from the accumulator"),
    row(0xff, 0x20, "ldx", Format::word, O::ldx, "load the index with a word"),
    row(0xff, 0x30, "jmp", Format::address, O::jmp, "jump"),
    row(0xff, 0x31, "beq", Format::address, O::beq, "branch if Z"),
    row(0xff, 0x32, "bne", Format::address, O::bne, "branch if not Z"),
    row(0xff, 0x33, "bcs", Format::address, O::bcs, "branch if C"),
    row(0xff, 0x34, "bcc", Format::address, O::bcc, "branch if not C"),
};

}  // namespace

std::span<const InstructionRow> instruction_table() {
    return kRows;
}

const InstructionRow* find_instruction(unsigned byte) {
    const auto found = std::find_if(kRows.begin(), kRows.end(), [&](const InstructionRow& r) {
        return (byte & r.mask) == r.match;
    });
    return found == kRows.end() ? nullptr : &*found;
}

int length_of(const InstructionRow& row, unsigned byte) {
    switch (static_cast<Format>(row.format)) {
        case Format::none:
            return 1;
        case Format::word:
        case Format::address:
            return 3;
        case Format::load:
        case Format::store:
            break;
    }
    const auto mode = static_cast<Mode>(byte & 3);
    if (mode == Mode::absolute) {
        return 3;
    }
    return mode == Mode::immediate && static_cast<Format>(row.format) == Format::load ? 2 : 1;
}

}  // namespace rasterloom::isa::toy
