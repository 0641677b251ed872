// SPDX-License-Identifier: MIT
// The manual's tables are the instruction table's rows.
#include "isa/vliw/instruction_table.hpp"

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rasterloom::isa::vliw {
namespace {

std::string operands_of(Format format) {
    switch (format) {
        case Format::none:
            return "";
        case Format::target:
            return " l";
        case Format::number:
        case Format::count:
            return " n";
        case Format::counter:
            return " c";
        case Format::counter_number:
            return " c, n";
        case Format::counter_target:
            return " c, l";
        case Format::three:
            return " d, a, b";
        case Format::two:
            return " d, b";
        case Format::one:
            return " r";
        case Format::test:
            return " a, b";
        case Format::product:
            return " d, a, b, n";
        case Format::fast:
            return " r, m";
        case Format::slow:
            return " r, bank, m";
    }
    return " ?";
}

TEST(VliwManual, ListsEveryOperationWithItsCodeAndNoOther) {
    std::set<std::string> expected;
    for (const InstructionRow& row : instruction_table()) {
        if (row.slot != static_cast<int>(Slot::nothing)) {
            expected.insert(fmt::format("| `{}{}` | {} | {} |", row.mnemonic,
                                        operands_of(static_cast<Format>(row.format)), row.operation,
                                        row.summary));
        }
    }
    std::set<std::string> found;
    std::ifstream manual(std::filesystem::path(RASTERLOOM_SOURCE_DIR) / "docs/vliw.md");
    bool operations = false;
    for (std::string line; std::getline(manual, line);) {
        if (line.starts_with("## ")) {
            operations = line == "## Operations";
        }
        if (operations && line.starts_with("| `")) {
            EXPECT_TRUE(found.insert(line).second) << line;
        }
    }
    EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace rasterloom::isa::vliw
