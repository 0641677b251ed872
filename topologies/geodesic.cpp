// SPDX-License-Identifier: MIT
// Grid points are found in exact integers. On a face A, B, C with A at the origin of the grid
// (steps 1 and w, w being a turn of 60 degrees), B = b + c w and C = w B, so that the point i + j w
// has the barycentric weights
//     of B: i (b + c) + j c,   of C: j b - i c,   of A: T minus both.
// A point is known by its weights on the icosahedron's corners, whichever face it was reached from.
// A step that leaves the face over one edge is unfolded into the face beyond: A = B + C - D turns
// weights (A, B, C) into (D: -A, B: B + A, C: C + A).
#include "topologies/geodesic.hpp"

#include "topologies/angles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::topology {

namespace {

constexpr int kCorners = 12;

struct Weight {
    int corner = 0;
    std::int64_t amount = 0;
    friend auto operator<=>(const Weight&, const Weight&) = default;
};
using Corners = std::array<Weight, 3>;

struct Icosahedron {
    std::array<Vec3, kCorners> position;
    std::array<std::array<int, 3>, 20> faces;  // counter-clockwise seen from outside
    std::array<std::array<int, kCorners>, kCorners> apex =
        {};  // apex[a][b]: third corner of the face on the left of a -> b
};

Icosahedron icosahedron() {
    Icosahedron ico;
    const double height = 1 / std::sqrt(5.0);
    const double radius = 2 * height;
    ico.position[0] = {0, 0, 1};
    ico.position[11] = {0, 0, -1};
    for (int k = 0; k < 5; ++k) {
        const auto upper = static_cast<std::size_t>(1 + k);
        const auto lower = static_cast<std::size_t>(6 + k);
        ico.position[upper] = {radius * cos_degrees(72 * k), radius * sin_degrees(72 * k), height};
        ico.position[lower] = {radius * cos_degrees(72 * k + 36), radius * sin_degrees(72 * k + 36),
                               -height};
    }
    std::size_t n = 0;
    for (int k = 0; k < 5; ++k) {
        const int up = 1 + k;
        const int up_next = 1 + (k + 1) % 5;
        const int low = 6 + k;
        const int low_next = 6 + (k + 1) % 5;
        ico.faces[n++] = {0, up, up_next};
        ico.faces[n++] = {up, low, up_next};
        ico.faces[n++] = {low, low_next, up_next};
        ico.faces[n++] = {11, low_next, low};
    }
    for (const auto& f : ico.faces) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto from = static_cast<std::size_t>(f[k]);
            const auto to = static_cast<std::size_t>(f[(k + 1) % 3]);
            ico.apex[from][to] = f[(k + 2) % 3];
        }
    }
    return ico;
}

// Sorted by corner, zero weights last with corner kCorners: the same point always gives the same
// key.
Corners canonical(Corners point) {
    for (Weight& w : point) {
        if (w.amount == 0) {
            w.corner = kCorners;
        }
    }
    std::sort(point.begin(), point.end());
    return point;
}

class Grid {
  public:
    Grid(int b, int c)
        : b_(b), c_(c), t_(std::int64_t{b} * b + std::int64_t{b} * c + std::int64_t{c} * c) {
        for (const auto& face : ico_.faces) {
            add_face(face);
        }
    }

    // Nodes without names or port order, in order of discovery.
    Topology topology() const {
        Topology t;
        t.kind = "geodesic";
        t.nodes.resize(index_.size());
        for (const auto& [point, n] : index_) {
            Node& node = t.nodes[n];
            node.direction = on_sphere(point);
            const Spherical s = to_spherical(node.direction);
            node.phi = s.phi;
            node.theta = s.theta;
        }
        t.ports.resize(index_.size());
        for (std::size_t n = 0; n < links_.size(); ++n) {
            t.ports[n].assign(links_[n].begin(), links_[n].end());
        }
        return t;
    }

  private:
    Corners at(const std::array<int, 3>& face, int i, int j) const {
        const std::int64_t second = std::int64_t{i} * (b_ + c_) + std::int64_t{j} * c_;
        const std::int64_t third = std::int64_t{j} * b_ - std::int64_t{i} * c_;
        return {Weight{face[0], t_ - second - third}, Weight{face[1], second},
                Weight{face[2], third}};
    }

    static std::ptrdiff_t negatives(const Corners& p) {
        return std::count_if(p.begin(), p.end(), [](const Weight& w) { return w.amount < 0; });
    }

    // The point on the face beyond the edge over which p, a point with one negative weight, has
    // left its face.
    Corners unfold(Corners p) const {
        while (p[0].amount >= 0) {
            std::rotate(p.begin(), p.begin() + 1, p.end());
        }
        const std::int64_t beyond = p[0].amount;
        p[1].amount += beyond;
        p[2].amount += beyond;
        p[0] = {
            ico_.apex[static_cast<std::size_t>(p[2].corner)][static_cast<std::size_t>(p[1].corner)],
            -beyond};
        return p;
    }

    NodeIndex node_at(const Corners& point) {
        const auto [entry, is_new] =
            index_.try_emplace(canonical(point), static_cast<NodeIndex>(index_.size()));
        if (is_new) {
            links_.emplace_back();
        }
        return entry->second;
    }

    void add_face(const std::array<int, 3>& face) {
        for (int j = 0; j <= b_ + c_; ++j) {
            for (int i = -c_; i <= b_; ++i) {
                const Corners point = at(face, i, j);
                if (negatives(point) == 0) {
                    link_neighbours(face, i, j, node_at(point));
                }
            }
        }
    }

    void link_neighbours(const std::array<int, 3>& face, int i, int j, NodeIndex node) {
        constexpr std::array<std::pair<int, int>, 6> kSteps = {
            {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}};
        const Corners here = at(face, i, j);
        const bool is_corner =
            std::any_of(here.begin(), here.end(), [&](const Weight& w) { return w.amount == t_; });
        for (const auto& [di, dj] : kSteps) {
            Corners there = at(face, i + di, j + dj);
            if (negatives(there) > 0) {
                if (is_corner) {
                    continue;  // a corner's other neighbours are found from its other faces
                }
                there = unfold(there);
            }
            const NodeIndex other = node_at(there);
            links_[node].insert(other);
            links_[other].insert(node);
        }
    }

    Vec3 on_sphere(const Corners& point) const {
        Vec3 sum;
        for (const Weight& w : point) {
            if (w.corner < kCorners) {
                const Vec3& p = ico_.position[static_cast<std::size_t>(w.corner)];
                const double share = static_cast<double>(w.amount) / static_cast<double>(t_);
                sum = {sum.x + share * p.x, sum.y + share * p.y, sum.z + share * p.z};
            }
        }
        return normalized(sum);
    }

    int b_;
    int c_;
    std::int64_t t_;
    Icosahedron ico_ = icosahedron();
    std::map<Corners, NodeIndex> index_;
    std::vector<std::set<NodeIndex>> links_;
};

// Renumbers the nodes by theta, then phi. Angles count as equal to 1e-9 degrees: a circle of
// latitude is not torn by rounding.
void sort_nodes(Topology& t) {
    const auto key = [&](NodeIndex n) {
        return std::pair(std::llround(t.nodes[n].theta * 1e9), std::llround(t.nodes[n].phi * 1e9));
    };
    std::vector<NodeIndex> order(t.nodes.size());
    std::iota(order.begin(), order.end(), NodeIndex{0});
    std::sort(order.begin(), order.end(),
              [&](NodeIndex a, NodeIndex b) { return key(a) < key(b); });
    std::vector<NodeIndex> new_index(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        new_index[order[k]] = static_cast<NodeIndex>(k);
    }
    Topology sorted;
    sorted.kind = t.kind;
    for (const NodeIndex old : order) {
        sorted.nodes.push_back(t.nodes[old]);
        sorted.ports.push_back(t.ports[old]);
        for (NodeIndex& neighbour : sorted.ports.back()) {
            neighbour = new_index[neighbour];
        }
    }
    t = std::move(sorted);
}

// Degrees counter-clockwise from due north, 0 <= bearing < 360, of `to` seen from `from`.
double bearing(const Node& from, const Node& to) {
    constexpr double kRounding = 1e-9;
    const Vec3& p = from.direction;
    const double rho = std::sqrt(p.x * p.x + p.y * p.y);
    const Vec3 west = rho == 0 ? Vec3{0, p.z, 0} : Vec3{p.y / rho, -p.x / rho, 0};
    const Vec3 north = rho == 0 ? Vec3{1, 0, 0} : cross(west, p);
    const double angle = atan2_degrees(dot(to.direction, west), dot(to.direction, north));
    return angle < -kRounding ? angle + 360 : std::max(angle, 0.0);
}

void order_ports(Topology& t) {
    for (std::size_t n = 0; n < t.nodes.size(); ++n) {
        std::vector<std::pair<double, NodeIndex>> around;
        for (const NodeIndex neighbour : t.ports[n]) {
            around.emplace_back(bearing(t.nodes[n], t.nodes[neighbour]), neighbour);
        }
        std::sort(around.begin(), around.end());
        for (std::size_t k = 0; k < around.size(); ++k) {
            t.ports[n][k] = around[k].second;
        }
    }
}

// Each triangle once, from its lowest node.
void find_triangles(Topology& t) {
    for (NodeIndex n = 0; n < t.nodes.size(); ++n) {
        const auto& ports = t.ports[n];
        for (std::size_t k = 0; k < ports.size(); ++k) {
            const NodeIndex second = ports[k];
            const NodeIndex third = ports[(k + 1) % ports.size()];
            if (n < second && n < third) {
                t.triangles.push_back({n, second, third});
            }
        }
    }
}

std::string rounded(double degrees, int period, int decimals) {
    const std::string text = fmt::format("{:.{}f}", degrees, decimals);
    return text == fmt::format("{:.{}f}", static_cast<double>(period), decimals)
               ? fmt::format("{:.{}f}", 0.0, decimals)
               : text;
}

void name_nodes(Topology& t) {
    for (int decimals = 0; decimals <= 9; ++decimals) {
        std::set<std::string> names;
        for (Node& node : t.nodes) {
            node.name =
                fmt::format("P{}-{:.{}f}", rounded(node.phi, 360, decimals), node.theta, decimals);
            names.insert(node.name);
        }
        if (names.size() == t.nodes.size()) {
            return;
        }
    }
    throw std::logic_error("geodesic: two nodes stand at the same place");
}

}  // namespace

Topology geodesic(int b, int c) {
    if (b < 0 || c < 0 || b > kMaxGeodesicStep || c > kMaxGeodesicStep || b + c < 1) {
        throw std::invalid_argument(fmt::format(
            "geodesic: b = {}, c = {}: expected 0 to {} each, not both 0", b, c, kMaxGeodesicStep));
    }
    Topology t = Grid(b, c).topology();
    sort_nodes(t);
    order_ports(t);
    find_triangles(t);
    name_nodes(t);
    return t;
}

}  // namespace rasterloom::topology
