// SPDX-License-Identifier: MIT
#include "isa/listing.hpp"

#include "isa/assembler/text.hpp"
#include "isa/disassembler.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace rasterloom::isa {
namespace {

constexpr std::size_t kColumnWidth = 21;  // at least: three octal words
constexpr std::size_t kMostRows = 4;      // of a line that is not an instruction

struct Digits {
    explicit Digits(const Isa& isa)
        : octal(isa.syntax().default_radix() == 8),
          by_words(isa.word_bits() == 16),
          unit(static_cast<std::size_t>(isa.address_unit())),
          column(std::max(kColumnWidth, unit / 2 * (octal ? 7 : 5))) {}
    std::string address(std::uint32_t value) const {
        return octal ? fmt::format("{:06o}", value) : fmt::format("{:04x}", value);
    }
    std::string byte(unsigned value) const {
        return octal ? fmt::format("{:03o}", value) : fmt::format("{:02x}", value);
    }
    bool octal;
    bool by_words;
    std::size_t unit;    // bytes
    std::size_t column;  // where the words stand: wide enough for a unit
};

// The bytes as numbers, in rows that fit the column: words where they stand at even addresses.
std::vector<std::string> rows_of(const AssembledLine& line, const Digits& digits) {
    std::vector<std::string> rows(1);
    for (std::size_t i = 0; i < line.bytes.size();) {
        const bool word = digits.by_words && (line.address * digits.unit + i) % 2 == 0 &&
                          i + 1 < line.bytes.size();
        const std::string number =
            word ? digits.address(line.bytes[i] | unsigned{line.bytes[i + 1]} << 8)
                 : digits.byte(line.bytes[i]);
        if (rows.back().size() + 1 + number.size() > digits.column) {
            if (rows.size() == kMostRows && !line.instruction) {
                rows.push_back(fmt::format("... {} bytes", line.bytes.size()));
                return rows;
            }
            rows.emplace_back();
        }
        rows.back() += rows.back().empty() ? number : ' ' + number;
        i += word ? 2 : 1;
    }
    return rows;
}

std::optional<InstructionCost> cost_of(const AssembledLine& line, const Isa& isa,
                                       const CostChoice& cost) {
    if (!line.instruction || line.bytes.empty()) {
        return std::nullopt;
    }
    return isa.cost_of(words_of_bytes(line.bytes, isa.word_bits()), cost);
}

std::string symbol_table(const Image& image, const Digits& digits) {
    std::string text = "\nSymbols\n";
    for (const auto& [name, value] : image.symbols) {
        fmt::format_to(std::back_inserter(text), "{}  {}\n", digits.address(value), name);
    }
    return text;
}

}  // namespace

std::string make_listing(const Assembly& assembly, const Isa& isa, const CostChoice& cost) {
    const Digits digits(isa);
    std::string text = fmt::format("{:<8}{:<{}}{:>6}{:>5}  source\n", "address", "words",
                                   digits.column + 1, "fetch", "data");
    std::string_view file;
    for (const AssembledLine& line : assembly.lines) {
        if (!line.expanded && line.where.file != file) {
            file = line.where.file;
            fmt::format_to(std::back_inserter(text), "; {}\n", file);
        }
        const auto rows = rows_of(line, digits);
        const auto cycles = cost_of(line, isa, cost);
        fmt::format_to(std::back_inserter(text), "{:<8}{:<{}}{:>6}{:>5}  {}{}\n",
                       line.bytes.empty() ? "" : digits.address(line.address), rows[0],
                       digits.column + 1, cycles ? fmt::format("{}", cycles->fetch) : "",
                       cycles ? fmt::format("{}", cycles->data) : "", line.expanded ? "+ " : "",
                       line.text);
        for (std::size_t i = 1; i < rows.size(); ++i) {
            fmt::format_to(std::back_inserter(text), "{:<8}{}\n", "", rows[i]);
        }
    }
    return text + symbol_table(assembly.image, digits);
}

}  // namespace rasterloom::isa
