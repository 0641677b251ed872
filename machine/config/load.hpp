// SPDX-License-Identifier: MIT
// YAML file -> MachineDescription. Strict: an unknown key, a wrong type, unit or value, a missing
// file each end in a ConfigError that says where and what was expected.
#pragma once

#include "machine/config/description.hpp"
#include "machine/config/locator.hpp"
#include "machine/config/value.hpp"

#include <span>
#include <string>
#include <string_view>

namespace rasterloom::config {

// `file`: a path, or the name of a file in the data folder's configs/. Overrides are applied in
// order before anything is checked.
MachineDescription load_machine(const std::string& file, std::span<const Override> overrides,
                                const Locator& locator);

// The same for a text; `source` names it in messages, and relative files are looked for in the
// working directory.
MachineDescription read_machine(std::string_view text, const std::string& source,
                                std::span<const Override> overrides, const Locator& locator);

// Of what is wrong with an override, finds what is wrong with it for any machine: a key that does
// not exist, a value that the key cannot take. Names below topology, nodes.cost and nodes.symbols
// depend on the machine and pass.
void check_key(const std::vector<std::string>& path, const Position& where);
void check_override(const Override& change, const Locator& locator);

}  // namespace rasterloom::config
