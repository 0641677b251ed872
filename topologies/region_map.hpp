// SPDX-License-Identifier: MIT
// Who draws which pixels, in rectangles (Eldridge 1995, appendix A.1.1): the screen is divided into
// regions, and region r is processor r's, or in sort-twice that of each processor r + kg. As a file
// (*.map), one rectangle a line, a region's as often as it has some:
//
//     0  (0,0)    (383,255)      region, leftmost upper and rightmost lower pixel
//     1  (0,256)  (383,511)
//     2  (384,0)  (767,511)
//
// Blank lines and comments ('#') count for nothing. Every pixel is in exactly one rectangle.
#pragma once

#include "topologies/pixel_box.hpp"

#include <cstdint>
#include <istream>
#include <span>
#include <string>
#include <vector>

namespace rasterloom::topology {

using RegionIndex = std::uint32_t;

// Regions first to last, both included.
struct RegionRange {
    RegionIndex first = 0;
    RegionIndex last = 0;

    friend bool operator==(const RegionRange&, const RegionRange&) = default;
};

class RegionMap {
  public:
    struct Share {
        RegionIndex region = 0;
        PixelBox box;
        std::size_t line = 0;  // of the file
    };

    // `name` stands for the file in messages. Throws TextFileError (text_line.hpp) with the line of
    // a rectangle that reaches beyond the screen or has a pixel that another one has, and with the
    // first pixel, line by line from the top, that is in none; std::invalid_argument for a screen
    // that is not 1 to 4096 pixels each way, and for a region beyond the `regions` that there are.
    RegionMap(const std::string& name, int width, int height, RegionIndex regions,
              std::span<const Share> shares);

    int width() const { return width_; }
    int height() const { return height_; }
    RegionIndex regions() const { return static_cast<RegionIndex>(rectangles_.size()); }

    RegionIndex region_at(int x, int y) const;  // of a pixel on the screen
    // In the order of the file; none of a region without pixels.
    const std::vector<PixelBox>& rectangles_of(RegionIndex region) const {
        return rectangles_[region];
    }

    // The regions that have a pixel of this box: ascending, no two ranges touching.
    std::vector<RegionRange> regions_in(const PixelBox& box) const;
    // How many pixels of the box are the region's.
    std::int64_t pixels_in(const PixelBox& box, RegionIndex region) const;

  private:
    // Adjacent lines of pixels that look alike.
    struct Band {
        std::vector<RegionIndex> region;     // of each column
        std::vector<std::uint16_t> run_end;  // of each column: the next one of another region
    };

    void add_row(std::vector<RegionIndex> row);

    int width_;
    int height_;
    std::vector<Band> bands_;
    std::vector<std::uint16_t> band_of_row_;
    std::vector<std::vector<PixelBox>> rectangles_;  // of each region
};

// Upright strips from left to right, one a region, as even as whole columns allow; with as many
// regions as columns or more, region i is column i, and those beyond the width have none.
RegionMap column_map(int width, int height, RegionIndex regions);

// Throw TextFileError for a malformed file, too.
RegionMap read_region_map(std::istream& in, const std::string& name, int width, int height,
                          RegionIndex regions);
RegionMap region_map_file(const std::string& path, int width, int height, RegionIndex regions);

std::string region_map_as_text(const RegionMap& map);

}  // namespace rasterloom::topology
