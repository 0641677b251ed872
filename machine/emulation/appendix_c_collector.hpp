// SPDX-License-Identifier: MIT
// Takes the statistics of Parks' appendix C from a run: at every tap of the tiler it books the
// cycles since the last one to the section that was in progress, and looks at what comes next.
//
// From tap_idle on cycles belong to the polygon that comes, to be drawn or to be digested, or to
// nobody when the next tap is tap_idle again: then the frame has ended. A pixel that is drawn
// changes its depth word, so that comparing the row before and after tells drawn pixels from hidden
// ones.
#pragma once

#include "isa/image.hpp"
#include "machine/emulation/tiler_taps.hpp"
#include "machine/node/frame_buffer.hpp"
#include "machine/node/node_listener.hpp"
#include "machine/node/processor.hpp"
#include "machine/observe/appendix_c/appendix_c.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rasterloom::emulation {

// One processor's. Touches nothing of others, so that it may be told from any thread.
class AppendixCMeter final : public NodeListener {
  public:
    // Both must outlive the meter.
    AppendixCMeter(const TilerTaps& taps, const FrameBuffer& frame_buffer);

    void tapped(const Tap& tap) override;
    // The frames so far, the one in progress included; `cycles` have been executed in all.
    std::vector<observe::AppendixC> finish(std::int64_t cycles);

  private:
    void book(std::int64_t cycles, observe::Section section);
    void begin_run(const isa::Core& core);
    void end_run(const isa::Core& core, std::int64_t cycles);
    void end_segment();
    void end_polygon();
    void end_frame();
    std::uint16_t depth_word(const isa::Core& core, int column) const;

    const TilerTaps* taps_;
    const FrameBuffer* frame_buffer_;
    std::vector<observe::AppendixC> frames_;
    observe::AppendixC frame_;
    std::optional<TilerTap> last_;
    std::int64_t booked_until_ = 0;
    bool polygon_open_ = false;
    bool segment_open_ = false;
    std::int64_t height_ = 0;  // of the polygon in progress, so far
    std::int64_t area_ = 0;
    TilerTaps::Run run_;                     // of the segment in progress; no pixels at first
    std::vector<std::uint16_t> depth_;       // of the run's pixels before it
    std::vector<std::uint32_t> complexity_;  // [row][column]: polygons on the pixel
};

class AppendixCCollector {
  public:
    // Taps the processors' cores and listens to them; they must outlive the collector. Throws
    // std::invalid_argument when the program has no taps or a processor no frame buffer.
    AppendixCCollector(const isa::Image& image, const std::vector<Processor*>& processors);
    AppendixCCollector(const AppendixCCollector&) = delete;
    AppendixCCollector& operator=(const AppendixCCollector&) = delete;

    // To be called once, after the run. `names` by node.
    observe::AppendixCReport finish(const std::string& machine,
                                    const std::vector<std::string>& names);

  private:
    TilerTaps taps_;
    std::vector<Processor*> processors_;
    std::vector<std::unique_ptr<AppendixCMeter>> meters_;
};

}  // namespace rasterloom::emulation
