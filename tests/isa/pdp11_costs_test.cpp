// SPDX-License-Identifier: MIT
#include "isa/pdp11/costs.hpp"
#include "tests/isa/pdp11_machine.hpp"

#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace rasterloom::isa::testing {
namespace {

std::vector<std::uint16_t> words_of_instruction(const std::string& text) {
    const Image image = image_of(text + "\n");
    std::vector<std::uint16_t> words;
    const auto& bytes = image.segments.at(0).bytes;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        words.push_back(static_cast<std::uint16_t>(bytes[i] | (bytes[i + 1] << 8)));
    }
    return words;
}

InstructionCost cost_of(const std::string& text, const CostChoice& choice = {}) {
    const auto cost = pdp11::pdp11_isa().cost_of(words_of_instruction(text), choice);
    EXPECT_TRUE(cost.has_value()) << text;
    return cost.value_or(InstructionCost{});
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

// A form of the table as an instruction: R becomes a register, X an index, # a number.
std::string instruction_of(std::string form) {
    replace_all(form, "any", "(R)+");
    replace_all(form, "R", "r3");
    replace_all(form, "X", "6");
    replace_all(form, "#", "#6");
    replace_all(form, "near", ".+4");
    return form;
}

struct Row {
    std::string form;
    std::int64_t fetch = 0;
    std::int64_t data = 0;
};

std::vector<Row> parks_rows() {
    std::ifstream file(std::string(RASTERLOOM_SOURCE_DIR) + "/tests/isa/parks-costs.csv");
    std::vector<Row> rows;
    std::string line;
    // "form",fetch,data
    while (std::getline(file, line)) {
        const auto quote = line.rfind('"');
        if (!line.starts_with('"')) {
            continue;
        }
        std::istringstream numbers(line.substr(quote + 2));
        Row row;
        row.form = line.substr(1, quote - 1);
        char comma = 0;
        numbers >> row.fetch >> comma >> row.data;
        rows.push_back(row);
    }
    return rows;
}

TEST(ParksCosts, AgreeWithEveryRowOfTheThesis) {
    const auto rows = parks_rows();
    ASSERT_EQ(rows.size(), 39U);
    for (const Row& row : rows) {
        InstructionCost cost{};
        if (row.form == "bcc far") {
            const InstructionCost around = cost_of("bcs .+6");
            const InstructionCost jump = cost_of("jmp @#2000");
            cost = {around.fetch + jump.fetch, around.data + jump.data};
        } else {
            cost = cost_of(instruction_of(row.form));
        }
        EXPECT_EQ(cost.fetch, row.fetch) << row.form;
        EXPECT_EQ(cost.data, row.data) << row.form;
    }
}

TEST(ParksCosts, LeaveTheAutoIncrementConventionToTheUser) {
    EXPECT_EQ(cost_of("cmp (r1)+, (r2)+").total(), 5);
    EXPECT_EQ(cost_of("cmp (r1)+, (r2)+", {"parks", {{"autoincrement", 0}}}).total(), 3);
}

TEST(ParksCosts, CountPushesPopsPointersAndTraps) {
    EXPECT_EQ(cost_of("jsr pc, @#2000").total(), 3);
    EXPECT_EQ(cost_of("rts pc").total(), 2);
    EXPECT_EQ(cost_of("rti").total(), 3);
    EXPECT_EQ(cost_of("jmp (r1)").total(), 1);
    EXPECT_EQ(cost_of("jmp @4(r1)").total(), 3);
    EXPECT_EQ(cost_of("mov -(r1), @-(r2)").total(), 4);
    EXPECT_EQ(cost_of("mov @(r1)+, r0").total(), 4);
    EXPECT_EQ(cost_of("sob r1, .-2").total(), 1);
    EXPECT_EQ(cost_of("emt 1").total(), 5);
    EXPECT_EQ(cost_of("mul r2, r0", {"parks", {{"multiply", 7}}}).total(), 7);
}

TEST(StrothotteCosts, CountByClass) {
    const CostChoice u{"strothotte", {}};
    EXPECT_EQ(cost_of("add 4(r1), @6(r2)", u).total(), 1);
    EXPECT_EQ(cost_of("mul (r1)+, r0", u).total(), 10);
    EXPECT_EQ(cost_of("div r1, r0", u).total(), 10);
    EXPECT_EQ(cost_of("mov r1, r0", u).total(), 1);
    EXPECT_EQ(cost_of("sob r1, .-2", u).total(), 2);
    const CostChoice thesis{"strothotte", {{"move", 0}, {"branch", 0}}};
    EXPECT_EQ(cost_of("movb r1, (r0)+", thesis).total(), 0);
    EXPECT_EQ(cost_of("bne .+4", thesis).total(), 0);
    EXPECT_EQ(cost_of("jsr pc, @#2000", thesis).total(), 0);
    EXPECT_EQ(cost_of("cmp r1, r0", thesis).total(), 1);
}

TEST(Costs, RefuseWhatTheyDoNotKnow) {
    const auto complaint = [](const CostChoice& choice) -> std::string {
        try {
            pdp11::CostModel{choice};
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(complaint({"park", {}}),
              "pdp11 has no cost model 'park'; it has parks, strothotte; did you mean 'parks'?");
    EXPECT_EQ(
        complaint({"parks", {{"mul", 3}}}),
        "cost model 'parks' has no parameter 'mul'; it has autoincrement, multiply, divide, trap");
    EXPECT_EQ(complaint({"parks", {{"multiply", -1}}}),
              "cost parameter 'multiply' is -1; 0 to 10000 cycles are expected");
}

}  // namespace
}  // namespace rasterloom::isa::testing
