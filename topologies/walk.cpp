// SPDX-License-Identifier: MIT
#include "topologies/walk.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::topology {

namespace {

// Shortest paths from one node to all nodes within kMaxPathHops; of equally short ones the lowest
// ports from the start on.
std::map<NodeIndex, Path> paths_from(const Topology& topology, NodeIndex start) {
    std::map<NodeIndex, Path> paths{{start, kEmptyPath}};
    std::vector<NodeIndex> frontier{start};
    for (int hop = 0; hop < kMaxPathHops; ++hop) {
        std::vector<NodeIndex> next;
        for (const NodeIndex n : frontier) {
            const unsigned so_far = paths.at(n);
            for (unsigned port = 0; port < topology.ports[n].size(); ++port) {
                const unsigned shift = 3U * static_cast<unsigned>(hop);
                const auto path = static_cast<Path>(so_far & ~((7U ^ port) << shift));
                if (paths.try_emplace(topology.ports[n][port], path).second) {
                    next.push_back(topology.ports[n][port]);
                }
            }
        }
        frontier = std::move(next);
    }
    return paths;
}

class WalkMaker {
  public:
    WalkMaker(const Topology& topology, const ScreenMap& map) : topology_(topology), map_(map) {}

    WalkNode node(NodeIndex n) const {
        if (topology_.ports[n].size() > 7) {
            throw std::invalid_argument(
                fmt::format("walk table: node {} has {} ports; expected at most 7",
                            topology_.nodes[n].name, topology_.ports[n].size()));
        }
        const auto paths = paths_from(topology_, n);
        const auto link = [&](int x, int y) { return path_to(paths, n, x, y); };
        WalkNode node;
        const auto& segments = map_.segments[n];
        if (segments.empty()) {
            node.home = link(pixel(topology_.nodes[n].phi / 360, map_.width),
                             pixel(topology_.nodes[n].theta / 180, map_.height));
        } else if (segments.front().y > 0) {
            node.up =
                link(segments.front().x + segments.front().length / 2, segments.front().y - 1);
        }
        for (std::size_t k = 0; k < segments.size(); ++k) {
            const ScanSegment& s = segments[k];
            WalkSegment& w = node.segments.emplace_back();
            w.x = s.x;
            w.y = s.y;
            w.length = s.length;
            w.left = link(s.x > 0 ? s.x - 1 : map_.width - 1, s.y);
            w.right = link((s.x + s.length) % map_.width, s.y);
            const bool owns_next_row = k + 1 < segments.size() && segments[k + 1].y == s.y + 1;
            if (!owns_next_row && s.y + 1 < map_.height) {
                w.down = link(s.x + s.length / 2, s.y + 1);
            }
        }
        return node;
    }

  private:
    static int pixel(double u, int size) {
        return std::clamp(static_cast<int>(u * size), 0, size - 1);
    }

    Path path_to(const std::map<NodeIndex, Path>& paths, NodeIndex from, int x, int y) const {
        const NodeIndex owner =
            map_.owner[static_cast<std::size_t>(y) * static_cast<std::size_t>(map_.width) +
                       static_cast<std::size_t>(x)];
        const auto found = paths.find(owner);
        if (found == paths.end()) {
            throw std::invalid_argument(fmt::format(
                "walk table: from node {} to node {}, which owns pixel ({}, {}) beside it, the "
                "graph "
                "has more than {} hops",
                topology_.nodes[from].name, topology_.nodes[owner].name, x, y, kMaxPathHops));
        }
        return found->second;
    }

    const Topology& topology_;
    const ScreenMap& map_;
};

}  // namespace

WalkTable make_walk_table(const Topology& topology, const ScreenMap& map) {
    const WalkMaker maker(topology, map);
    WalkTable table{map.width, map.height, {}};
    for (NodeIndex n = 0; n < topology.nodes.size(); ++n) {
        table.nodes.push_back(maker.node(n));
    }
    return table;
}

std::optional<Path> walk_path(const WalkNode& node, int width, int x, int y) {
    if (node.segments.empty()) {
        return node.home;
    }
    const WalkSegment* above = nullptr;
    for (const WalkSegment& s : node.segments) {
        if (s.y == y) {
            const int r = x >= s.x ? x - s.x : x - s.x + width;
            if (r < s.length) {
                return std::nullopt;
            }
            return 2 * r < width ? s.right : s.left;
        }
        if (s.y > y) {
            break;
        }
        above = &s;
    }
    return above != nullptr ? above->down : node.up;
}

Angle16 pixel_phi(int x, int width) {
    return static_cast<Angle16>(((2 * x + 1) * 65536) / (2 * width));
}

Angle16 pixel_theta(int y, int height) {
    return static_cast<Angle16>(((2 * y + 1) * 32768) / (2 * height));
}

}  // namespace rasterloom::topology
