// SPDX-License-Identifier: MIT
// What must hold for every source: no text makes the assembler fail, and disassembly is its
// inverse.
#include "isa/disassembler.hpp"
#include "tests/isa/assembling.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <rapidcheck.h>

namespace rasterloom::isa {
namespace {

using testing::assemble;
using testing::bytes_of;
using testing::pdp11;

int rounds(int usual) {
    return std::getenv("RASTERLOOM_LONG_TESTS") != nullptr ? 100 * usual : usual;
}

const AssemblerOptions kShort = {.include_dirs = {}, .defines = {}, .max_lines = 2000};

// Every diagnostic must stand in a line the source has (line 0 speaks of the file).
void expect_sensible(const std::string& source) {
    const Assembly assembly = assemble(source, kShort);
    const auto lines = std::count(source.begin(), source.end(), '\n') + 1;
    for (const Diagnostic& diagnostic : assembly.diagnostics) {
        ASSERT_LE(diagnostic.where.line, lines) << source;
        ASSERT_GE(diagnostic.where.column, 0) << source;
        ASSERT_FALSE(diagnostic.message.empty()) << source;
    }
}

TEST(AssemblerProperties, AnyTextIsAssembledOrRefused) {
    const bool held = rc::check([](const std::string& text) { expect_sensible(text); });
    EXPECT_TRUE(held);
}

TEST(AssemblerProperties, AnySequenceOfItsOwnWordsIsAssembledOrRefused) {
    const std::vector<std::string> pieces = {
        "mov",     "r1",    "(",      ")",     "+",      "-",         "@",
        "#",       ",",     "\n",     "\n",    " ",      "x",         ":",
        "1$",      "=",     ".",      ".word", ".byte",  ".ascii",    "/",
        "<",       ">",     "'",      "\"",    ";",      "^C",        "^D",
        "8",       "10.",   ".macro", ".endm", ".rept",  ".endr",     ".irp",
        ".if",     "df",    "eq",     ".else", ".endc",  ".iif",      ".mexit",
        "\\",      "?",     ".blkb",  ".org",  "177777", ".even",     "sob",
        "br",      ".irpc", ".narg",  ".nchr", ".radix", ".end",      ".include",
        "^",       "%6",    "~",      "&",     "m",      "m",         ".macro m a\n",
        "a",       "-(sp)", "*",      "0x",    "\t",     ".rept 3\n", ".endr\n",
        ".endm\n", "!"};
    std::mt19937 random(1981);
    for (int round = 0; round < rounds(20000); ++round) {
        std::string source;
        for (auto length = random() % 40; length > 0; --length) {
            source += pieces[random() % pieces.size()];
        }
        expect_sensible(source);
    }
}

TEST(AssemblerProperties, AnyMutationOfAProgramIsAssembledOrRefused) {
    std::ifstream file(std::filesystem::path(RASTERLOOM_SOURCE_DIR) / "tests/isa/golden/program.s");
    const std::string original{std::istreambuf_iterator<char>(file),
                               std::istreambuf_iterator<char>()};
    ASSERT_FALSE(original.empty());
    std::mt19937 random(2);
    for (int round = 0; round < rounds(500); ++round) {
        std::string source = original;
        for (auto changes = 1 + random() % 8; changes > 0; --changes) {
            const std::size_t at = random() % source.size();
            switch (random() % 3) {
                case 0:
                    source[at] = static_cast<char>(random() % 128);
                    break;
                case 1:
                    source.erase(at, random() % 20);
                    break;
                default:
                    source.insert(at, source.substr(random() % source.size(), random() % 20));
                    break;
            }
        }
        expect_sensible(source);
    }
}

TEST(AssemblerProperties, DisassemblyOfEveryFirstWordAssemblesToTheSameWords) {
    std::mt19937 random(11);
    const std::uint32_t address = 01000;
    for (unsigned first = 0; first < 65536; ++first) {
        const std::vector<std::uint16_t> words = {static_cast<std::uint16_t>(first),
                                                  static_cast<std::uint16_t>(random()),
                                                  static_cast<std::uint16_t>(random())};
        const DecodedText decoded = pdp11().syntax->decode(words, address);
        const Assembly assembly = assemble(fmt::format(". = 0{:o}\n{}\n", address, decoded.text));
        ASSERT_TRUE(assembly.ok()) << decoded.text << '\n' << to_string(assembly.diagnostics);
        const auto again = words_of_bytes(bytes_of(assembly.image), 16);
        ASSERT_EQ(again, std::vector(words.begin(), words.begin() + decoded.words)) << decoded.text;
        if (pdp11::find_instruction(first) == nullptr) {
            ASSERT_EQ(decoded.text, fmt::format(".word 0{:05o}", first));
        }
    }
}

TEST(AssemblerProperties, DisassemblyOfAnyBytesAssemblesToTheSameBytes) {
    const bool held = rc::check([](const std::vector<std::uint8_t>& bytes, std::uint16_t start) {
        Image image;
        image.segments.push_back({std::uint32_t{start} / 2, bytes});
        image.entry = start / 2;
        const Assembly assembly = assemble(disassemble(pdp11(), image));
        RC_ASSERT(assembly.ok());
        RC_ASSERT(bytes_of(assembly.image) == bytes);
    });
    EXPECT_TRUE(held);
}

}  // namespace
}  // namespace rasterloom::isa
