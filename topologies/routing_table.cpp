// SPDX-License-Identifier: MIT
// What the host computes for each processor before a run: its place in virtual coordinates, its
// arrival rectangle, and which slopes lead to which port. Only the finished words reach the
// processors.
#include "topologies/angles.hpp"
#include "topologies/routing.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::topology {

namespace {

constexpr int kMaxTheta = 32767;
constexpr double kUnitsPerDegree = 65536.0 / 360;

Vec3 minus(const Vec3& a, const Vec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

Angle16 theta16(double degrees) {
    return static_cast<Angle16>(std::min<int>(kMaxTheta, to_angle16(degrees)));
}

Vec14 fixed14(const Vec3& v) {
    const auto fixed = [](double x) {
        return static_cast<std::int16_t>(std::floor(x * 16384 + 0.5));
    };
    return {fixed(v.x), fixed(v.y), fixed(v.z)};
}

double longitude_difference(double a, double b) {
    return std::remainder(a - b, 360.0);  // exact
}

// Half the extent of a node's region, in degrees.
struct Extent {
    double phi = 0;
    double theta = 0;
};

class TableMaker {
  public:
    TableMaker(const Topology& topology, const Vec3& axis) : topology_(topology) {
        const VirtualFrame frame = virtual_frame(axis);
        table_.axis = frame.z;
        for (const Node& node : topology.nodes) {
            if (dot(node.direction, node.direction) == 0) {
                throw std::invalid_argument(fmt::format(
                    "routing: node {} of a graph of kind '{}' has no position in space; expected a "
                    "topology with positions (geodesic, ring, grid, torus)",
                    node.name, topology.kind));
            }
            place_.push_back(frame.to_virtual(node.direction));
            angle_.push_back(to_spherical(place_.back()));
        }
        table_.nodes.resize(topology.nodes.size());
    }

    RoutingTable make() {
        for (NodeIndex n = 0; n < table_.nodes.size(); ++n) {
            locate(n);
        }
        for (NodeIndex n = 0; n < table_.nodes.size(); ++n) {
            add_sectors(n);
        }
        return std::move(table_);
    }

  private:
    // Corners of the node's region: the points as near to two neighbouring neighbours as to the
    // node itself.
    std::vector<Vec3> region(NodeIndex n) const {
        std::vector<Vec3> corners;
        const auto& ports = topology_.ports[n];
        for (std::size_t k = 0; k < ports.size(); ++k) {
            const Vec3 first = minus(place_[ports[k]], place_[n]);
            const Vec3 second = minus(place_[ports[(k + 1) % ports.size()]], place_[n]);
            corners.push_back(normalized(cross(first, second)));
        }
        return corners;
    }

    // The pole inside the region: +1 north, -1 south, 0 none. On the border it belongs to both
    // regions.
    int enclosed_pole(const std::vector<Vec3>& corners, const Vec3& centre) const {
        constexpr double kRounding = 1e-12;
        const double sign = centre.z > 0 ? 1 : -1;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            if (sign * cross(corners[k], corners[(k + 1) % corners.size()]).z < -kRounding) {
                return 0;
            }
        }
        return centre.z > 0 ? 1 : -1;
    }

    void locate(NodeIndex n) {
        RoutingNode& node = table_.nodes[n];
        node.phi = to_angle16(angle_[n].phi);
        node.theta = theta16(angle_[n].theta);
        node.direction = fixed14(place_[n]);
        for (const NodeIndex m : topology_.ports[n]) {
            node.neighbours.push_back(fixed14(place_[m]));
        }
        Extent extent;
        double centre = angle_[n].theta;
        if (topology_.triangles.empty()) {
            extent = extent_by_neighbours(n);
        } else {
            const std::vector<Vec3> corners = region(n);
            const int pole = enclosed_pole(corners, place_[n]);
            node.is_polar = pole != 0;
            centre = pole == 0 ? centre : (pole > 0 ? 0 : 180);
            extent = extent_of(corners, angle_[n].phi, centre);
        }
        node.centre_theta = theta16(centre);
        node.half_phi = node.is_polar ? Angle16{32768} : half_width(extent.phi);
        node.half_theta = half_width(extent.theta);
    }

    static Angle16 half_width(double degrees) {
        return static_cast<Angle16>(std::clamp(std::ceil(degrees * kUnitsPerDegree), 2.0, 32768.0));
    }

    static Extent extent_of(const std::vector<Vec3>& corners, double phi, double theta) {
        Extent extent;
        for (const Vec3& corner : corners) {
            const Spherical s = to_spherical(corner);
            extent.phi = std::max(extent.phi, std::fabs(longitude_difference(s.phi, phi)));
            extent.theta = std::max(extent.theta, std::fabs(s.theta - theta));
        }
        return extent;
    }

    // Where the graph does not triangulate the sphere: halfway to the farthest neighbour,
    // everything where all stand in line.
    Extent extent_by_neighbours(NodeIndex n) const {
        Extent extent;
        for (const NodeIndex m : topology_.ports[n]) {
            const double dphi = std::fabs(longitude_difference(angle_[m].phi, angle_[n].phi));
            extent.phi = std::max(extent.phi, dphi / 2);
            extent.theta = std::max(extent.theta, std::fabs(angle_[m].theta - angle_[n].theta) / 2);
        }
        constexpr double kInLine = 1e-9;
        return {extent.phi > kInLine ? extent.phi : 180,
                extent.theta > kInLine ? extent.theta : 180};
    }

    // A port's direction in the plane of the true angles (degrees, 0 to 360), where slopes can be
    // halved fairly: phi is shortened by `shrink`, the sine of theta, as it is on the sphere. At a
    // polar node only the longitude counts.
    double bearing(NodeIndex n, NodeIndex m, double shrink) const {
        const double dphi = longitude_difference(angle_[m].phi, angle_[n].phi);
        const RoutingNode& here = table_.nodes[n];
        const RoutingNode& there = table_.nodes[m];
        double angle = dphi;
        if (!here.is_polar) {
            // A polar neighbour stands at the pole, hence due north or south.
            const double dtheta = there.is_polar
                                      ? (there.centre_theta == 0 ? 0 : 180) - angle_[n].theta
                                      : angle_[m].theta - angle_[n].theta;
            angle = atan2_degrees(dtheta, there.is_polar ? 0 : dphi * shrink);
        }
        return angle < 0 ? angle + 360 : angle;
    }

    Angle16 slope_of_bearing(const RoutingNode& node, double bearing, double shrink) const {
        if (node.is_polar) {
            return to_angle16(bearing);
        }
        const double x = cos_degrees(bearing) / shrink;
        const double y = sin_degrees(bearing);
        const double scale = 32000 / (std::fabs(x) + std::fabs(y));
        return slope(static_cast<std::int16_t>(std::floor(x * scale + 0.5)),
                     static_cast<std::int16_t>(std::floor(y * scale + 0.5)));
    }

    void add_sectors(NodeIndex n) {
        RoutingNode& node = table_.nodes[n];
        const auto& ports = topology_.ports[n];
        if (ports.size() > 255) {
            throw std::invalid_argument(
                fmt::format("routing: node {} has {} ports; expected at most 255",
                            topology_.nodes[n].name, ports.size()));
        }
        const double shrink = std::max(0.001, sin_degrees(angle_[n].theta));
        std::vector<std::pair<double, std::uint8_t>> around;
        for (std::size_t k = 0; k < ports.size(); ++k) {
            around.emplace_back(bearing(n, ports[k], shrink), static_cast<std::uint8_t>(k));
        }
        std::sort(around.begin(), around.end());
        for (std::size_t k = 0; k < around.size(); ++k) {
            const bool is_last = k + 1 == around.size();
            const double next = is_last ? around[0].first + 360 : around[k + 1].first;
            const double middle = (around[k].first + next) / 2;
            node.sectors.push_back({slope_of_bearing(node, middle, shrink), around[k].second});
        }
        std::stable_sort(
            node.sectors.begin(), node.sectors.end(),
            [](const SlopeSector& a, const SlopeSector& b) { return a.limit < b.limit; });
        if (!node.sectors.empty() && node.sectors.back().limit != 65535) {
            node.sectors.push_back({65535, node.sectors.front().port});
        }
    }

    const Topology& topology_;
    std::vector<Vec3> place_;  // in virtual coordinates
    std::vector<Spherical> angle_;
    RoutingTable table_;
};

}  // namespace

Vec3 VirtualFrame::to_virtual(const Vec3& world) const {
    return {dot(world, x), dot(world, y), dot(world, z)};
}

Vec3 VirtualFrame::to_world(const Vec3& local) const {
    return {x.x * local.x + y.x * local.y + z.x * local.z,
            x.y * local.x + y.y * local.y + z.y * local.z,
            x.z * local.x + y.z * local.y + z.z * local.z};
}

VirtualFrame virtual_frame(const Vec3& axis) {
    const Vec3 z = normalized(axis);
    const Vec3 reference = std::fabs(z.x) > 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
    const double along = dot(reference, z);
    const Vec3 x = normalized(minus(reference, {along * z.x, along * z.y, along * z.z}));
    return {x, cross(z, x), z};
}

RoutingTable make_routing_table(const Topology& topology, const Vec3& axis) {
    return TableMaker(topology, axis).make();
}

}  // namespace rasterloom::topology
