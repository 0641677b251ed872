// SPDX-License-Identifier: MIT
// What the assembler says about wrong sources: file:line:column, everything at once.
#include "tests/isa/assembling.hpp"

#include <gmock/gmock.h>

namespace rasterloom::isa {
namespace {

using testing::assemble;
using testing::complaint;
using ::testing::HasSubstr;

TEST(AssemblerErrors, NameFileLineAndColumnAndComeAllAtOnce) {
    EXPECT_EQ(
        complaint("        mov r1\n        add #nothing, r2\nx:\nx:      nop\n  mvo r1, r2\n"),
        "t.s:1:13: mov takes 2 operands, 1 given\n"
        "t.s:2:14: undefined symbol 'nothing'\n"
        "t.s:4:1: 'x' is defined already, at t.s:3:1\n"
        "t.s:5:3: 'mvo' is no instruction, directive or macro; did you mean 'mov'?\n");
}

TEST(AssemblerErrors, NameBothPlacesOfAMacro) {
    EXPECT_EQ(complaint(".macro load value\n        mov #value, r9\n.endm\n.macro twice v\n  load "
                        "v\n.endm\n  twice 1\n"),
              "t.s:2:21: undefined symbol 'r9'\n"
              "t.s:5:1:   in macro load\n"
              "t.s:7:1:   in macro twice\n");
    EXPECT_EQ(complaint(".rept 1\n .word 200000\n.endr"),
              "t.s:2:8: the value 65536. does not fit in a word (-32768. to 65535.)\nt.s:1:1:   in "
              ".rept\n");
}

TEST(AssemblerErrors, KeepTheColumnOfTheBodyBehindASubstitution) {
    EXPECT_THAT(complaint(".macro m a\n clr a, r1\n.endm\n m longername\n"),
                HasSubstr("t.s:2:9: clr takes 1 operand, 2"));
}

TEST(AssemblerErrors, ReportTargetsOutOfReach) {
    EXPECT_THAT(complaint("br x\n.blkw 200\nx:"),
                HasSubstr("t.s:1:4: the target is out of range: 258. bytes from here"));
    EXPECT_EQ(complaint("br x\n.blkw 177\nx:"), "");
    EXPECT_THAT(complaint("x: .blkw 77\nsob r1, x"),
                HasSubstr("out of range: -126. bytes from here, sob reaches -124."));
    EXPECT_EQ(complaint("x: .blkw 76\nsob r1, x"), "");
    EXPECT_THAT(complaint("br 1"), HasSubstr("the target is at an odd address"));
}

TEST(AssemblerErrors, ReportValuesThatDoNotFit) {
    EXPECT_THAT(complaint(".byte 400"),
                HasSubstr("t.s:1:7: the value 256. does not fit in a byte"));
    EXPECT_THAT(complaint(".word 1, -100001"),
                HasSubstr("t.s:1:10: the value -32769. does not fit in a word"));
    EXPECT_THAT(complaint("mark 100"), HasSubstr("larger than 63."));
    EXPECT_THAT(complaint(".word 37777777777*2"), HasSubstr("does not fit in 32 bits"));
    EXPECT_THAT(complaint(". = 177777\n.byte 1, 2"),
                HasSubstr("passes the end of the address space"));
    EXPECT_THAT(complaint(". = 200000"), HasSubstr("is no address"));
    EXPECT_THAT(complaint(".blkb -1"), HasSubstr("no room"));
}

TEST(AssemblerErrors, ReportWordsAtOddAddresses) {
    EXPECT_THAT(complaint(".byte 1\nnop"), HasSubstr("t.s:2:4: a word at an odd address"));
    EXPECT_THAT(complaint(".byte 1\n.word 1"), HasSubstr("odd address"));
}

TEST(AssemblerErrors, ReportAddressesFilledTwice) {
    EXPECT_THAT(complaint(".word 1\n. = 0\n.word 2"),
                HasSubstr("t.s:3:1: the address is occupied already, by t.s:1"));
}

TEST(AssemblerErrors, ReportBrokenExpressions) {
    EXPECT_THAT(complaint(".word 18"), HasSubstr("'18' is no octal number (decimal: 18.)"));
    EXPECT_THAT(complaint(".word 1+"), HasSubstr("t.s:1:9: an expression is missing"));
    EXPECT_THAT(complaint(".word <1+2"), HasSubstr("t.s:1:7: no '>' closes this group"));
    EXPECT_THAT(complaint(".word 1/0"), HasSubstr("division by zero"));
    EXPECT_THAT(complaint(".word 1 2"), HasSubstr("expected a comma"));
    EXPECT_THAT(complaint("mov #1 2, r0"), HasSubstr("t.s:1:8: '2' after the expression"));
    EXPECT_THAT(complaint(".word '"), HasSubstr("a character is missing"));
}

TEST(AssemblerErrors, ReportWhatIsNotClosed) {
    EXPECT_THAT(complaint(".if eq 0\nnop"), HasSubstr("t.s:1:1: no .endc closes this .if"));
    EXPECT_THAT(complaint("nop\n.macro x\nnop"), HasSubstr("t.s:2:1: .endm is missing"));
    EXPECT_THAT(complaint(".rept 2\nnop"), HasSubstr(".endr is missing"));
    EXPECT_THAT(complaint(".endc"), HasSubstr("no .if is open here"));
    EXPECT_THAT(complaint(".endm"), HasSubstr("no macro or repetition is open here"));
    EXPECT_THAT(complaint(".macro m\n.if eq 0\n.endm\nm\n.endc"), HasSubstr("t.s:2:1: no .endc"));
    EXPECT_THAT(complaint(".mexit"), HasSubstr("outside of a macro"));
}

TEST(AssemblerErrors, ReportWrongArguments) {
    EXPECT_THAT(complaint(".macro m a\n.endm\nm 1, 2"),
                HasSubstr("t.s:3:6: macro 'm' takes 1 arguments, not more"));
    EXPECT_THAT(complaint(".macro m a\n.endm\nm b=2"), HasSubstr("has no parameter 'b'"));
    EXPECT_THAT(complaint(".if qe 0\n.endc"), HasSubstr("'qe' is no condition"));
    EXPECT_THAT(complaint("nop\n.if ne <1>2\n.endc"), HasSubstr("t.s:2:11: "));
    EXPECT_THAT(complaint("nop\n.if df <x>!<y>\n.endc"),
                HasSubstr("t.s:2:11: '!<y>' stands behind the bracket"));
    EXPECT_THAT(complaint(".if b <> x\n.endc"), HasSubstr("t.s:1:10: 'x' stands behind"));
    EXPECT_THAT(complaint(".error sizes differ"), HasSubstr("t.s:1:7: .error: sizes differ"));
    EXPECT_THAT(complaint(".radix 7"), HasSubstr("2, 8, 10 or 16 is expected"));
    EXPECT_THAT(complaint("r1: nop"), HasSubstr("is a register's name"));
    EXPECT_THAT(complaint("r1 = r2"), HasSubstr("is a register's name"));
    EXPECT_THAT(complaint("x: x = 1"), HasSubstr("'x' is a label, at t.s:1:1"));
    EXPECT_THAT(complaint("jsr 5, x\nx:"), HasSubstr("'5' is no register"));
}

TEST(AssemblerErrors, EndRunawayMacros) {
    EXPECT_THAT(complaint(".macro m\nm\n.endm\nm"),
                HasSubstr("macros call one another more than 200 deep"));
    EXPECT_THAT(complaint(".macro m a\nm <a a>\n.endm\nm <x x>"),
                HasSubstr("more than 16384 characters"));
    const Assembly assembly = assemble(".rept 1000\n.rept 1000\nx = 1\n.endr\n.endr",
                                       {.include_dirs = {}, .defines = {}, .max_lines = 1000});
    EXPECT_THAT(to_string(assembly.diagnostics), HasSubstr("expands to more than 1000 lines"));
}

TEST(AssemblerErrors, ReportSymbolsThatDoNotSettle) {
    EXPECT_THAT(complaint(".if eq x-2\n.word 1\n.endc\n.word 2\nx:"),
                HasSubstr("phase error: the value of 'x'"));
}

TEST(AssemblerErrors, NameTheFilesThatCannotBeRead) {
    EXPECT_THAT(complaint("  .include \"no/such.s\""),
                HasSubstr("t.s:1:12: cannot read 'no/such.s'"));
    EXPECT_EQ(to_string(assemble_file(testing::pdp11(), "no/such.s").diagnostics),
              "no/such.s: cannot read this file\n");
}

}  // namespace
}  // namespace rasterloom::isa
