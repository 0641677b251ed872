// SPDX-License-Identifier: MIT
// Every compiler, machine and build type must give the same bits: what reaches the processors is
// compared with a checksum.
#include "topologies/geodesic.hpp"
#include "topologies/routing.hpp"
#include "topologies/screen_map.hpp"

#include <bit>
#include <cstdint>

#include <gtest/gtest.h>

namespace rasterloom::topology {
namespace {

class Checksum {  // FNV-1a over words
  public:
    void add(std::uint64_t word) { sum_ = (sum_ ^ word) * 0x100000001b3; }
    void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
    void add(const Vec14& v) {
        for (const std::int16_t part : {v.x, v.y, v.z}) {
            add(std::uint64_t{static_cast<std::uint16_t>(part)});
        }
    }
    std::uint64_t value() const { return sum_; }

  private:
    std::uint64_t sum_ = 0xcbf29ce484222325;
};

TEST(Determinism, PlacesOfNodesHaveTheSameBitsEverywhere) {
    Checksum sum;
    for (const Node& node : geodesic(7, 3).nodes) {
        for (const double x :
             {node.direction.x, node.direction.y, node.direction.z, node.phi, node.theta}) {
            sum.add(x);
        }
    }
    EXPECT_EQ(sum.value(), 16313467287778343986U);
}

TEST(Determinism, RoutingTablesHaveTheSameBitsEverywhere) {
    Checksum sum;
    for (const RoutingNode& node : make_routing_table(geodesic(4, 4), {1, -2, 3}).nodes) {
        for (const Angle16 word :
             {node.phi, node.theta, node.centre_theta, node.half_phi, node.half_theta}) {
            sum.add(std::uint64_t{word});
        }
        sum.add(node.direction);
        for (const Vec14& v : node.neighbours) {
            sum.add(v);
        }
        for (const SlopeSector& s : node.sectors) {
            sum.add(std::uint64_t{s.limit} * 256 + s.port);
        }
    }
    EXPECT_EQ(sum.value(), 3270897936265206282U);
}

TEST(Determinism, ScreenMapsHaveTheSameBitsEverywhere) {
    Checksum sum;
    for (const NodeIndex owner : nearest_pixel_map(geodesic(4, 4), 256, 256).owner) {
        sum.add(std::uint64_t{owner});
    }
    EXPECT_EQ(sum.value(), 709689802279853578U);
}

}  // namespace
}  // namespace rasterloom::topology
