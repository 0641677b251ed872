// SPDX-License-Identifier: MIT
#include "machine/emulation/strothotte_facets.hpp"

#include "machine/emulation/strothotte_view.hpp"
#include "topologies/angles.hpp"

#include <algorithm>
#include <cmath>

namespace rasterloom {

namespace {

constexpr std::size_t kHeaderBytes = 18;
constexpr std::size_t kCrossingBytes = 8;
constexpr std::size_t kTriangleBytes = 6;
constexpr std::int64_t kKindFacet = 1;
constexpr int kMaxTheta = 32767;

class Words {
  public:
    void add(std::int64_t word) {
        bytes_.push_back(static_cast<std::uint8_t>(word & 0xff));
        bytes_.push_back(static_cast<std::uint8_t>(word >> 8 & 0xff));
    }
    std::vector<std::uint8_t> take() { return std::move(bytes_); }

  private:
    std::vector<std::uint8_t> bytes_;
};

}  // namespace

std::vector<std::vector<OwnedTriangle>> share_triangles(const host::FacetModel& model) {
    std::vector<std::vector<OwnedTriangle>> shares(model.crossings.size());
    for (const OwnedTriangle& triangle : model.triangles) {
        const auto lighter = [&](const auto& a, const auto& b) {
            return shares[a.facet].size() < shares[b.facet].size();
        };
        const auto first = std::min_element(triangle.begin(), triangle.end(), lighter);
        OwnedTriangle owned = triangle;
        std::rotate(owned.begin(), owned.begin() + (first - triangle.begin()), owned.end());
        shares[owned[0].facet].push_back(owned);
    }
    return shares;
}

std::size_t facet_bytes(std::size_t crossings, std::size_t triangles) {
    return kHeaderBytes + kCrossingBytes * crossings + kTriangleBytes * triangles;
}

std::vector<std::uint8_t> make_facet(std::uint32_t facet,
                                     const std::vector<host::Crossing>& crossings,
                                     const std::vector<OwnedTriangle>& triangles,
                                     const topology::Vec3& direction,
                                     const topology::VirtualFrame& frame) {
    const topology::Vec3 v = frame.to_virtual(direction);
    const topology::Spherical place = topology::to_spherical(v);
    const topology::Angle16 phi = topology::to_angle16(place.phi);
    Words words;
    words.add(kKindFacet);
    words.add(facet);
    words.add(phi);
    words.add(std::min<int>(kMaxTheta, topology::to_angle16(place.theta)));
    words.add(to_s1_14(std::sqrt(v.x * v.x + v.y * v.y)));
    words.add(to_s1_14(v.z));
    words.add(static_cast<std::int64_t>(crossings.size() | triangles.size() << 8));
    words.add(to_s1_14(v.x));
    words.add(to_s1_14(v.y));
    for (const host::Crossing& crossing : crossings) {
        words.add(to_s1_14(crossing.radius));
        const topology::Vec3 normal =
            to_cylinder({crossing.normal.x, crossing.normal.y, crossing.normal.z}, frame, phi);
        words.add(to_s1_14(normal.x));
        words.add(to_s1_14(normal.y));
        words.add(to_s1_14(normal.z));
    }
    for (const OwnedTriangle& t : triangles) {
        words.add(t[1].facet);
        words.add(t[2].facet);
        words.add(t[0].crossing << 3 | t[1].crossing << 6 | t[2].crossing << 9);
    }
    return words.take();
}

}  // namespace rasterloom
