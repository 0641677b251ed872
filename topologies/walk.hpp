// SPDX-License-Identifier: MIT
// The last steps of a message that is addressed to a pixel. Angular routing (routing.hpp) ends at a
// node whose region of the sphere is near the pixel; the pixel's owner is the nearest node on the
// flat screen, which is another one now and then, above all near the poles. From there the message
// walks over the screen from owner to owner.
//
// At a node, with target pixel (x, y) on a screen `width` wide:
//   1. The node owns no pixels: follow `home`, to the owner of the pixel in which the node itself
//   stands.
//   2. It owns a segment on row y. r = x - segment.x, plus width if negative. Arrived if r <
//   segment.length; else follow
//      `right` if 2 r < width, else `left`. (The row closes on itself as the sphere does.)
//   3. It owns segments above row y: follow `down` of the last of them, to the owner of the pixel
//   below its middle.
//   4. Else follow `up`, to the owner of the pixel above the middle of the node's first segment.
// Each step brings the message nearer to the row, then nearer to the column, so that it always
// ends.
//
// A link is a Path: the ports to take, three bits a hop, first hop in the low bits, at most five;
// all other bits are ones, so that an arithmetic shift right by three brings up the next hop, and 7
// is the end. A message carries what is left of its path; a node that reads 7 applies the rules
// again. A walking message never goes back to angular routing.
#pragma once

#include "topologies/screen_map.hpp"
#include "topologies/topology.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace rasterloom::topology {

using Path = std::uint16_t;

inline constexpr Path kEmptyPath = 0177777;
inline constexpr int kMaxPathHops = 5;

constexpr std::optional<int> first_hop(Path path) {
    return (path & 7) == 7 ? std::nullopt : std::optional<int>(path & 7);
}

constexpr Path rest_of(Path path) {
    return static_cast<Path>((path >> 3) | 0160000);
}

struct WalkSegment {
    std::uint16_t x = 0;
    std::uint16_t y = 0;
    std::uint16_t length = 0;
    Path left = kEmptyPath;  // empty only where the node owns the whole row
    Path right = kEmptyPath;
    Path down =
        kEmptyPath;  // empty where the node owns a segment on the next row, and on the last row
};

struct WalkNode {
    std::vector<WalkSegment> segments;  // ascending y
    Path up = kEmptyPath;               // empty on the first row
    Path home = kEmptyPath;             // only of nodes without segments
};

struct WalkTable {
    int width = 0;
    int height = 0;
    std::vector<WalkNode> nodes;
};

// Memory grows with nodes and segments. Throws std::invalid_argument if a node has more than 7
// ports or if an owner that a link must reach is more than kMaxPathHops away.
WalkTable make_walk_table(const Topology& topology, const ScreenMap& map);

// The path to follow from a node towards pixel (x, y), 0 <= x < width, 0 <= y < height; nothing
// when the node owns it.
std::optional<Path> walk_path(const WalkNode& node, int width, int x, int y);

// The middle of pixel x or y as a binary angle, rounded down: ((2 x + 1) 65536) / (2 width), ((2 y
// + 1) 32768) / (2 height).
Angle16 pixel_phi(int x, int width);
Angle16 pixel_theta(int y, int height);

}  // namespace rasterloom::topology
