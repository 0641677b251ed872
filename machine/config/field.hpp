// SPDX-License-Identifier: MIT
// One row for each key of a configuration: the loader, the exporter and the table in
// docs/configuration.md are all made from these rows, so they cannot disagree.
#pragma once

#include "machine/config/description.hpp"
#include "machine/config/locator.hpp"
#include "machine/config/value.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::config {

struct Field {
    std::string path;      // "links.time_per_byte"
    std::string expected;  // "a duration such as 300ns or 5us": documentation and error messages
    std::string summary;
    bool required = false;

    // Throws std::invalid_argument with what is wrong with the value; the loader adds where and
    // what was expected.
    std::function<void(MachineDescription&, const Value&, const Locator&)> read;
    // The value as YAML text; empty when it is not set.
    std::function<std::string(const MachineDescription&)> write;
};

// All rows, those of a section together, in the order in which they are documented and exported.
std::vector<Field> machine_fields();

}  // namespace rasterloom::config
