// SPDX-License-Identifier: MIT
// List scheduling of a block: which bundles of the source go together into one, and in which order.
#pragma once

#include "isa/vliw/bundle.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace rasterloom::isa::vliw {

// Both in one bundle, if the hardware can: no slot twice, one immediate, ports enough. The bundles
// have zeros in unused fields.
std::optional<Bundle> merged(const Bundle& a, const Bundle& b);

struct ScheduledBundle {
    Bundle bundle;
    std::vector<std::size_t> sources;  // indices into the block, ascending
};

// `ends`: the block's last bundle leaves it, so all others come before it or beside it.
std::vector<ScheduledBundle> schedule(std::span<const Bundle> block, bool ends);

}  // namespace rasterloom::isa::vliw
