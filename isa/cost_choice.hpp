// SPDX-License-Identifier: MIT
// A choice of cost model held against the models an ISA has.
#pragma once

#include "isa/isa.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace rasterloom::isa {

struct ResolvedCosts {
    std::size_t model = 0;             // index into the models
    std::vector<std::int64_t> values;  // one for each of its parameters, in their order
};

// Throws std::invalid_argument for an unknown model or parameter, naming the valid ones and the
// nearest, and for a negative number. `models` must not be empty.
ResolvedCosts resolve_costs(std::string_view isa_name, std::span<const CostModelInfo> models,
                            const CostChoice& choice);

}  // namespace rasterloom::isa
