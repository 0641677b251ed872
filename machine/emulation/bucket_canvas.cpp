// SPDX-License-Identifier: MIT
#include "machine/emulation/bucket_canvas.hpp"

#include "machine/emulation/node_memory.hpp"

#include <algorithm>
#include <span>

namespace rasterloom::emulation {

HardwareCanvas::HardwareCanvas(const TriangleFrames& scene, const topology::BucketTiles& tiles,
                               const host::TileTexture* texture)
    : scene_(scene),
      tiles_(tiles),
      texture_(texture),
      canvas_(tiles.screen_width(), tiles.screen_height(), scene.background) {
    make_ready();
}

void HardwareCanvas::make_ready() {
    triangles_.clear();
    for (const host::ScreenTriangle& triangle : scene_.frames[frame_]) {
        std::optional<host::ReadyTriangle>& ready = triangles_.emplace_back();
        if (visible_box(triangle, canvas_.width(), canvas_.height())) {
            ready.emplace(triangle);
        }
    }
}

void HardwareCanvas::pair_drawn(const DrawnPair& pair) {
    if (pair.work.pixels > 0) {
        host::draw_triangle(*triangles_[pair.work.triangle], tiles_.box_of(pair.work.tile), canvas_,
                            texture_);
    }
}

void HardwareCanvas::begin_next_frame() {
    canvas_.clear();
    frame_ = (frame_ + 1) % scene_.frames.size();
    make_ready();
}

SoftwareCanvas::SoftwareCanvas(const isa::Image& image, int width, int height, int background)
    : words_{require_symbol(image, "tile_left"), require_symbol(image, "tile_top"),
             require_symbol(image, "tile_right"), require_symbol(image, "tile_bottom")},
      background_(static_cast<std::uint8_t>(background)),
      picture_(width, height) {
    clear();
}

void SoftwareCanvas::clear() {
    std::fill(picture_.pixels.begin(), picture_.pixels.end(), background_);
}

void SoftwareCanvas::frame_buffer_cleared(NodeIndex /*node*/, const isa::Core& core,
                                          const FrameBuffer& frame_buffer) {
    const auto word = [&](std::size_t which) {
        return static_cast<std::int16_t>(word_at(core.memory(), words_[which]));
    };
    const int left = word(0), top = word(1), right = word(2), bottom = word(3);
    for (int y = top; y <= bottom && left <= right; ++y) {
        for (int x = left; x <= right; ++x) {
            picture_.at(x, y) = host::grey_of(frame_buffer.image(y - top, x - left));
        }
    }
}

}  // namespace rasterloom::emulation
