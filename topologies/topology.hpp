// SPDX-License-Identifier: MIT
// A machine's wiring as a plain graph: which node's port leads to which neighbour, and where the
// nodes stand.
#pragma once

#include "topologies/bucket_tiles.hpp"
#include "topologies/node_index.hpp"
#include "topologies/tiling.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rasterloom::topology {

// A binary angle: 65536 units are a full turn, so that 16-bit arithmetic wraps as angles do.
using Angle16 = std::uint16_t;

struct Vec3 {
    double x = 0, y = 0, z = 0;
};

struct Node {
    std::string name;  // "P31-123"
    Vec3 direction;    // unit vector, where the topology has positions in space; else zero
    double phi = 0;    // degrees, 0 <= phi < 360, longitude (0 along +x, growing towards +y)
    double theta = 0;  // degrees, 0 <= theta <= 180, from the north pole (+z)
};

struct Topology {
    std::string kind;  // as `rasterloom list topologies` names it: "geodesic", "ring", ...
    std::vector<Node> nodes;
    std::vector<std::vector<NodeIndex>>
        ports;  // ports[n][k]: the node at the other end of n's port k
    // Geodesic only: mutually adjacent nodes, counter-clockwise seen from outside the sphere.
    std::vector<std::array<NodeIndex, 3>> triangles;
    // Parks' machines only: the nodes, "P0" and so on, have no ports among themselves but shares of
    // the screen.
    std::optional<Tiling> tiling;
    // Bucket tilers only: the nodes, "R0" and so on, have no ports either; they draw tiles of this
    // size.
    std::optional<TileSize> tile;
};

}  // namespace rasterloom::topology
