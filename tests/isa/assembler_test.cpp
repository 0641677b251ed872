// SPDX-License-Identifier: MIT
// The assembler's language on PDP-11 source: what each construct produces.
#include "tests/isa/assembling.hpp"

#include <gmock/gmock.h>

namespace rasterloom::isa {
namespace {

using testing::assemble;
using testing::bytes_of;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::words;

using Words = std::vector<unsigned>;

TEST(Assembler, EncodesEveryAddressingMode) {
    EXPECT_THAT(words("mov r1, r2"), ElementsAre(010102));
    EXPECT_THAT(words("mov (r1), @r2"), ElementsAre(011112));
    EXPECT_THAT(words("mov (r1)+, @(r2)+"), ElementsAre(012132));
    EXPECT_THAT(words("mov -(sp), @-(r2)"), ElementsAre(014652));
    EXPECT_THAT(words("mov 4(r1), @-2(r5)"), ElementsAre(016175, 4, 0177776));
    EXPECT_THAT(words("clr @(r3)"), ElementsAre(005073, 0));
    EXPECT_THAT(words("mov #1, @#2"), ElementsAre(012737, 1, 2));
    EXPECT_THAT(words(". = 1000\nmov 2000, @2000"), ElementsAre(016777, 01000 - 4, 01000 - 6));
    EXPECT_THAT(words("MOV R1, %6"), ElementsAre(010106));
}

TEST(Assembler, EncodesEveryFormat) {
    EXPECT_THAT(words("jsr r5, (r1)\nrts r5\nmark 7\nemt 12\ntrap\nsec\nccodes 37\nxor r2, (r3)"),
                ElementsAre(004511, 000205, 006407, 0104012, 0104400, 000261, 000277, 074213));
    EXPECT_THAT(words("mul #10, r2\ndiv r1, r4\nash #-1, r0\nashc (r2), r2"),
                ElementsAre(070227, 8, 071401, 072027, 0177777, 073212));
    EXPECT_THAT(words("call @#x\nreturn\nx: bhis x\nblo x"),
                ElementsAre(004737, 6, 000207, 0103377, 0103776));
}

TEST(Assembler, CountsBranchesFromTheNextWord) {
    EXPECT_THAT(words("x: br x\n br y\ny: sob r3, x"), ElementsAre(000777, 000400, 077303));
}

TEST(Assembler, ReadsNumbersInOctalUnlessTold) {
    EXPECT_THAT(words(".word 10, 10., ^D10, ^O10, ^B10, ^X1f, 0x1F, -1, 'A, \"AB"),
                ElementsAre(8, 10, 10, 8, 2, 31, 31, 0177777, 0101, 041101));
    EXPECT_THAT(words(".radix 10\n.word 10\n.radix 16\n.word 0ff\n.radix\n.word 10"),
                ElementsAre(10, 255, 8));
}

TEST(Assembler, TakesOperatorsFromLeftToRight) {
    EXPECT_THAT(words(".word 1+2*3, 1+<2*3>, (1+2)*3, 7&3!10, 7/2, ^C0, ~1, -<2+3>"),
                ElementsAre(9, 7, 9, 013, 3, 0177777, 0177776, 0177773));
}

TEST(Assembler, ResolvesSymbolsForwardsAndThroughAssignments) {
    EXPECT_THAT(words("a = b + 1\nb = c\n.word a, b, d\nc = 5\nd:"), ElementsAre(6, 5, 6));
    EXPECT_THAT(words("n = 1\n.word n\nn = n + 1\n.word n"), ElementsAre(1, 2));
}

TEST(Assembler, KeepsLocalLabelsBetweenOrdinaryOnes) {
    EXPECT_THAT(words("a: 1$: br 1$\nb: br 1$\n1$: nop"), ElementsAre(000777, 000400, 000240));
}

TEST(Assembler, LaysOutData) {
    EXPECT_THAT(
        bytes_of(
            assemble(".byte 1, -1, 377\n.even\n.blkb 2\n.blkw\n.byte 1\n.odd\n.ascii /ab/<15>'c'")
                .image),
        ElementsAre(1, 255, 255, 0, 0, 0, 0, 0, 1, 'a', 'b', 015, 'c'));
    EXPECT_THAT(bytes_of(assemble(".asciz \"a;b\" ; comment").image),
                ElementsAre('a', ';', 'b', 0));
}

TEST(Assembler, MovesTheLocationCounter) {
    const Assembly assembly =
        assemble(". = 1000\na: .word .\n. = . + 10\nb: .word a\n.org 40\n.word b\n.end a");
    ASSERT_TRUE(assembly.ok());
    ASSERT_EQ(assembly.image.segments.size(), 3U);
    EXPECT_EQ(assembly.image.segments[0].address, 040U);
    EXPECT_EQ(assembly.image.segments[2].address, 01012U);
    EXPECT_EQ(assembly.image.entry, 01000U);
    EXPECT_EQ(assembly.image.symbol("b"), 01012U);
    EXPECT_EQ(assembly.image.source_of(01013)->line, 4);
}

TEST(Assembler, StartsAtTheLowestAddressUnlessEndNamesAnother) {
    EXPECT_EQ(assemble(". = 2000\nnop\n. = 1000\nnop").image.entry, 01000U);
}

TEST(Assembler, ExpandsMacros) {
    EXPECT_THAT(words(".macro push x\nmov x, -(sp)\n.endm\npush r1\npush #5"),
                ElementsAre(010146, 012746, 5));
    EXPECT_THAT(words(".macro two a, b=7\n.word a, b\n.endm\ntwo 1\ntwo 1, 2\ntwo b=3, a=4"),
                ElementsAre(1, 7, 1, 2, 4, 3));
    EXPECT_THAT(words(".macro skip ?l\nbr l\nnop\nl:\n.endm\nskip\nskip"),
                ElementsAre(000401, 000240, 000401, 000240));
    EXPECT_THAT(words(".macro lab n\nl'n': .word n\n.endm\nx = 3\nlab \\x\n.word l3"),
                ElementsAre(3, 0));
    EXPECT_THAT(words(".macro list a\n.word a\n.endm\nlist <1, 2>\nlist 1 + 2"),
                ElementsAre(1, 2, 3));
}

TEST(Assembler, ExpandsMacrosThatDefineAndCallMacros) {
    EXPECT_THAT(words(".macro outer n\n.macro inner'n\n.word n\n.endm\n.endm\nouter 5\ninner5"),
                ElementsAre(5));
    EXPECT_THAT(words(".macro down n\n.if gt n\n.word n\ndown \\n-1\n.endc\n.endm\ndown 3"),
                ElementsAre(3, 2, 1));
    EXPECT_THAT(
        words(
            ".macro first a\n.word a\n.if ne a\n.mexit\n.endc\n.word 77\n.endm\nfirst 1\nfirst 0"),
        ElementsAre(1, 0, 077));
}

TEST(Assembler, Repeats) {
    EXPECT_THAT(words("n = 0\n.rept 3\n.word n\nn = n + 1\n.endr"), ElementsAre(0, 1, 2));
    EXPECT_THAT(words(".rept 0\n.word 1\n.endr"), IsEmpty());
    EXPECT_THAT(words(".irp r, <r0, r5, sp>\nclr r\n.endr"), ElementsAre(005000, 005005, 005006));
    EXPECT_THAT(words(".irpc c, <12>\n.rept 2\n.word c\n.endr\n.endr"), ElementsAre(1, 1, 2, 2));
}

TEST(Assembler, AssemblesOneSideOfAConditional) {
    EXPECT_THAT(words("x = 1\n.if eq x\n.word 1\n.else\n.word 2\n.endc\n.if gt, x\n.word "
                      "3\n.iff\n.word 4\n.iftf\n"
                      ".word 5\n.ift\n.word 6\n.endc"),
                ElementsAre(2, 3, 5, 6));
    EXPECT_THAT(
        words(".if df x\n.if df y\n.word 1\n.else\n.word 2\n.endif\n.else\n.word 3\n.endc\nx:"),
        ElementsAre(3));
    EXPECT_THAT(words(".ifndf x\nx = 1\n.endc\n.ifndf x\n.word 1\n.endc\n.word x"), ElementsAre(1));
    EXPECT_THAT(
        words(
            ".if b < >\n.word 1\n.endc\n.if nb\n.word 2\n.endc\n.if idn <a>, <a>\n.word 3\n.endc"),
        ElementsAre(1, 3));
    EXPECT_THAT(words("x = 2\n.iif ne x, .word 5\n.iif df y, .word 6\n.iif idn a, a, mov r1, r2"),
                ElementsAre(5, 010102));
}

TEST(Assembler, ReadsTheWholeExpressionOfACondition) {
    EXPECT_THAT(words("a = 0\nb = 1\n"
                      ".if ne <a>!<b>\n.word 1\n.endc\n"
                      ".if lt <a>-<b>\n.word 2\n.endc\n"
                      ".iif eq <<a>&<b>>!a, .word 3\n"
                      ".if ne <a!b>\n.word 4\n.endc"),
                ElementsAre(1, 2, 3, 4));
}

TEST(Assembler, TakesDefinitionsFromOutside) {
    EXPECT_THAT(
        words(".if df big\n.word big\n.endc", {.include_dirs = {}, .defines = {{"big", 12}}}),
        ElementsAre(12));
}

TEST(Assembler, TellsWhichDefinitionsTheSourceNeverAsksFor) {
    const auto unused = [](const char* source) {
        return assemble(source, {.include_dirs = {}, .defines = {{"big", 12}, {"fast", 1}}})
            .unused_defines;
    };
    EXPECT_THAT(unused(".word big"), ElementsAre("fast"));
    EXPECT_THAT(unused(".ifndf fast\nfast = 0\n.endc\nx = big"), ElementsAre());
    EXPECT_THAT(unused("fats = 1"), ElementsAre("big", "fast"));
}

TEST(Assembler, LetsASymbolNameARegister) {
    EXPECT_THAT(words("r0 = %0\np = r4\nmov #'p, (p)+"), ElementsAre(012724, 'p'));
    EXPECT_THAT(words("ptr = r4\nmov (ptr)+, 2(ptr)"), ElementsAre(012464, 2));
}

}  // namespace
}  // namespace rasterloom::isa
