// SPDX-License-Identifier: MIT
#include "topologies/tiling.hpp"

#include <algorithm>
#include <deque>
#include <vector>

#include <fmt/format.h>

namespace rasterloom::topology {

namespace {

// Parts column to column + columns - 1, likewise rows: what one splitter of the tree cuts.
struct Block {
    int column = 0;
    int row = 0;
    int columns = 1;
    int rows = 1;
    CutAxis next = CutAxis::x;

    bool is_part() const { return columns == 1 && rows == 1; }
    CutAxis axis() const {
        const bool can_x = columns > 1;
        const bool can_y = rows > 1;
        return next == CutAxis::x ? (can_x ? CutAxis::x : CutAxis::y)
                                  : (can_y ? CutAxis::y : CutAxis::x);
    }
};

std::vector<int> divisors(int size) {
    std::vector<int> found;
    for (int n = 1; n <= size; ++n) {
        if (size % n == 0) {
            found.push_back(n);
        }
    }
    return found;
}

void check_share(CutAxis axis, int size, int parts, int interlaced) {
    if (size >= 1 && size % (parts * interlaced) == 0) {
        return;
    }
    const bool is_x = axis == CutAxis::x;
    throw TilingError(
        axis,
        fmt::format("{} {} of processors{} cannot share the screen's {} of {} pixels evenly; "
                    "one of {} can",
                    parts * interlaced, is_x ? "columns" : "rows",
                    parts > 1 && interlaced > 1 ? fmt::format(" ({} x {})", parts, interlaced) : "",
                    is_x ? "width" : "height", size, fmt::join(divisors(size), ", ")));
}

std::vector<PixelGrid> make_grids(const Tiling& t, int width, int height) {
    const int part_width = width / t.columns;
    const int part_height = height / t.rows;
    std::vector<PixelGrid> grids;
    for (int part = 0; part < t.parts(); ++part) {
        const int x = part % t.columns * part_width;
        const int y = part / t.columns * part_height;
        for (int k = 0; k < t.interlaced(); ++k) {
            grids.push_back({x + k % t.interlace_columns, y + k / t.interlace_columns,
                             t.interlace_columns, t.interlace_rows,
                             part_width / t.interlace_columns, part_height / t.interlace_rows});
        }
    }
    return grids;
}

class TreeBuilder {
  public:
    TreeBuilder(const Tiling& tiling, int width, int height)
        : tiling_(tiling),
          part_width_(width / tiling.columns),
          part_height_(height / tiling.rows) {}

    // A tree of n parts has n - 1 splitters, so the parts' elements can be numbered beforehand.
    std::vector<Distribution::Element> build() {
        waiting_.push_back({0, 0, tiling_.columns, tiling_.rows, CutAxis::x});
        next_splitter_ = 1;  // the root is 0
        while (!waiting_.empty()) {
            const Block block = waiting_.front();
            waiting_.pop_front();
            if (!block.is_part()) {
                cut(block);
            }
        }
        add_parts();
        return std::move(elements_);
    }

  private:
    void cut(const Block& block) {
        const CutAxis axis = block.axis();
        const bool is_x = axis == CutAxis::x;
        Block low = block;
        Block high = block;
        low.next = high.next = is_x ? CutAxis::y : CutAxis::x;
        Distribution::Cut what{axis, 0, 0, 0};
        if (is_x) {
            low.columns = block.columns / 2;
            high.columns -= low.columns;
            high.column += low.columns;
            what.line = high.column * part_width_;
        } else {
            low.rows = block.rows / 2;
            high.rows -= low.rows;
            high.row += low.rows;
            what.line = high.row * part_height_;
        }
        what.low = element_of(low);
        what.high = element_of(high);
        elements_.push_back({fmt::format("splitter/{}", elements_.size()), what});
    }

    std::size_t element_of(const Block& block) {
        waiting_.push_back(block);
        if (!block.is_part()) {
            return next_splitter_++;
        }
        return splitters() + static_cast<std::size_t>(block.row * tiling_.columns + block.column);
    }

    std::size_t splitters() const { return static_cast<std::size_t>(tiling_.parts() - 1); }

    void add_parts() {
        const auto share = static_cast<NodeIndex>(tiling_.interlaced());
        for (NodeIndex part = 0; part < static_cast<NodeIndex>(tiling_.parts()); ++part) {
            if (share == 1) {
                elements_.push_back({fmt::format("node/P{}", part), Distribution::Leaf{part}});
                continue;
            }
            Distribution::Broadcast listeners;
            for (NodeIndex k = 0; k < share; ++k) {
                listeners.processors.push_back(part * share + k);
            }
            elements_.push_back({fmt::format("bus/{}", part), listeners});
        }
    }

    const Tiling& tiling_;
    int part_width_;
    int part_height_;
    std::deque<Block> waiting_;  // breadth first: a level after the other
    std::size_t next_splitter_ = 0;
    std::vector<Distribution::Element> elements_;
};

int depth_below(const Distribution& distribution, std::size_t element) {
    const auto* cut = std::get_if<Distribution::Cut>(&distribution.elements[element].what);
    return cut == nullptr ? 0
                          : 1 + std::max(depth_below(distribution, cut->low),
                                         depth_below(distribution, cut->high));
}

}  // namespace

void check_tiling(const Tiling& tiling) {
    const auto check = [](int value, const char* name) {
        if (value < 1 || value > kMaxTilingSide) {
            throw std::invalid_argument(
                fmt::format("{} = {}: expected 1 to {}", name, value, kMaxTilingSide));
        }
    };
    check(tiling.columns, "columns");
    check(tiling.rows, "rows");
    check(tiling.interlace_columns, "interlace_columns");
    check(tiling.interlace_rows, "interlace_rows");
    const std::int64_t all = std::int64_t{tiling.columns} * tiling.rows * tiling.interlace_columns *
                             tiling.interlace_rows;
    if (all > kMaxTilingProcessors) {
        throw std::invalid_argument(
            fmt::format("{} processors: expected at most {}", all, kMaxTilingProcessors));
    }
}

Distribution distribute(const Tiling& tiling, int width, int height) {
    check_tiling(tiling);
    check_share(CutAxis::x, width, tiling.columns, tiling.interlace_columns);
    check_share(CutAxis::y, height, tiling.rows, tiling.interlace_rows);
    return {width, height, make_grids(tiling, width, height),
            TreeBuilder(tiling, width, height).build()};
}

int tree_depth(const Distribution& distribution) {
    return distribution.elements.empty() ? 0 : depth_below(distribution, 0);
}

}  // namespace rasterloom::topology
