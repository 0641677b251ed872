// SPDX-License-Identifier: MIT
// The PDP-11 encodings and texts against GNU as and objdump: tests/isa/golden/ holds what they made
// (scripts/make_pdp11_golden.sh).
#include "isa/disassembler.hpp"
#include "isa/image_files.hpp"
#include "isa/operands.hpp"
#include "tests/isa/assembling.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace rasterloom::isa {
namespace {

using testing::assemble;
using testing::bytes_of;
using testing::pdp11;

const std::filesystem::path kGolden =
    std::filesystem::path(RASTERLOOM_SOURCE_DIR) / "tests/isa/golden";

struct GoldenLine {
    std::vector<std::uint16_t> words;
    std::string text;
};

std::vector<GoldenLine> golden(const char* name) {
    std::ifstream file(kGolden / name);
    std::vector<GoldenLine> lines;
    for (std::string line; std::getline(file, line);) {
        const std::size_t tab = line.find('\t');
        std::istringstream numbers(line.substr(0, tab));
        GoldenLine& read = lines.emplace_back(GoldenLine{{}, line.substr(tab + 1)});
        for (unsigned word = 0; numbers >> std::oct >> word;) {
            read.words.push_back(static_cast<std::uint16_t>(word));
        }
    }
    return lines;
}

// The words of one instruction at an address; what is missing is filled with zeros.
std::vector<std::uint16_t> three_words(const std::string& text, std::size_t address) {
    const Assembly assembly = assemble(fmt::format(". = 0{:o}\n{}\n", address, text));
    EXPECT_TRUE(assembly.ok()) << text << '\n' << to_string(assembly.diagnostics);
    auto words = words_of_bytes(bytes_of(assembly.image), 16);
    words.resize(3);
    return words;
}

TEST(GnuAgreement, EncodesEveryInstructionOfTheGoldenFileAlike) {
    const auto lines = golden("pdp11_encodings.txt");
    ASSERT_GT(lines.size(), 3000U);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        EXPECT_EQ(three_words(lines[i].text, 6 * i), lines[i].words) << lines[i].text;
    }
}

TEST(GnuAgreement, DisassemblesTheGoldenFilesWordsAlike) {
    const auto lines = golden("pdp11_disassembly.txt");
    ASSERT_GT(lines.size(), 3000U);
    for (const GoldenLine& line : lines) {
        EXPECT_EQ(pdp11().syntax->decode(line.words, 0).text, line.text);
    }
}

TEST(GnuAgreement, AssemblesAWholeProgramToTheSameBytesAndSymbols) {
    const Image theirs = read_aout_image(kGolden / "program.aout");
    const Assembly ours = assemble_file(pdp11(), kGolden / "program.s");
    ASSERT_TRUE(ours.ok()) << to_string(ours.diagnostics);
    EXPECT_EQ(bytes_of(ours.image), bytes_of(theirs));
    EXPECT_GT(theirs.symbols.size(), 20U);
    for (const auto& [name, value] : theirs.symbols) {
        EXPECT_EQ(ours.image.symbol(name), value) << name;
    }
}

// GNU as writes $ for #, and wants an address in the code as a distance: an absolute one is left to
// the linker.
std::string for_gnu(const std::string& text, std::uint32_t address) {
    const std::size_t blank = text.find(' ');
    const std::string mnemonic = text.substr(0, blank);
    if (blank == std::string::npos || mnemonic == "emt" || mnemonic == "trap" ||
        mnemonic == "mark" || mnemonic == ".word") {
        return text;
    }
    std::string result = mnemonic;
    for (const OperandText& operand : split_operands(std::string_view(text).substr(blank))) {
        std::string part(operand.text);
        const std::size_t digit = part[0] == '@' ? 1 : 0;
        if (part[digit] >= '0' && part[digit] <= '7' && part.back() != ')') {
            const int target = std::stoi(part.substr(digit), nullptr, 8);
            part =
                fmt::format("{}.{:+}", part.substr(0, digit), target - static_cast<int>(address));
        }
        std::replace(part.begin(), part.end(), '#', '$');
        result += result == mnemonic ? ' ' : ',';
        result += part;
    }
    return result;
}

// Our text of each first word, through GNU as, gives the word back. Needs PDP11_AS; words that are
// no instruction and condition codes without a name of their own are data there.
TEST(GnuAgreement, GnuAssemblesOurDisassemblyOfEveryWordToTheSameWord) {
    const char* assembler = std::getenv("PDP11_AS");
    if (assembler == nullptr) {
        GTEST_SKIP() << "PDP11_AS names no GNU assembler for the PDP-11";
    }
    const std::filesystem::path folder =
        std::filesystem::path(RASTERLOOM_BINARY_DIR) / "gnu_agreement";
    std::filesystem::create_directories(folder);
    // In eight parts: GNU as has 64 KiB, too.
    for (unsigned part = 0; part < 8; ++part) {
        std::ofstream source(folder / "words.s");
        std::vector<std::uint16_t> expected;
        for (unsigned word = part * 8192; word < (part + 1) * 8192; ++word) {
            const std::array<std::uint16_t, 3> words = {static_cast<std::uint16_t>(word), 012,
                                                        0177770};
            const auto address = static_cast<std::uint32_t>(expected.size() * 2);
            const DecodedText decoded = pdp11().syntax->decode(words, address);
            source << (decoded.text.starts_with("ccodes") ? fmt::format(".word 0{:o}", word)
                                                          : for_gnu(decoded.text, address))
                   << '\n';
            expected.insert(expected.end(), words.begin(), words.begin() + decoded.words);
        }
        source.close();
        const std::string command =
            fmt::format("'{}' -o '{}' '{}'", assembler, (folder / "words.o").string(),
                        (folder / "words.s").string());
        ASSERT_EQ(std::system(command.c_str()), 0);
        std::ifstream object(folder / "words.o", std::ios::binary);
        const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(object),
                                              std::istreambuf_iterator<char>()};
        const auto words = words_of_bytes(bytes, 16);
        ASSERT_GE(words.size(), 8 + expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            ASSERT_EQ(words[8 + i], expected[i]) << "at word " << i << " of part " << part;
        }
    }
}

}  // namespace
}  // namespace rasterloom::isa
