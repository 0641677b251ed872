// SPDX-License-Identifier: MIT
// One processor with the bucket renderer, its frame buffer and appendix C's meter, fed with tiles
// of triangles; no machine around it.
#pragma once

#include "isa/core.hpp"
#include "isa/image.hpp"
#include "machine/emulation/appendix_c_collector.hpp"
#include "machine/host/tile_renderer.hpp"
#include "machine/node/frame_buffer.hpp"

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

namespace rasterloom::test {

const isa::Image& bucket_image(bool textured);

struct TileLoad {
    host::PixelBox tile;
    std::vector<host::ScreenTriangle> triangles;
};

// What the processor has handed over, pixel by pixel of the screen.
struct HandedOver {
    HandedOver(int width, int height, int background);

    int width;
    std::vector<std::int16_t> depth, image;
    int tiles = 0;
};

class BucketNode final : private isa::Bus {
  public:
    // Tiles of at most columns x rows pixels. `texture`: null for the program without.
    BucketNode(int columns, int rows, int background, const host::TileTexture* texture);

    // Draws the frames, each a list of tiles, until the program halts. Throws std::runtime_error
    // when it traps, or hands over what is no tile of the buffer's size.
    void draw(const std::vector<std::vector<TileLoad>>& frames, HandedOver& screen);

    std::int64_t cycles() const { return cycles_; }
    std::vector<observe::AppendixC> statistics() { return meter_.finish(cycles_); }

  private:
    Read read(std::uint32_t address, int bytes) override;
    Status write(std::uint32_t address, std::uint32_t value, int bytes) override;
    void hand_over();
    int word(const char* symbol) const;

    const isa::Image* program_;
    std::unique_ptr<isa::Core> core_;
    FrameBuffer frame_buffer_;
    emulation::TilerTaps taps_;
    emulation::AppendixCMeter meter_;
    std::deque<std::vector<std::uint8_t>> messages_;
    HandedOver* screen_ = nullptr;
    std::size_t frames_left_ = 0;
    std::int64_t cycles_ = 0;
};

}  // namespace rasterloom::test
