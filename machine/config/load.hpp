// SPDX-License-Identifier: MIT
// YAML file -> MachineDescription. Strict: an unknown key, a wrong type, unit or value, a missing
// file each end in a ConfigError that says where and what was expected.
#pragma once

#include "machine/config/description.hpp"
#include "machine/config/locator.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::config {

// `file`: a path, or the name of a file in the data folder's configs/. `overrides`:
// "links.time_per_byte=2us", applied in order before anything is checked.
MachineDescription load_machine(const std::string& file, const std::vector<std::string>& overrides,
                                const Locator& locator);

// The same for a text; `source` names it in messages, and relative files are looked for in the
// working directory.
MachineDescription read_machine(std::string_view text, const std::string& source,
                                const std::vector<std::string>& overrides, const Locator& locator);

}  // namespace rasterloom::config
