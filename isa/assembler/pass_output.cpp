// SPDX-License-Identifier: MIT
// Values, bytes and errors of a pass.
#include "isa/assembler/pass.hpp"

#include <utility>

#include <fmt/format.h>

namespace rasterloom::isa::assembler {
namespace {

constexpr std::size_t kMostErrors = 1000;

}  // namespace

void Pass::error(std::size_t position, std::string message) {
    error_at(*line_, position, std::move(message));
}

void Pass::error_at(const SourceLine& line, std::size_t position, std::string message) {
    Diagnostic diagnostic{line.location(position), std::move(message), {}};
    for (const Expansion* step = line.expansion().get(); step != nullptr;
         step = step->outer.get()) {
        diagnostic.through.push_back(step->step);
    }
    diagnostics_.push_back(std::move(diagnostic));
    if (diagnostics_.size() == kMostErrors) {
        diagnostics_.push_back(
            {line.location(position), "too many errors; the rest of the source is not read", {}});
        stopped_ = true;
    }
}

void Pass::errors(const std::vector<SyntaxError>& found, std::size_t offset) {
    for (const SyntaxError& one : found) {
        error(offset + static_cast<std::size_t>(one.offset < 0 ? 0 : one.offset), one.message);
    }
}

std::optional<std::int64_t> Pass::evaluate(Rest expression) {
    const ExpressionValue result = read_whole_expression(
        expression.text, radix_, [this](std::string_view name) { return symbol_value(name); });
    errors(result.errors, expression.at);
    return result.value;
}

std::optional<std::int64_t> Pass::symbol_value(std::string_view name) const {
    return name == "." ? std::optional(here()) : symbols_.value_of(name);
}

std::optional<std::uint16_t> Pass::as_word(std::optional<std::int64_t> value, std::size_t at) {
    if (value && (*value < -0x8000 || *value > 0xffff)) {
        error(at, fmt::format("the value {}. does not fit in a word (-32768. to 65535.)", *value));
        return std::nullopt;
    }
    return value ? std::optional(static_cast<std::uint16_t>(*value & 0xffff)) : std::nullopt;
}

std::optional<std::uint32_t> Pass::as_address(std::optional<std::int64_t> value, std::size_t at) {
    const std::int64_t end = std::int64_t{1} << dialect_.address_bits;
    if (value && (*value < 0 || *value >= end)) {
        error(at, fmt::format("the value {}. is no address (0 to {}.)", *value, end - 1));
        return std::nullopt;
    }
    return value ? std::optional(static_cast<std::uint32_t>(*value)) : std::nullopt;
}

void Pass::emit_byte(std::uint8_t byte) {
    if (dot_ >= end_of_memory()) {
        if (!stopped_) {
            error(0, "the program passes the end of the address space");
        }
        stopped_ = true;
        return;
    }
    AssembledLine& line = lines_.back();
    if (line.bytes.empty()) {
        line.address = static_cast<std::uint32_t>(here());
    }
    if (const auto earlier =
            output_.write(static_cast<std::uint32_t>(dot_), byte, lines_.size() - 1);
        earlier && line.bytes.empty()) {
        const SourceLocation& where = lines_[*earlier].where;
        error(0, fmt::format("the address is occupied already, by {}:{}", where.file, where.line));
    }
    line.bytes.push_back(byte);
    ++dot_;
}

void Pass::emit_word(std::uint16_t word) {
    emit_byte(static_cast<std::uint8_t>(word & 0xff));
    emit_byte(static_cast<std::uint8_t>(word >> 8));
}

void Pass::emit_instruction_word(std::uint16_t word) {
    if (dialect_.word_bits == 8) {
        emit_byte(static_cast<std::uint8_t>(word & 0xff));
    } else {
        emit_word(word);
    }
}

// Words stand at even addresses where instructions are made of words; goes on at the next one after
// an error.
void Pass::check_word_boundary(std::size_t at) {
    if (dialect_.word_bits > 8 && (dot_ & 1) != 0) {
        error(at, "a word at an odd address; .even is missing before");
        ++dot_;
    }
}

void Pass::check_instruction_boundary(std::size_t at) {
    check_word_boundary(at);
    if (inside_unit()) {
        error(at, fmt::format("an instruction inside of {} bytes that have one address",
                              dialect_.address_unit));
        dot_ = (here() + 1) * dialect_.address_unit;
    }
}

}  // namespace rasterloom::isa::assembler
