// SPDX-License-Identifier: MIT
// Small regular graphs: a single node, a ring, a grid and its torus.
#pragma once

#include "topologies/topology.hpp"

namespace rasterloom::topology {

inline constexpr int kMaxRegularNodes = 1 << 20;

// One node without ports. It stands in the middle of the screen: phi 180, theta 90.
Topology single();

// Node k at phi = 360 k / n on the equator. Port 0 leads to node k + 1, port 1 to node k - 1 (mod
// n); with two nodes there is one port. Throws std::invalid_argument unless 2 <= n <=
// kMaxRegularNodes.
Topology ring(int n);

// Node y * width + x stands in the middle of its cell of the (phi, theta) plane: phi = 360 (x +
// 1/2) / width, theta = 180 (y + 1/2) / height. Ports in the order right, up, left, down (those
// that exist; up is a smaller y). A torus joins its opposite sides; a side of 2 is not joined
// twice, and a side of 1 not at all. Throws std::invalid_argument unless sides are positive with 2
// to kMaxRegularNodes nodes.
Topology grid(int width, int height);
Topology torus(int width, int height);

}  // namespace rasterloom::topology
