// SPDX-License-Identifier: MIT
// Tables that the host gives to every lane of the Princeton Engine, as programs/vliw/memory.s
// defines them: divisions and roots by look-up (Eldridge 1995, 7.3.2 and 7.3.4).
#pragma once

#include <cstdint>
#include <vector>

namespace rasterloom::host {

// [z], z = 0 ... 32767: 2^28 / z to the nearest integer, halves up; 65535 at most, and for 0.
std::vector<std::uint16_t> reciprocal_table();

// [m - 128], m = 128 ... 511: 2^18 / sqrt(2 m) to the nearest integer.
std::vector<std::uint16_t> root_table();

}  // namespace rasterloom::host
