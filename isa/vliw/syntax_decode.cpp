// SPDX-License-Identifier: MIT
// A bundle from words to text.
#include "isa/vliw/instruction_table.hpp"
#include "isa/vliw/syntax.hpp"

#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rasterloom::isa::vliw {
namespace {

// Read the same in any radix.
std::string number(unsigned value) {
    return fmt::format("0x{:x}", value);
}
std::string reg(unsigned index) {
    return fmt::format("r{}", index);
}
std::string source(bool immediate, unsigned index, std::uint16_t value) {
    return immediate ? fmt::format("#{}", number(value)) : reg(index);
}

std::string address(const Bundle::Memory& mem) {
    const std::string offset = mem.offset == 0 && mem.base != 0 ? "" : number(mem.offset);
    return mem.base == 0 ? offset : fmt::format("{}({})", offset, reg(mem.base));
}

std::vector<std::string> operands(const Bundle& bundle, const InstructionRow& row) {
    const auto& [seq, alu, mul, mem, comm, sleep, immediate] = bundle;
    const std::string counter = fmt::format("c{}", seq.counter);
    const std::string alu_b = source(alu.immediate, alu.b, immediate);
    switch (static_cast<Format>(row.format)) {
        case Format::none:
            return {};
        case Format::target:
        case Format::number:
            return {number(seq.target)};
        case Format::counter:
            return {counter};
        case Format::counter_number:
        case Format::counter_target:
            return {counter, number(seq.target)};
        case Format::three:
            return {reg(alu.dst), reg(alu.a), alu_b};
        case Format::two:
            return {reg(alu.dst), alu_b};
        case Format::one:
            return {reg(row.slot == static_cast<int>(Slot::alu) ? alu.dst : comm.reg)};
        case Format::test:
            return {reg(alu.a), alu_b};
        case Format::product:
            return {reg(mul.dst), reg(mul.a), source(mul.immediate, mul.b, immediate),
                    number(mul.pick)};
        case Format::fast:
            return {reg(mem.reg), address(mem)};
        case Format::slow:
            return {reg(mem.reg), number(mem.bank), address(mem)};
        case Format::count:
            return {number(comm.count)};
    }
    return {};
}

DecodedText as_data(std::span<const std::uint16_t> words) {
    std::vector<std::string> values;
    for (const std::uint16_t word : words) {
        values.push_back(number(word));
    }
    return {fmt::format(".word {}", fmt::join(values, ", ")), static_cast<int>(words.size())};
}

}  // namespace

// What the assembler would refuse is data: words that are no bundle, bundles that cannot be
// executed.
DecodedText decode_instruction(std::span<const std::uint16_t> words) {
    if (words.size() < kWordsPerBundle) {
        return as_data(words.first(1));
    }
    const auto nine = words.first<kWordsPerBundle>();
    const auto bundle = decode(nine);
    if (!bundle || conflict(*bundle)) {
        return as_data(nine);
    }
    std::vector<std::string> operations;
    for (const Slot slot : {Slot::sleep, Slot::alu, Slot::multiplier, Slot::memory,
                            Slot::communication, Slot::sequencer}) {
        if (const InstructionRow* row = row_in(nine, slot)) {
            const auto parts = operands(*bundle, *row);
            operations.push_back(fmt::format("{}{}{}", row->mnemonic, parts.empty() ? "" : " ",
                                             fmt::join(parts, ", ")));
        }
    }
    return {operations.empty() ? "nop" : fmt::format("{}", fmt::join(operations, " | ")),
            kWordsPerBundle};
}

}  // namespace rasterloom::isa::vliw
