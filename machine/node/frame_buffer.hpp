// SPDX-License-Identifier: MIT
// A processor's frame buffer (programs/README.md, "The frame buffer"): a grid of pixels, each with
// a depth and an image word, of which one row at a time stands in windows of the core's memory.
//
//     depth words    kDepthWindow + 2 x column      in memory
//     image words    kImageWindow + 2 x column      in memory, or
//                    kBusImageWindow + 2 x column   in the I/O page, over the frame-buffer bus
//
// The rows rest here as the bytes they have in memory, low byte first, so that selecting another
// one is a copy each way. At first every depth is kFarthestDepth, every image word 0, and no row is
// selected.
#pragma once

#include "isa/core.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rasterloom {

inline constexpr std::uint32_t kDepthWindow = 0150000;
inline constexpr std::uint32_t kImageWindow = 0154000;
inline constexpr std::uint32_t kBusImageWindow = 0170000;
inline constexpr int kMaxFrameBufferColumns = 1024;      // a window's words
inline constexpr std::uint16_t kFarthestDepth = 077777;  // of a pixel that has been cleared

class FrameBuffer {
  public:
    struct Settings {
        int rows = 0;           // 1 to 65536, what FBROW can name
        int columns = 0;        // 1 to kMaxFrameBufferColumns
        bool over_bus = false;  // the image window stands in the I/O page
    };

    // The windows lie in the memory of `core`, which must outlive the frame buffer. Throws
    // std::invalid_argument when a number is out of range or the memory ends before the windows do.
    FrameBuffer(isa::Core& core, const Settings& settings);

    int rows() const { return settings_.rows; }
    int columns() const { return settings_.columns; }
    bool over_bus() const { return settings_.over_bus; }

    // Puts row `row`, 0 to rows - 1, into the windows; what stood there is kept.
    void select(int row);
    std::optional<int> selected() const { return selected_; }
    // Every depth becomes kFarthestDepth and every image word `image`, in the windows, too.
    void clear(std::uint16_t image);
    // Writes an image word of the selected row, which must be there; for a buffer over the bus.
    void write_image(int column, std::uint16_t value);

    // As they are now, whether in a window or not; 0 <= row < rows, 0 <= column < columns.
    std::int16_t depth(int row, int column) const;
    std::int16_t image(int row, int column) const;
    // A row's image words as bytes, low byte first; valid until the core runs or a row is selected.
    std::span<const std::uint8_t> image_row(int row) const;

  private:
    std::size_t row_bytes() const { return 2 * static_cast<std::size_t>(settings_.columns); }
    std::size_t offset(int row) const { return static_cast<std::size_t>(row) * row_bytes(); }
    void keep_selected();
    void show_selected();

    isa::Core* core_;
    Settings settings_;
    std::optional<int> selected_;
    std::vector<std::uint8_t> depth_;  // [row][column][byte]
    std::vector<std::uint8_t> image_;  // likewise
};

}  // namespace rasterloom
