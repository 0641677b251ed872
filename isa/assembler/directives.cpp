// SPDX-License-Identifier: MIT
// Directives for data, the location counter and settings.
#include "isa/assembler/pass.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::isa::assembler {

std::span<const Pass::Directive> Pass::directives() {
    static constexpr std::array kDirectives = {
        Directive{".word", &Pass::do_word},
        Directive{".byte", &Pass::do_byte},
        Directive{".blkb", &Pass::do_blkb},
        Directive{".blkw", &Pass::do_blkw},
        Directive{".even", &Pass::do_even},
        Directive{".odd", &Pass::do_odd},
        Directive{".ascii", &Pass::do_ascii, true},
        Directive{".asciz", &Pass::do_asciz, true},
        Directive{".org", &Pass::do_org},
        Directive{".radix", &Pass::do_radix},
        Directive{".end", &Pass::do_end},
        Directive{".error", &Pass::do_error, true},
        Directive{".include", &Pass::do_include},
        Directive{".macro", &Pass::do_macro},
        Directive{".mexit", &Pass::do_mexit},
        Directive{".rept", &Pass::do_rept},
        Directive{".irp", &Pass::do_irp},
        Directive{".irpc", &Pass::do_irpc},
        Directive{".narg", &Pass::do_narg},
        Directive{".nchr", &Pass::do_nchr},
        Directive{".endm", &Pass::do_stray_end},
        Directive{".endr", &Pass::do_stray_end},
        Directive{".iif", &Pass::do_iif},
        Directive{".title", &Pass::do_nothing, true},
        Directive{".sbttl", &Pass::do_nothing, true},
        Directive{".ident", &Pass::do_nothing, true},
        Directive{".list", &Pass::do_nothing},
        Directive{".nlist", &Pass::do_nothing},
        Directive{".page", &Pass::do_nothing},
        Directive{".globl", &Pass::do_nothing},
        Directive{".global", &Pass::do_nothing},
        Directive{".mcall", &Pass::do_nothing},
        Directive{".enabl", &Pass::do_nothing},
        Directive{".dsabl", &Pass::do_nothing},
        Directive{".asect", &Pass::do_nothing},
    };
    return kDirectives;
}

const Pass::Directive* Pass::find_directive(std::string_view name) {
    const auto all = directives();
    const auto found = std::find_if(
        all.begin(), all.end(), [&](const Directive& directive) { return directive.name == name; });
    return found == all.end() ? nullptr : &*found;
}

std::vector<std::string_view> Pass::directive_names() {
    std::vector<std::string_view> names = {".if",   ".iff",  ".ift",  ".iftf",
                                           ".else", ".endc", ".endif"};
    for (const Directive& directive : directives()) {
        names.push_back(directive.name);
    }
    return names;
}

// Calls `use` with each value of a list separated by commas, and where it stands.
void Pass::each_value(Rest operands,
                      const std::function<void(std::optional<std::int64_t>, std::size_t)>& use) {
    std::size_t position = 0;
    while (true) {
        Cursor cursor(operands.text, position);
        cursor.skip_blanks();
        const std::size_t at = operands.at + cursor.position();
        const ExpressionValue value = read_expression(
            cursor.rest(), radix_, [this](std::string_view name) { return symbol_value(name); });
        errors(value.errors, at);
        use(value.value, at);
        cursor.move_to(cursor.position() + value.end);
        cursor.skip_blanks();
        if (cursor.at_end()) {
            return;
        }
        if (!cursor.take(',')) {
            if (value.errors.empty()) {
                error(operands.at + cursor.position(), "expected a comma between the values");
            }
            return;
        }
        position = cursor.position();
    }
}

void Pass::do_word(Rest operands) {
    check_word_boundary(operands.at);
    if (trim(operands.text).empty()) {
        return emit_word(0);
    }
    each_value(operands, [this](std::optional<std::int64_t> value, std::size_t at) {
        emit_word(as_word(value, at).value_or(0));
    });
}

void Pass::do_byte(Rest operands) {
    if (trim(operands.text).empty()) {
        return emit_byte(0);
    }
    each_value(operands, [this](std::optional<std::int64_t> value, std::size_t at) {
        if (value && (*value < -0x80 || *value > 0xff)) {
            error(at, fmt::format("the value {}. does not fit in a byte (-128. to 255.)", *value));
        }
        emit_byte(static_cast<std::uint8_t>(value.value_or(0) & 0xff));
    });
}

void Pass::do_blkb(Rest operands) {
    reserve(operands, 1);
}

void Pass::do_blkw(Rest operands) {
    check_word_boundary(operands.at);
    reserve(operands, 2);
}

// Reserved room is filled with zeros, so that it is the same on every load.
void Pass::reserve(Rest operands, std::int64_t unit) {
    const auto count =
        trim(operands.text).empty() ? std::optional<std::int64_t>(1) : evaluate(operands);
    if (!count) {
        return;
    }
    const std::int64_t room = end_of_memory() - dot_;
    if (*count < 0 || *count * unit > room) {
        return error(operands.at, fmt::format("no room for {}. times {} bytes: {}. are left",
                                              *count, unit, room));
    }
    for (std::int64_t i = 0; i < *count * unit; ++i) {
        emit_byte(0);
    }
}

void Pass::do_even(Rest) {
    if ((dot_ & 1) != 0) {
        emit_byte(0);
    }
}

void Pass::do_odd(Rest) {
    if ((dot_ & 1) == 0) {
        emit_byte(0);
    }
}

// .ascii /text/<15><12>/more/: any character delimits, <expression> is one byte.
void Pass::do_ascii(Rest operands) {
    Cursor cursor(operands.text);
    cursor.skip_blanks();
    if (cursor.at_end() || cursor.peek() == ';') {
        return error(operands.at, "a delimited text is missing");
    }
    for (; !cursor.at_end() && cursor.peek() != ';'; cursor.skip_blanks()) {
        const std::size_t at = operands.at + cursor.position();
        const bool is_value = cursor.peek() == '<';
        const auto text = cursor.take_delimited();
        if (!text) {
            return error(at,
                         fmt::format("no '{}' closes the text", is_value ? '>' : cursor.peek()));
        }
        if (is_value) {
            do_byte({*text, at + 1});
            continue;
        }
        for (const char c : *text) {
            emit_byte(static_cast<std::uint8_t>(c));
        }
    }
}

void Pass::do_asciz(Rest operands) {
    do_ascii(operands);
    emit_byte(0);
}

void Pass::do_org(Rest operands) {
    if (const auto address = as_address(evaluate(operands), operands.at)) {
        dot_ = std::int64_t{*address} * dialect_.address_unit;
        lines_.back().address = *address;
    }
}

void Pass::do_radix(Rest operands) {
    const std::string_view text = trim(operands.text);
    if (text.empty()) {
        radix_ = dialect_.syntax->default_radix();
    } else if (text == "2" || text == "8" || text == "10" || text == "16") {
        radix_ = text == "2" ? 2 : text == "8" ? 8 : text == "10" ? 10 : 16;
    } else {
        error(operands.at, fmt::format("'{}' is no radix: 2, 8, 10 or 16 is expected", text));
    }
}

void Pass::do_end(Rest operands) {
    if (!trim(operands.text).empty()) {
        entry_ = as_address(evaluate(operands), operands.at);
    }
    for (const Conditional& open : conditionals_) {
        diagnostics_.push_back({open.where, "no .endc closes this .if", {}});
    }
    stopped_ = true;
}

void Pass::do_error(Rest operands) {
    std::string_view text = trim(operands.text);
    if (!text.empty() && text.front() == ';') {
        text = trim(text.substr(1));
    }
    error(operands.at, fmt::format(".error: {}", text));
}

void Pass::do_include(Rest operands) {
    Cursor cursor(operands.text);
    cursor.skip_blanks();
    const std::size_t at = operands.at + cursor.position();
    const auto name = cursor.take_delimited();
    if (!name || name->empty()) {
        return error(at, "a delimited file name is missing: .include \"name\"");
    }
    if (sources_.depth() >= LineSource::kDeepest) {
        return error(
            at, fmt::format("files include one another more than {} deep", LineSource::kDeepest));
    }
    std::vector<std::filesystem::path> candidates = {sources_.top().directory / *name};
    for (const auto& include_dir : options_.include_dirs) {
        candidates.push_back(include_dir / *name);
    }
    std::string tried;
    for (const auto& candidate : candidates) {
        if (const Lines lines = files_.lines_of(candidate)) {
            LineSource::Frame frame;
            frame.lines = lines;
            frame.directory = candidate.parent_path();
            frame.conditionals_open = conditionals_.size();
            frame.from = std::make_shared<Expansion>(
                Expansion{{".include", line_->location(at)}, line_->expansion()});
            return sources_.push(std::move(frame));
        }
        tried += (tried.empty() ? "" : ", ") + candidate.string();
    }
    error(at, fmt::format("cannot read '{}' (tried {})", *name, tried));
}

void Pass::do_nothing(Rest) {}

}  // namespace rasterloom::isa::assembler
