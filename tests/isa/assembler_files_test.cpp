// SPDX-License-Identifier: MIT
// Sources in several files.
#include "isa/disassembler.hpp"
#include "isa/pdp11/pdp11.hpp"
#include "tests/isa/assembling.hpp"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

namespace rasterloom::isa {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::pdp11;
using testing::words_of;

class AssemblerFiles : public ::testing::Test {
  protected:
    void SetUp() override {
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_ / "parts");
        std::filesystem::create_directories(folder_ / "shared");
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path write(const std::string& name, const std::string& text) {
        std::ofstream(folder_ / name) << text;
        return folder_ / name;
    }

    // One for each test: they may run at the same time.
    const std::filesystem::path folder_ =
        std::filesystem::path(RASTERLOOM_BINARY_DIR) / "assembler_files_test" /
        ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(AssemblerFiles, AreLookedForBesideTheIncludingFileFirst) {
    const auto main = write("main.s", ".include \"parts/one.s\"\n.include \"common.s\"\n");
    write("parts/one.s", ".word 1\n.include \"two.s\"\n");
    write("parts/two.s", ".word 2\n");
    write("shared/two.s", ".word 77\n");
    write("shared/common.s", ".word 3\n");
    const Assembly assembly =
        assemble_file(pdp11(), main, {.include_dirs = {folder_ / "shared"}, .defines = {}});
    ASSERT_TRUE(assembly.ok()) << to_string(assembly.diagnostics);
    EXPECT_THAT(words_of(assembly.image), ElementsAre(1, 2, 3));
    EXPECT_EQ(assembly.image.source_of(2)->file, (folder_ / "parts/two.s").string());
}

TEST_F(AssemblerFiles, AreNamedInErrorsWithTheWayThere) {
    const auto main = write("main.s", "nop\n  .include \"parts/one.s\"\n");
    const auto part = write("parts/one.s", "\n clr nothing\n");
    EXPECT_EQ(to_string(assemble_file(pdp11(), main).diagnostics),
              part.string() + ":2:6: undefined symbol 'nothing'\n" + main.string() +
                  ":2:12:   in .include\n");
    EXPECT_THROW(assemble_image(pdp11::pdp11_isa(), main), AssemblyError);
}

TEST_F(AssemblerFiles, ThatIncludeThemselvesAreAnError) {
    const auto main = write("main.s", ".include \"main.s\"\n");
    EXPECT_THAT(to_string(assemble_file(pdp11(), main).diagnostics),
                HasSubstr("include one another more than 200 deep"));
}

TEST(Disassembler, WritesLabelsAndAWholeSource) {
    const Assembly assembly =
        testing::assemble(". = 1000\nstart: mov #5, r1\nnext: br next\n.byte 7\n.end next");
    EXPECT_EQ(
        disassemble(pdp11(), assembly.image),
        "        . = 01000\nstart:\n        mov #5, r1\nnext:\n        br 01004\n        .byte 07\n"
        "        .end 01004\n");
}

}  // namespace
}  // namespace rasterloom::isa
