// SPDX-License-Identifier: MIT
// A run in one row: the figures by which many runs are compared, most of which every machine has. All of them are
// emulated, so the same run gives the same row on any host.
#pragma once

#include "machine/observe/run_report.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace rasterloom::observe {

using Cell = std::variant<std::nullptr_t, std::int64_t, double, std::string>;  // null: has none

struct Figure {
    std::string_view name;  // of the column, with its unit
    std::string_view type;  // of the column, in SQL
    Cell (*of)(const RunReport& report);
};

std::span<const Figure> run_figures();

}  // namespace rasterloom::observe
