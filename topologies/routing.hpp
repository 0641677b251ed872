// SPDX-License-Identifier: MIT
// Store-and-forward routing on the sphere (Strothotte 1981, 5.1.8), as the 16-bit integer
// procedures that the node programs carry out hop by hop. The functions below are the reference
// that the programs are tested against, bit by bit.
//
// Angles are binary (65536 = 360 degrees). phi wraps; theta counts from the north pole, 0 to 32767
// (the south pole, 32768, is kept as 32767 so that differences of theta fit a signed word). All are
// taken in "virtual" coordinates, whose north pole is a chosen axis (5.1.2.2): with the rotation
// axis, a rotation only adds to phi; with +z they are the screen's coordinates.
//
// Small-circle (5.1.8.2), a straight line in the (phi, theta) plane. At a node with target (F.phi,
// F.theta):
//   1. dphi = F.phi - phi (16 bits, wraps to the shorter way), dtheta = F.theta - centre_theta.
//   2. Arrived if |dphi| <= half_phi and |dtheta| <= half_theta, compared without sign (|-32768| =
//   32768).
//   3. s = slope(dphi, dtheta); at a polar node s = dphi instead, without a division.
//   4. Take the first sector, in ascending order, with s <= limit (without sign): its port is the
//   neighbour whose slope is nearest.
//   5. Arrived if that is the port through which the message came: the two nodes would pass it to
//   and fro for ever.
// A message that has made kMaxHops hops has arrived where it is. No route on the graphs tested gets
// near that bound
// ((20, 20): 126), but it makes the end certain for any table.
//
// slope(x, y) maps the direction of (x, y) to a binary angle that grows with the true one, at the
// price of one division:
//   a = |x| >> 1, b = |y| >> 1 (without sign), q = (b << 14) / (a + b) rounded down, 0 when a + b =
//   0; q, 32768 - q, 32768 + q, -q in the quadrants (x >= 0, y >= 0), (x < 0, y >= 0), (x < 0, y <
//   0), (x >= 0, y < 0), modulo 65536.
//
// Great-circle (5.1.8.1, first method), the neighbour nearest to the target. Directions are s1.14
// (16384 = 1):
//   1. and 2. as above.
//   3. For the node and each neighbour in port order, d = n.x F.x + n.y F.y + n.z F.z, 32 bits,
//   exact.
//   4. Take the first port with the greatest d; arrived if that is not greater than the node's own
//   d.
// Each hop comes nearer, so that it always ends.
#pragma once

#include "topologies/topology.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace rasterloom::topology {

inline constexpr int kMaxHops = 255;

// A direction as three s1.14 fixed-point words: -16384 to 16384.
struct Vec14 {
    std::int16_t x = 0;
    std::int16_t y = 0;
    std::int16_t z = 0;
    friend bool operator==(const Vec14&, const Vec14&) = default;
};

// Where a message goes. Only great-circle routing needs the direction.
struct RouteTarget {
    Angle16 phi = 0;
    Angle16 theta = 0;  // 0 to 32767
    Vec14 direction;
};

// Slopes above the previous sector's limit up to and including this one's belong to the port.
struct SlopeSector {
    Angle16 limit = 0;
    std::uint8_t port = 0;
};

struct RoutingNode {
    Angle16 phi = 0;
    Angle16 theta = 0;  // 0 to 32767
    Angle16 centre_theta =
        0;  // of the arrival rectangle: theta, but at a polar node the pole's, 0 or 32767
    // Half the width and height of the rectangle that holds the node's region (the points nearest
    // to it), at least 2.
    Angle16 half_phi = 0;  // 32768 at a polar node: all longitudes
    Angle16 half_theta = 0;
    bool is_polar = false;  // the region contains a pole of the axis
    Vec14 direction;
    std::vector<Vec14> neighbours;  // neighbours[k]: direction of the node at port k
    std::vector<SlopeSector>
        sectors;  // ascending; the last limit is 65535; empty for a node without ports
};

struct RoutingTable {
    Vec3 axis;  // unit
    std::vector<RoutingNode> nodes;
};

// The virtual coordinate system of an axis: z along it, x as near to the world's +x as can be (to
// +y for an axis within 26 degrees of x). The axis +z gives the world's own coordinates. Throws
// std::invalid_argument for the zero vector.
struct VirtualFrame {
    Vec3 x;
    Vec3 y;
    Vec3 z;
    Vec3 to_virtual(const Vec3& world) const;
    Vec3 to_world(const Vec3& local) const;
};
VirtualFrame virtual_frame(const Vec3& axis);

// Time and memory grow with nodes and links. Throws std::invalid_argument if a node has no position
// in space (a graph read from a file), more than 255 ports, or the axis is zero.
RoutingTable make_routing_table(const Topology& topology, const Vec3& axis);

Angle16 slope(std::int16_t x, std::int16_t y);

// sin(angle) in s1.14 by linear interpolation in a quarter wave of 257 words, quarter_wave14(k) =
// round(16384 sin(90 k / 256)), 0 <= k <= 256. With r the angle's place in its quarter (counted
// backwards in odd quarters), i = r >> 6, f = r & 63: T[i] + (((T[i + 1] - T[i]) f + 32) >> 6).
std::int16_t quarter_wave14(int k);
std::int16_t sine14(Angle16 angle);
std::int16_t cosine14(Angle16 angle);

// The target with its direction: x = (sin theta cos phi + 8192) >> 14, y likewise with sin phi, z =
// cos theta, in s1.14. theta above 32767 counts as 32767.
RouteTarget make_target(unsigned phi, unsigned theta);

// The port to pass a message on, or nothing when it has arrived. `from` is the port it came
// through, nothing at its source.
std::optional<int> small_circle_port(const RoutingNode& node, const RouteTarget& target,
                                     std::optional<int> from);
std::optional<int> great_circle_port(const RoutingNode& node, const RouteTarget& target,
                                     std::optional<int> from);

}  // namespace rasterloom::topology
