// SPDX-License-Identifier: MIT
#pragma once

#include "topologies/node_index.hpp"

#include <string>

#include <fmt/format.h>

namespace rasterloom::topology {

// Of a processor's share of the screen in a drawing, as SVG takes it: neighbouring numbers get hues
// far apart.
inline std::string node_colour(NodeIndex node) {
    const unsigned hue = node * 137 % 360;
    return fmt::format("hsl({}, 45%, {}%)", hue, 70 + node / 360 % 3 * 8);
}

}  // namespace rasterloom::topology
