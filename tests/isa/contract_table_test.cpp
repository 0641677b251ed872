// SPDX-License-Identifier: MIT
// The contract of every instruction set, its table, texts and costs.
#include "isa/disassembler.hpp"
#include "isa/syntax.hpp"
#include "tests/isa/contract.hpp"

#include <algorithm>
#include <functional>
#include <random>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::isa::testing {
namespace {

using ::testing::HasSubstr;

std::string complaint(const std::function<void()>& action) {
    try {
        action();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "no error";
}

// A choice of each model with all its parameters at one value; -1 leaves them as they are.
CostChoice choice_of(const CostModelInfo& model, std::int64_t value) {
    CostChoice choice{std::string(model.name), {}};
    for (const CostParameter& parameter : model.parameters) {
        if (value >= 0) {
            choice.overrides.emplace(parameter.name, value);
        }
    }
    return choice;
}

// The longest instruction words there are.
constexpr std::size_t kWideWords = 9;

TEST_P(Contract, RowsOverlapOnlyWhereAReasonIsGiven) {
    std::set<std::pair<std::string, std::string>> found;
    const auto rows = isa().instructions();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t j = i + 1; j < rows.size(); ++j) {
            if (rows[i].slot == rows[j].slot &&
                ((rows[i].match ^ rows[j].match) & rows[i].mask & rows[j].mask) == 0) {
                found.emplace(rows[i].mnemonic, rows[j].mnemonic);
            }
        }
    }
    std::set<std::pair<std::string, std::string>> allowed;
    for (const AllowedOverlap& overlap : GetParam().overlaps) {
        EXPECT_FALSE(overlap.reason.empty());
        allowed.emplace(overlap.first, overlap.second);
    }
    EXPECT_EQ(found, allowed) << "an overlap without a reason, or a reason no longer needed";
}

TEST_P(Contract, EveryRowIsDocumentedAndWellFormed) {
    std::set<std::string_view> names;
    for (const InstructionRow& row : isa().instructions()) {
        EXPECT_FALSE(row.mnemonic.empty());
        EXPECT_FALSE(row.summary.empty()) << row.mnemonic;
        EXPECT_TRUE(names.insert(row.mnemonic).second) << row.mnemonic << " stands twice";
        EXPECT_EQ(row.match & ~row.mask, 0U) << row.mnemonic;
        EXPECT_TRUE(row.slot != 0 || row.mask < 1ULL << isa().word_bits()) << row.mnemonic;
    }
    EXPECT_FALSE(isa().summary().empty());
    for (const CostModelInfo& model : isa().cost_models()) {
        EXPECT_FALSE(model.summary.empty()) << model.name;
        for (const CostParameter& parameter : model.parameters) {
            EXPECT_FALSE(parameter.summary.empty()) << parameter.name;
        }
    }
}

TEST_P(Contract, AliasesNameInstructions) {
    for (const MnemonicAlias& alias : isa().syntax().aliases()) {
        EXPECT_TRUE(
            std::any_of(isa().instructions().begin(), isa().instructions().end(),
                        [&](const InstructionRow& row) { return row.mnemonic == alias.mnemonic; }))
            << alias.name;
    }
}

TEST_P(Contract, RegisterNamesHaveTheirNumbers) {
    const auto names = isa().register_names();
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (const auto number = isa().syntax().register_number(names[i])) {
            EXPECT_EQ(*number, static_cast<int>(i)) << names[i];
        }
    }
}

TEST_P(Contract, DisassemblyOfEveryFirstWordAssemblesToTheSameWords) {
    std::mt19937 random(5);
    const std::uint32_t address = 512;
    const unsigned words_there_are = 1U << isa().word_bits();
    for (unsigned first = 0; first < words_there_are; ++first) {
        std::vector<std::uint16_t> words = {static_cast<std::uint16_t>(first)};
        while (words.size() < (wide() ? kWideWords : 4)) {
            words.push_back(wide() ? 0 : static_cast<std::uint16_t>(random() % words_there_are));
        }
        const DecodedText decoded = isa().syntax().decode(words, address);
        const Assembly assembly =
            assemble_text(isa(), "t.s", fmt::format(". = ^D{}\n{}\n", address, decoded.text));
        ASSERT_TRUE(assembly.ok()) << decoded.text << '\n' << to_string(assembly.diagnostics);
        ASSERT_EQ(words_of_bytes(assembly.image.segments.at(0).bytes, isa().word_bits()),
                  std::vector(words.begin(), words.begin() + decoded.words))
            << decoded.text;
        const bool known =
            std::any_of(isa().instructions().begin(), isa().instructions().end(),
                        [&](const InstructionRow& row) { return (first & row.mask) == row.match; });
        ASSERT_TRUE(wide() || known == !decoded.text.starts_with('.')) << decoded.text;
    }
}

TEST_P(Contract, CostsAreNeverNegativeAndOnlyInstructionsHaveThem) {
    for (const CostModelInfo& model : isa().cost_models()) {
        for (const std::int64_t value : {-1, 0, 7}) {
            const CostChoice choice = choice_of(model, value);
            for (unsigned first = 0; first < 1U << isa().word_bits(); first += value < 0 ? 1 : 61) {
                const std::array<std::uint16_t, kWideWords> words = {
                    static_cast<std::uint16_t>(first)};
                const auto cost = isa().cost_of(words, choice);
                ASSERT_EQ(cost.has_value(), !isa().syntax().decode(words, 0).text.starts_with('.'))
                    << first;
                if (cost) {
                    ASSERT_GE(cost->fetch, 0) << first;
                    ASSERT_GE(cost->data, 0) << first;
                }
            }
        }
    }
}

TEST_P(Contract, AnUnknownCostParameterIsAnErrorThatNamesTheValidOnes) {
    for (const CostModelInfo& model : isa().cost_models()) {
        for (const CostParameter& parameter : model.parameters) {
            const std::string misspelt = std::string(parameter.name) + "x";
            const CostChoice choice{std::string(model.name), {{misspelt, 1}}};
            const std::string said = complaint([&] { isa().prepare({}, choice); });
            EXPECT_THAT(said, HasSubstr("'" + misspelt + "'"));
            EXPECT_THAT(said, HasSubstr(fmt::format("did you mean '{}'?", parameter.name)));
            const CostChoice negative{std::string(model.name), {{std::string(parameter.name), -1}}};
            EXPECT_THAT(complaint([&] { isa().prepare({}, negative); }),
                        HasSubstr(std::string(parameter.name)));
        }
    }
    const std::string said = complaint([&] { isa().prepare({}, {"nonesuch", {}}); });
    EXPECT_THAT(said, HasSubstr("'nonesuch'"));
    EXPECT_THAT(said, HasSubstr(std::string(isa().cost_models()[0].name)));
}

INSTANTIATE_TEST_SUITE_P(EveryIsa, Contract, ::testing::ValuesIn(subjects()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace rasterloom::isa::testing
