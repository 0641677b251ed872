// SPDX-License-Identifier: MIT
// Symbols of one pass, with those of the pass before it for references forward.
#pragma once

#include "isa/image.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace rasterloom::isa::assembler {

struct Symbol {
    std::int64_t value = 0;
    bool label = false;  // else assigned, and may be assigned again
    SourceLocation where;
    mutable bool used = false;  // somebody asked for it
};

class SymbolTable {
  public:
    using Map = std::map<std::string, Symbol, std::less<>>;

    explicit SymbolTable(const Map* previous) : previous_(previous) {}

    // This pass's value if there is one yet, else the previous pass's.
    std::optional<std::int64_t> value_of(std::string_view name) const;
    const Symbol* find(std::string_view name) const;  // defined so far in this pass
    void define(std::string_view name, Symbol symbol);
    // Local labels ("1$") belong to the stretch between two ordinary labels.
    void begin_local_scope() { ++scope_; }
    const Map& symbols() const { return symbols_; }

    static bool is_local(std::string_view name) {
        return !name.empty() && name[0] >= '0' && name[0] <= '9';
    }

  private:
    std::string key(std::string_view name) const;

    const Map* previous_;  // may be null
    Map symbols_;
    int scope_ = 0;
};

}  // namespace rasterloom::isa::assembler
