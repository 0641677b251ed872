// SPDX-License-Identifier: MIT
// One processor with the tiler, its frame buffer and appendix C's meter, fed with frames of
// polygons; no machine around it.
#pragma once

#include "isa/core.hpp"
#include "isa/image.hpp"
#include "isa/isa.hpp"
#include "machine/emulation/appendix_c_collector.hpp"
#include "machine/fabric/polygon.hpp"
#include "machine/node/frame_buffer.hpp"
#include "topologies/tiling.hpp"

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

namespace rasterloom::test {

using Frames = std::vector<std::vector<Polygon>>;

class MeteredTiler final : private isa::Bus {
  public:
    // An image of pdp11/tiler.s, made ready.
    struct Program {
        isa::Image image;
        std::shared_ptr<const isa::PreparedProgram> prepared;
    };
    MeteredTiler(const Program& program, const topology::PixelGrid& grid, int width, int height);

    // Draws the frames until the program halts; with the meter or without. Throws
    // std::runtime_error when it traps.
    void draw(const Frames& frames, bool metered = true);

    std::int64_t cycles() const { return cycles_; }
    std::vector<observe::AppendixC> statistics() { return meter_.finish(cycles_); }
    const FrameBuffer& frame_buffer() const { return frame_buffer_; }

  private:
    Read read(std::uint32_t address, int bytes) override;
    Status write(std::uint32_t address, std::uint32_t value, int bytes) override;

    std::unique_ptr<isa::Core> core_;
    FrameBuffer frame_buffer_;
    emulation::TilerTaps taps_;
    emulation::AppendixCMeter meter_;
    std::deque<std::vector<std::uint8_t>> messages_;
    std::size_t frames_left_ = 0;
    std::int64_t cycles_ = 0;
};

}  // namespace rasterloom::test
