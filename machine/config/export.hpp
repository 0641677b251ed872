// SPDX-License-Identifier: MIT
// MachineDescription -> YAML that loads to the same description, and the documentation of all keys.
#pragma once

#include "machine/config/description.hpp"

#include <string>

namespace rasterloom::config {

// Every value, defaults included; files as absolute paths.
std::string export_machine(const MachineDescription& machine);

// A Markdown table: key, value, default, meaning. docs/configuration.md holds it.
std::string keys_as_markdown();

}  // namespace rasterloom::config
