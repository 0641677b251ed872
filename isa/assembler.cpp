// SPDX-License-Identifier: MIT
#include "isa/assembler.hpp"

#include "isa/assembler/pass.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::isa {
namespace {

using assembler::FileStore;
using assembler::Lines;
using assembler::Pass;
using assembler::SymbolTable;

constexpr int kMostPasses = 12;

bool same_values(const SymbolTable::Map& a, const SymbolTable::Map& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
        return x.first == y.first && x.second.value == y.second.value;
    });
}

// A symbol's value as it stands in memory: negative ones in two's complement of a word.
std::uint32_t memory_value(std::int64_t value) {
    return static_cast<std::uint32_t>(value < 0 ? value & 0xffff : value);
}

Image make_image(Pass& pass, std::string_view name, const Dialect& dialect) {
    Image image;
    image.name = std::string(name);
    image.segments = pass.segments();
    for (const auto& [symbol, definition] : pass.symbols()) {
        if (!SymbolTable::is_local(symbol)) {
            image.symbols.emplace(symbol, memory_value(definition.value));
            if (definition.label) {
                image.labels.insert(symbol);
            }
        }
    }
    for (const AssembledLine& line : pass.lines()) {
        if (!line.bytes.empty()) {
            image.lines.emplace(line.address, line.where);
        }
    }
    const std::uint32_t lowest = image.segments.empty() ? 0 : image.segments.front().address;
    image.entry = pass.entry().value_or(lowest / static_cast<std::uint32_t>(dialect.address_unit));
    return image;
}

void sort_by_place(std::vector<Diagnostic>& diagnostics) {
    const auto place = [](const Diagnostic& d) {
        return std::tie(d.where.file, d.where.line, d.where.column, d.message);
    };
    std::sort(diagnostics.begin(), diagnostics.end(),
              [&](const Diagnostic& a, const Diagnostic& b) { return place(a) < place(b); });
}

// What keeps changing from pass to pass: the first symbol that did.
Diagnostic unsettled(const SymbolTable::Map& before, const SymbolTable::Map& after) {
    for (const auto& [name, symbol] : after) {
        const auto earlier = before.find(name);
        if (earlier == before.end() || earlier->second.value != symbol.value) {
            return {symbol.where,
                    fmt::format("phase error: the value of '{}' does not settle; a conditional "
                                "depends on what it changes",
                                name),
                    {}};
        }
    }
    return {before.begin()->second.where, "phase error: symbols come and go from pass to pass", {}};
}

std::vector<std::string> unused(const Pass& pass, const AssemblerOptions& options) {
    std::vector<std::string> names;
    for (const auto& [name, value] : options.defines) {
        const auto found = pass.symbols().find(name);
        if (found != pass.symbols().end() && !found->second.used) {
            names.push_back(name);
        }
    }
    return names;
}

Assembly assemble_lines(const Dialect& dialect, std::string_view name, const Lines& lines,
                        const std::filesystem::path& directory, const AssemblerOptions& options,
                        FileStore& files) {
    const assembler::Vocabulary vocabulary(dialect);
    SymbolTable::Map previous;
    for (int number = 1;; ++number) {
        Pass pass(dialect, vocabulary, options, files, &previous);
        pass.run(lines, directory);
        const bool settled = same_values(previous, pass.symbols());
        if (!settled && number < kMostPasses) {
            previous = pass.symbols();
            continue;
        }
        if (!settled) {
            pass.diagnostics().push_back(unsettled(previous, pass.symbols()));
        }
        Assembly assembly{make_image(pass, name, dialect), std::move(pass.diagnostics()),
                          std::move(pass.lines()), unused(pass, options)};
        sort_by_place(assembly.diagnostics);
        return assembly;
    }
}

}  // namespace

Dialect dialect_of(const Isa& isa) {
    return {isa.instructions(), &isa.syntax(), isa.word_bits(), isa.address_bits(),
            isa.address_unit()};
}

Assembly assemble_file(const Dialect& dialect, const std::filesystem::path& path,
                       const AssemblerOptions& options) {
    FileStore files;
    const Lines lines = files.lines_of(path);
    if (lines == nullptr) {
        Assembly assembly;
        assembly.image.name = path.string();
        Diagnostic& unreadable = assembly.diagnostics.emplace_back();
        unreadable.where.file = path.string();
        unreadable.message = "cannot read this file";
        return assembly;
    }
    return assemble_lines(dialect, path.string(), lines, path.parent_path(), options, files);
}

Assembly assemble_text(const Dialect& dialect, std::string_view name, std::string_view text,
                       const AssemblerOptions& options) {
    FileStore files;
    return assemble_lines(dialect, name, assembler::split_lines(name, text), {}, options, files);
}

Assembly assemble_file(const Isa& isa, const std::filesystem::path& path,
                       const AssemblerOptions& options) {
    return assemble_file(dialect_of(isa), path, options);
}

Assembly assemble_text(const Isa& isa, std::string_view name, std::string_view text,
                       const AssemblerOptions& options) {
    return assemble_text(dialect_of(isa), name, text, options);
}

Image assemble_image(const Isa& isa, const std::filesystem::path& path,
                     const AssemblerOptions& options) {
    Assembly assembly = assemble_file(isa, path, options);
    if (!assembly.ok()) {
        throw AssemblyError(std::move(assembly.diagnostics));
    }
    return std::move(assembly.image);
}

}  // namespace rasterloom::isa
