// SPDX-License-Identifier: MIT
// Distances are compared in exact integers: a node's region is then an intersection of half planes
// even where pixels lie exactly between two nodes, hence convex, hence one run of pixels a
// scanline.
#include "topologies/screen_map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::topology {

namespace {

__extension__ using Int128 = __int128;

// A node's place in units of 2^-17 pixels, the unit in which pixel x has its centre at (2 x + 1)
// 2^16.
struct Site {
    std::int64_t x = 0;
    std::int64_t y = 0;
};
constexpr std::int64_t kHalfPixel = 1 << 16;

class NearestSite {
  public:
    NearestSite(const Topology& topology, int width, int height)
        : width_(width), height_(height), side_(bucket_side(topology.nodes.size())) {
        buckets_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
        for (NodeIndex n = 0; n < topology.nodes.size(); ++n) {
            const double u = topology.nodes[n].phi / 360;
            const double v = topology.nodes[n].theta / 180;
            sites_.push_back({std::llround(u * width * (2.0 * kHalfPixel)),
                              std::llround(v * height * (2.0 * kHalfPixel))});
            bucket(cell(u), cell(v)).push_back(n);
        }
    }

    // Searches the buckets in growing squares around the pixel. A node in square r is at least r -
    // 1 buckets away.
    NodeIndex nearest(int x, int y) const {
        Best best;
        const int cx = cell((x + 0.5) / width_);
        const int cy = cell((y + 0.5) / height_);
        for (int r = 0; r < side_ && !(best.found && is_closer_than_square(best, r)); ++r) {
            search_square(cx, cy, r, x, y, best);
        }
        return best.node;
    }

  private:
    struct Best {
        bool found = false;
        NodeIndex node = 0;
        Int128 distance = 0;
    };

    static int bucket_side(std::size_t nodes) {
        return std::max(1, static_cast<int>(std::sqrt(static_cast<double>(nodes))));
    }

    int cell(double u) const { return std::clamp(static_cast<int>(u * side_), 0, side_ - 1); }

    std::vector<NodeIndex>& bucket(int cx, int cy) {
        return buckets_[static_cast<std::size_t>(cy * side_ + cx)];
    }

    // The square of the distance in the unit square, times (width * height * 2^17)^2.
    Int128 distance(NodeIndex n, int x, int y) const {
        const Int128 dx = ((2 * x + 1) * kHalfPixel - sites_[n].x) * height_;
        const Int128 dy = ((2 * y + 1) * kHalfPixel - sites_[n].y) * width_;
        return dx * dx + dy * dy;
    }

    bool is_closer_than_square(const Best& best, int r) const {
        // One pixel of margin covers the rounding of sites and cells.
        const Int128 gap = Int128{r - 1} * width_ * height_ * 2 * kHalfPixel / side_ -
                           Int128{std::max(width_, height_)} * 2 * kHalfPixel;
        return gap > 0 && best.distance < gap * gap;
    }

    void search_square(int cx, int cy, int r, int x, int y, Best& best) const {
        for (int by = std::max(0, cy - r); by <= std::min(side_ - 1, cy + r); ++by) {
            const bool is_edge_row = by == cy - r || by == cy + r;
            const int step = is_edge_row || r == 0 ? 1 : 2 * r;
            for (int bx = cx - r; bx <= cx + r; bx += step) {
                if (bx >= 0 && bx < side_) {
                    search_bucket(bx, by, x, y, best);
                }
            }
        }
    }

    void search_bucket(int bx, int by, int x, int y, Best& best) const {
        for (const NodeIndex n : buckets_[static_cast<std::size_t>(by * side_ + bx)]) {
            const Int128 d = distance(n, x, y);
            if (!best.found || d < best.distance || (d == best.distance && n < best.node)) {
                best = {true, n, d};
            }
        }
    }

    int width_;
    int height_;
    int side_;
    std::vector<Site> sites_;
    std::vector<std::vector<NodeIndex>> buckets_;
};

void add_segments(ScreenMap& map, int y) {
    const NodeIndex* row = map.owner.data() + static_cast<std::ptrdiff_t>(y) * map.width;
    for (int x = 0; x < map.width;) {
        int end = x + 1;
        while (end < map.width && row[end] == row[x]) {
            ++end;
        }
        ScanSegment segment;
        segment.x = static_cast<std::uint16_t>(x);
        segment.y = static_cast<std::uint16_t>(y);
        segment.length = static_cast<std::uint16_t>(end - x);
        if (x > 0) {
            segment.left = row[x - 1];
        }
        if (end < map.width) {
            segment.right = row[end];
        }
        map.segments[row[x]].push_back(segment);
        x = end;
    }
}

}  // namespace

ScreenMap nearest_pixel_map(const Topology& topology, int width, int height) {
    constexpr int kMaxSide = 4096;
    if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide) {
        throw std::invalid_argument(
            fmt::format("screen: {} x {} pixels: expected 1 to {} each", width, height, kMaxSide));
    }
    if (topology.nodes.empty()) {
        throw std::invalid_argument("screen: a topology without nodes cannot own pixels");
    }
    ScreenMap map;
    map.width = width;
    map.height = height;
    map.owner.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    map.segments.resize(topology.nodes.size());
    const NearestSite sites(topology, width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            map.owner.push_back(sites.nearest(x, y));
        }
        add_segments(map, y);
    }
    return map;
}

}  // namespace rasterloom::topology
