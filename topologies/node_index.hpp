// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace rasterloom::topology {

using NodeIndex = std::uint32_t;

}  // namespace rasterloom::topology
