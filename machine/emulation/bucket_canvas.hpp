// SPDX-License-Identifier: MIT
// Where a bucket tiler's picture comes together: what its rasterizers draw, tile by tile. Tiles do
// not share pixels, so rasterizers may draw at once, on several threads.
#pragma once

#include "isa/image.hpp"
#include "machine/emulation/triangle_frames.hpp"
#include "machine/fabric/rasterizer.hpp"
#include "machine/host/picture.hpp"
#include "machine/host/tile_renderer.hpp"
#include "machine/node/processor.hpp"
#include "topologies/bucket_tiles.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace rasterloom::emulation {

// Draws every pair as the pixel rule says (machine/host/tile_renderer.hpp): what hardware would.
class HardwareCanvas final : public RasterizerListener {
  public:
    // All must outlive this. `texture`: null for none.
    HardwareCanvas(const TriangleFrames& scene, const topology::BucketTiles& tiles,
                   const host::TileTexture* texture);

    void pair_drawn(const DrawnPair& pair) override;
    const host::TileCanvas& canvas() const { return canvas_; }
    // Between frames: clears the canvas for the next one.
    void begin_next_frame();

  private:
    void make_ready();

    const TriangleFrames& scene_;
    const topology::BucketTiles& tiles_;
    const host::TileTexture* texture_;
    host::TileCanvas canvas_;
    std::size_t frame_ = 0;
    std::vector<std::optional<host::ReadyTriangle>> triangles_;  // of the frame, the visible ones
};

// Puts each tile that a program hands over in its place on the screen. A program hands over its
// frame buffer when it writes FBCLEAR; which tile it is, say its words tile_left, tile_top,
// tile_right and tile_bottom (pixels, both ends included), and that it is none, tile_right below
// tile_left.
class SoftwareCanvas final : public FrameBufferListener {
  public:
    // Throws std::invalid_argument when the image lacks one of the words.
    SoftwareCanvas(const isa::Image& image, int width, int height, int background);

    void frame_buffer_cleared(NodeIndex node, const isa::Core& core,
                              const FrameBuffer& frame_buffer) override;
    const host::Picture& picture() const { return picture_; }
    void clear();

  private:
    std::array<std::uint32_t, 4> words_{};  // addresses
    std::uint8_t background_;
    host::Picture picture_;
};

}  // namespace rasterloom::emulation
