// SPDX-License-Identifier: MIT
// The VLIW in the shared assembler: operations, bundles, errors, and the way back to text.
#include "isa/disassembler.hpp"
#include "isa/listing.hpp"
#include "isa/vliw/instruction_table.hpp"
#include "isa/vliw/syntax.hpp"
#include "tests/isa/vliw_assembling.hpp"
#include "tests/isa/vliw_bundles.hpp"

#include <algorithm>
#include <cstdlib>
#include <random>
#include <stdexcept>

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace rasterloom::isa::vliw {
namespace {

using testing::any_bundle;
using testing::bundles;
using testing::complaint;
using ::testing::HasSubstr;
using testing::image_of;

Bundle one(std::string_view source) {
    const auto all = bundles(std::string(source) + '\n');
    EXPECT_EQ(all.size(), 1U) << source;
    return all.at(0);
}

TEST(VliwSyntax, AssemblesTheOperationsOfTheAlu) {
    EXPECT_EQ(one("add r3, r1, r2").alu, (Bundle::Alu{AluOp::add, TestMode::set, 3, 1, 2, false}));
    EXPECT_EQ(one("sub r3, r1, #-12").alu, (Bundle::Alu{AluOp::sub, TestMode::set, 3, 1, 0, true}));
    EXPECT_EQ(one("sub r3, r1, #-12").immediate, 0xfff4);
    EXPECT_EQ(one("mov r1, R31").alu, (Bundle::Alu{AluOp::mov, TestMode::set, 1, 0, 31, false}));
    EXPECT_EQ(one("tget r5").alu, (Bundle::Alu{AluOp::tget, TestMode::set, 5, 0, 0, false}));
    EXPECT_EQ(one("tlt r1, r2").alu, (Bundle::Alu{AluOp::tlt, TestMode::set, 0, 1, 2, false}));
    EXPECT_EQ(one("tgeb.and r1, r2").alu,
              (Bundle::Alu{AluOp::tgeb, TestMode::both, 0, 1, 2, false}));
    EXPECT_EQ(one("teq.or r1, #7").alu, (Bundle::Alu{AluOp::teq, TestMode::either, 0, 1, 0, true}));
}

TEST(VliwSyntax, AssemblesTheOperationsOfTheOtherSlots) {
    EXPECT_EQ(one("mulsu r3, r1, r2, 16").mul,
              (Bundle::Multiplier{MulOp::mulsu, 3, 1, 2, 16, false}));
    EXPECT_EQ(one("mul r3, r1, #5").mul, (Bundle::Multiplier{MulOp::mul, 3, 1, 0, 0, true}));
    EXPECT_EQ(one("ld r4, -5(r6)").mem, (Bundle::Memory{MemOp::ld, 0, 4, 6, 0xfffb}));
    EXPECT_EQ(one("st r4, (r6)").mem, (Bundle::Memory{MemOp::st, 0, 4, 6, 0}));
    EXPECT_EQ(one("st r4, 2+<3*4>").mem, (Bundle::Memory{MemOp::st, 0, 4, 0, 14}));
    EXPECT_EQ(one("lds r4, 3, (1+1)(r6)").mem, (Bundle::Memory{MemOp::lds, 3, 4, 6, 2}));
    EXPECT_EQ(one("put r7").comm, (Bundle::Communication{CommOp::put, 7, 0}));
    EXPECT_EQ(one("right").comm, (Bundle::Communication{CommOp::right, 0, 1}));
    EXPECT_EQ(one("left 1023").comm, (Bundle::Communication{CommOp::left, 0, 1023}));
    EXPECT_EQ(one("cast").comm, (Bundle::Communication{CommOp::cast, 0, 0}));
    EXPECT_EQ(one("wslf").sleep, SleepOp::wslf);
    EXPECT_EQ(one("setc c3, 100").seq, (Bundle::Sequencer{SeqOp::setc, 3, 100}));
    EXPECT_EQ(one("phase 4").seq, (Bundle::Sequencer{SeqOp::phase, 0, 4}));
    EXPECT_EQ(one("nop"), Bundle{});
}

TEST(VliwSyntax, JoinsOperationsToABundle) {
    const Bundle bundle =
        one("wake|add r1, r2, #1 | MUL r3, r2, #1, 2 | st r2, 5(r6) | right 2 | dec c1, 0 ; all");
    EXPECT_EQ(operations_in(bundle), 6);
    EXPECT_EQ(bundle.immediate, 1);
    EXPECT_EQ(bundle.mem.base, 6);
    EXPECT_EQ(bundle.comm.count, 2);
    EXPECT_EQ(one("mov r1, #<1|4>").immediate, 5) << "in a group | still means or";
}

TEST(VliwSyntax, CountsAddressesInBundles) {
    const Image image = image_of(
        "start: mov r1, #5\nloop: sub r1, r1, #1\n tne r1, r0\n bt loop\n jump start+. ; 4\n"
        ". = 100\nlast: halt\n.end loop\n");
    const auto all = Program(image).bundles;
    ASSERT_EQ(all.size(), 101U);
    EXPECT_EQ(all[3].seq, (Bundle::Sequencer{SeqOp::bt, 0, 1}));
    EXPECT_EQ(all[4].seq.target, 4);
    EXPECT_EQ(image.symbol("last"), 100U);
    EXPECT_EQ(image.entry, 1U);
    ASSERT_NE(image.source_of(3), nullptr);
    EXPECT_EQ(image.source_of(3)->line, 4);
    EXPECT_EQ(image.segments.at(1).address, 100U * kBytesPerBundle);
}

TEST(VliwSyntax, NamesRegistersAndCounters) {
    const Bundle bundle =
        one("x = r5\nbase = %9\nrow = c2\n ld x, 4(base) | mov r6, x | setc row, 3");
    EXPECT_EQ(bundle.mem.reg, 5);
    EXPECT_EQ(bundle.mem.base, 9);
    EXPECT_EQ(bundle.seq.counter, 2);
}

TEST(VliwSyntax, TellsLabelsFromOtherSymbols) {
    const Image image = image_of("size = 3\nhere: mov r1, #size\n1$: jump 1$\n");
    EXPECT_EQ(image.labels, (std::set<std::string, std::less<>>{"here"}));
    EXPECT_EQ(image.symbols.size(), 2U);
}

TEST(VliwSyntax, SaysWhatIsWrongWithABundleAndWhere) {
    EXPECT_EQ(complaint(" add r1, r2, r3 | sub r4, r5, r6\n"),
              "t.s:1:23: sub: the bundle's ALU slot is in use already\n");
    EXPECT_EQ(complaint(" add r1, r2, r3 | mul r4, r5, r6 | st r7, 0\n"),
              "t.s:1:39: st: the bundle reads 5 registers; the register file has 4 read ports\n");
    EXPECT_EQ(
        complaint(" add r1, r2, r3 | mul r4, r2, r3 | get r7\n"),
        "t.s:1:40: get: the bundle writes 3 registers; the register file has 2 write ports\n");
    EXPECT_EQ(complaint(" add r1, r2, r3 | ld r1, 0\n"),
              "t.s:1:22: ld: the bundle writes r1 twice\n");
    EXPECT_EQ(complaint(" add r1, r2, #3 | mul r4, r2, #4\n"),
              "t.s:1:31: the bundle's immediate is 3 already, not 4\n");
    EXPECT_EQ(complaint(" add r1, r2, #3 | shft 3\n"),
              "t.s:1:19: 'shft' is no operation of a bundle\n");
    EXPECT_THAT(complaint(" add r1, r2, #3 | rigth 3\n"), HasSubstr("did you mean 'right'?"));
    EXPECT_EQ(complaint(" wake |\n"), "t.s:1:8: an operation is missing beside |\n");
}

TEST(VliwSyntax, SaysWhatIsWrongWithAnOperandAndWhere) {
    EXPECT_EQ(complaint(" add r1, r32, r3\n"),
              "t.s:1:10: 'r32' is no register: r0 to r31 is expected\n");
    EXPECT_EQ(complaint(" add r1, c1, r3\n"),
              "t.s:1:10: 'c1' is no register: r0 to r31 is expected\n");
    EXPECT_EQ(complaint(" add r1, r3\n"), "t.s:1:6: add takes 3 operands, 2 given\n");
    EXPECT_EQ(complaint(" mul r1, r3\n"), "t.s:1:6: mul takes 3 or 4 operands, 2 given\n");
    EXPECT_EQ(complaint(" cast 3\n"), "t.s:1:7: cast takes 0 operands, 1 given\n");
    EXPECT_EQ(complaint(" mul r1, r2, r3, 32\n"),
              "t.s:1:18: the value 32 is out of range (0 to 31)\n");
    EXPECT_EQ(complaint(" right 0\n"), "t.s:1:8: the value 0 is out of range (1 to 1023)\n");
    EXPECT_EQ(complaint(" lds r1, 4, 0\n"), "t.s:1:10: the value 4 is out of range (0 to 3)\n");
    EXPECT_EQ(complaint(" setc r1, 4\n"), "t.s:1:7: 'r1' is no counter: c0 to c7 is expected\n");
    EXPECT_EQ(complaint(" jump away\n"), "t.s:1:7: undefined symbol 'away'\n");
    EXPECT_EQ(complaint(" wake | mov r1, #away\n"), "t.s:1:18: undefined symbol 'away'\n");
    EXPECT_EQ(complaint(" ld r1, 70000(r2)\n"),
              "t.s:1:9: the value 70000. does not fit in a word (-32768. to 65535.)\n");
    EXPECT_EQ(complaint(" ld r1,\n"), "t.s:1:8: an expression is missing\n");
}

TEST(VliwSyntax, KeepsLabelsAndBundlesAtWholeAddresses) {
    EXPECT_EQ(complaint(" .word 1\nx: nop\n"),
              "t.s:2:1: 'x' would stand inside of 18 bytes that have one address\n"
              "t.s:2:7: an instruction inside of 18 bytes that have one address\n");
    EXPECT_EQ(complaint(" .blkw 9\nx: nop\n"), "");
    EXPECT_EQ(complaint(". = 65535\n nop\n nop\n"),
              "t.s:3:1: the program passes the end of the address space\n");
}

TEST(VliwSyntax, RefusesWordsThatAreNoBundle) {
    try {
        Program(image_of(" nop\n .word 0xffff, 0, 0, 0, 0, 0, 0, 0, 0\n"));
        FAIL() << "no error";
    } catch (const std::invalid_argument& problem) {
        EXPECT_THAT(problem.what(), HasSubstr("t.s:2:1: the bundle at 1 is none"));
    }
    EXPECT_THROW(Program(image_of(" nop\n .word 1\n")), std::invalid_argument);
    EXPECT_THROW(Program(image_of(" nop\n .end 1\n")), std::invalid_argument);
}

TEST(VliwSyntax, RowsOfASlotDoNotOverlapAndAreItsOperations) {
    for (const InstructionRow& row : instruction_table()) {
        for (const InstructionRow& other : instruction_table()) {
            EXPECT_TRUE(&row == &other || row.slot != other.slot ||
                        ((row.match ^ other.match) & row.mask & other.mask) != 0)
                << row.mnemonic << " and " << other.mnemonic;
        }
    }
    // Every operation of every slot, a test in each of its modes, and nop.
    EXPECT_EQ(
        instruction_table().size(),
        static_cast<std::size_t>(kSeqOps + kAluOps + 4 + 5 + kCommOps + kSleepOps - 6 + 2 * 8 + 1));
}

int rounds(int usual) {
    return std::getenv("RASTERLOOM_LONG_TESTS") != nullptr ? 100 * usual : usual;
}

TEST(VliwSyntax, DisassemblyOfAnyBundleAssemblesToTheSameWords) {
    for (int seed = 0; seed < rounds(1); ++seed) {
        const bool held = rc::check([] {
            const Bundle bundle = *any_bundle();
            const BundleWords words = encode(bundle);
            const DecodedText decoded = vliw_syntax().decode(words, 0);
            RC_ASSERT(decoded.words == kWordsPerBundle);
            RC_ASSERT(decoded.text.starts_with(".word") == conflict(bundle).has_value());
            const Assembly assembly = testing::assemble(decoded.text + "\n");
            RC_ASSERT(assembly.ok());
            RC_ASSERT(words_of_bytes(assembly.image.segments.at(0).bytes, 16) ==
                      std::vector<std::uint16_t>(words.begin(), words.end()));
        });
        EXPECT_TRUE(held);
    }
}

TEST(VliwSyntax, AnySequenceOfItsOwnWordsIsAssembledOrRefused) {
    const std::vector<std::string> pieces = {
        "r1", "r31", "c2", "%5", ",", ",",     "#", "(",   ")",  "<",    ">",    "|",  "|",
        "|",  "\n",  "\n", " ",  "x", "x:",    "=", "5",   "-1", "1023", "0xff", "'",  "\"",
        ";",  ".",   "~",  "!",  "+", ".word", "r", "mov", "ld", "1$",   "jump", "^C", "70000"};
    std::mt19937 random(1995);
    const auto rows = instruction_table();
    for (int round = 0; round < rounds(20000); ++round) {
        std::string source;
        for (auto length = random() % 30; length > 0; --length) {
            source += random() % 4 == 0 ? std::string(rows[random() % rows.size()].mnemonic)
                                        : pieces[random() % pieces.size()];
            source += random() % 2 == 0 ? " " : "";
        }
        const Assembly assembly = testing::assemble(source);
        const auto lines = std::count(source.begin(), source.end(), '\n') + 1;
        for (const Diagnostic& diagnostic : assembly.diagnostics) {
            ASSERT_LE(diagnostic.where.line, lines) << source;
            ASSERT_GE(diagnostic.where.column, 1) << source;
            ASSERT_FALSE(diagnostic.message.empty()) << source;
        }
    }
}

TEST(VliwSyntax, DisassemblyOfAnyBytesAssemblesToTheSameBytes) {
    const bool held = rc::check([](const std::vector<std::uint8_t>& bytes, std::uint16_t start) {
        Image image;
        image.segments.push_back({start / 2U * kBytesPerBundle, bytes});
        image.entry = start / 2U;
        const Assembly assembly = testing::assemble(disassemble(dialect_of(vliw_isa()), image));
        RC_ASSERT(assembly.ok());
        if (bytes.empty()) {
            return;
        }
        RC_ASSERT(assembly.image.segments.at(0).bytes == bytes);
        RC_ASSERT(assembly.image.segments.at(0).address == image.segments[0].address);
    });
    EXPECT_TRUE(held);
}

TEST(VliwSyntax, ListsBundlesWithTheirCycles) {
    const Assembly assembly = testing::assemble("go: mov r1, #2\n right 30 | lds r1, 0, 5\n");
    const std::string listing = make_listing(assembly, vliw_isa());
    EXPECT_THAT(
        listing,
        HasSubstr("0000    0000 0000 0841 0000 0000 0002 0000 0000 0000       1    0  go: mov"));
    EXPECT_THAT(
        listing,
        HasSubstr("0001    0000 0000 0000 0000 0000 0000 6040 0005 301e       1   29   right"));
}

}  // namespace
}  // namespace rasterloom::isa::vliw
