// SPDX-License-Identifier: MIT
// Parks' machines as ways to deal a screen out to processors: contiguous parts behind a binary tree
// of splitters (Parke), every n-th pixel behind a bus (Fuchs), or a tree whose leaves are such
// buses (Parke's hybrid). All of them are one family: `columns` x `rows` parts, each shared out
// pixel by pixel among `interlace_columns` x `interlace_rows` processors (Parks 1982, chapter 3
// and 4.6).
#pragma once

#include "topologies/node_index.hpp"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace rasterloom::topology {

struct Tiling {
    int columns = 1;            // parts side by side; at least 1
    int rows = 1;               // parts one above the other
    int interlace_columns = 1;  // processors that share a part's lines
    int interlace_rows = 1;     // and its columns

    int parts() const { return columns * rows; }
    int interlaced() const { return interlace_columns * interlace_rows; }
    int processors() const { return parts() * interlaced(); }
};

// The pixels of one processor: (x_start + i * x_step, y_start + j * y_step), 0 <= i < columns,
// 0 <= j < rows; y counts upwards.
struct PixelGrid {
    int x_start = 0;
    int y_start = 0;
    int x_step = 1;
    int y_step = 1;
    int columns = 0;
    int rows = 0;
};

enum class CutAxis : std::uint8_t { x, y };

// How polygons reach the processors. Element 0 takes what the host sends.
struct Distribution {
    // Coordinates below `line` go to element `low`, the others to `high`.
    struct Cut {
        CutAxis axis = CutAxis::x;
        int line = 0;
        std::size_t low = 0;
        std::size_t high = 0;
    };
    // Every polygon goes to all of them; they have no elements of their own.
    struct Broadcast {
        std::vector<NodeIndex> processors;
    };
    struct Leaf {
        NodeIndex processor = 0;
    };
    struct Element {
        std::string name;  // "splitter/0", "bus/3", "node/P7": unique, and in a stable order
        std::variant<Cut, Broadcast, Leaf> what;
    };

    int width = 0;
    int height = 0;
    std::vector<PixelGrid> grids;  // [processor]
    std::vector<Element> elements;
};

inline constexpr int kMaxTilingSide = 4096;         // of any of a tiling's four numbers
inline constexpr int kMaxTilingProcessors = 65536;  // what a node's 16-bit number can name

// A screen that cannot be dealt out evenly along one axis.
class TilingError : public std::invalid_argument {
  public:
    TilingError(CutAxis axis, const std::string& message)
        : std::invalid_argument(message), axis_(axis) {}
    CutAxis axis() const { return axis_; }

  private:
    CutAxis axis_;
};

// Processors are numbered part by part, the parts from left to right and then upwards (Parks'
// figure 7), within a part likewise (figure 11): part * interlaced() + (x mod interlace_columns) +
// interlace_columns * (y mod interlace_rows). The tree halves the parts, along x first and then by
// turns, where there is something to halve; an odd number of parts gives the lower side one less.
// Elements: the splitters level by level, splitter/0 first, then the parts: bus/<part> where
// several processors share one, else the processor's leaf. Throws std::invalid_argument when a
// number is out of range, TilingError, saying what was expected, when the screen cannot be dealt
// out evenly.
Distribution distribute(const Tiling& tiling, int width, int height);

// Throws std::invalid_argument when one of the numbers is below 1 or above kMaxTilingSide, or the
// processors are more than kMaxTilingProcessors.
void check_tiling(const Tiling& tiling);

// Splitters on the way from the host to the deepest part; 0 without any.
int tree_depth(const Distribution& distribution);

}  // namespace rasterloom::topology
