// SPDX-License-Identifier: MIT
#include "isa/assembler/symbol_table.hpp"

#include <utility>

#include <fmt/format.h>

namespace rasterloom::isa::assembler {

std::string SymbolTable::key(std::string_view name) const {
    // A local label's number first, so that the key is still recognised as local; a blank is in no
    // symbol.
    return is_local(name) ? fmt::format("{} {}", name, scope_) : std::string(name);
}

std::optional<std::int64_t> SymbolTable::value_of(std::string_view name) const {
    const std::string full = key(name);
    if (const auto found = symbols_.find(full); found != symbols_.end()) {
        found->second.used = true;
        return found->second.value;
    }
    if (previous_ != nullptr) {
        if (const auto found = previous_->find(full); found != previous_->end()) {
            return found->second.value;
        }
    }
    return std::nullopt;
}

const Symbol* SymbolTable::find(std::string_view name) const {
    const auto found = symbols_.find(key(name));
    if (found == symbols_.end()) {
        return nullptr;
    }
    found->second.used = true;
    return &found->second;
}

void SymbolTable::define(std::string_view name, Symbol symbol) {
    symbols_.insert_or_assign(key(name), std::move(symbol));
}

}  // namespace rasterloom::isa::assembler
