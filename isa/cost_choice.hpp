// SPDX-License-Identifier: MIT
// A choice of cost model held against the models an ISA has.
#pragma once

#include "isa/isa.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace rasterloom::isa {

// Of one parameter, in cycles: sums of a few stay far from the end of any integer.
inline constexpr std::int64_t kHighestCost = 10'000;

struct ResolvedCosts {
    std::size_t model = 0;             // index into the models
    std::vector<std::int64_t> values;  // one for each of its parameters, in their order
};

// Throws std::invalid_argument for an unknown model or parameter, naming the valid ones and the
// nearest, and for a number outside of 0 to kHighestCost. `models` must not be empty.
ResolvedCosts resolve_costs(std::string_view isa_name, std::span<const CostModelInfo> models,
                            const CostChoice& choice);

}  // namespace rasterloom::isa
