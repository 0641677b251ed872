// SPDX-License-Identifier: MIT
#include "machine/emulation/appendix_c_collector.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::emulation {

using observe::Section;

namespace {

// What the program did between two taps.
Section section_between(std::optional<TilerTap> from, std::optional<TilerTap> to) {
    if (!from) {
        return Section::other;
    }
    switch (*from) {
        case TilerTap::idle:
            return to == TilerTap::polygon  ? Section::polygon
                   : to == TilerTap::digest ? Section::digest
                                            : Section::other;
        case TilerTap::digest:
            return Section::digest;
        case TilerTap::polygon:
            return Section::polygon;
        case TilerTap::vertex:
            return Section::vertex;
        case TilerTap::segment:
        case TilerTap::pixels_done:
            return Section::segment;
        case TilerTap::pixels:
            return Section::pixel;
    }
    return Section::other;
}

}  // namespace

AppendixCMeter::AppendixCMeter(const TilerTaps& taps, const FrameBuffer& frame_buffer)
    : taps_(&taps),
      frame_buffer_(&frame_buffer),
      complexity_(static_cast<std::size_t>(frame_buffer.rows()) *
                  static_cast<std::size_t>(frame_buffer.columns())) {}

void AppendixCMeter::book(std::int64_t cycles, Section section) {
    frame_.cycles[static_cast<std::size_t>(section)] += cycles - booked_until_;
    booked_until_ = cycles;
}

void AppendixCMeter::tapped(const Tap& tap) {
    const TilerTap kind = taps_->kind(tap.address);
    if (last_ == TilerTap::pixels && kind == TilerTap::pixels) {
        return;  // the label stands in the loop, which has come round to it
    }
    const bool idled = last_ == TilerTap::idle && kind == TilerTap::idle;
    if (last_ == TilerTap::pixels) {
        end_run(tap.core, tap.cycles - booked_until_);
    }
    book(tap.cycles, section_between(last_, kind));
    last_ = kind;
    switch (kind) {
        case TilerTap::idle:
            end_polygon();
            if (idled) {
                end_frame();
            }
            break;
        case TilerTap::digest:
            end_polygon();
            ++frame_.digested;
            break;
        case TilerTap::polygon:
            end_polygon();
            polygon_open_ = true;
            frame_.vertices.add(taps_->vertices(tap.core));
            break;
        case TilerTap::vertex:
            ++frame_.edges;
            break;
        case TilerTap::segment:
            end_segment();
            segment_open_ = true;
            ++height_;
            break;
        case TilerTap::pixels:
            begin_run(tap.core);
            break;
        case TilerTap::pixels_done:
            break;
    }
}

std::uint16_t AppendixCMeter::depth_word(const isa::Core& core, int column) const {
    const auto memory = core.memory();
    const std::size_t at = kDepthWindow + 2 * static_cast<std::size_t>(column);
    return static_cast<std::uint16_t>(memory[at] | memory[at + 1] << 8);
}

void AppendixCMeter::begin_run(const isa::Core& core) {
    run_ = TilerTaps::run(core);
    const auto row = frame_buffer_->selected();
    if (!row || run_.column < 0 || run_.pixels < 1 ||
        run_.column + run_.pixels > frame_buffer_->columns()) {
        throw std::logic_error(fmt::format(
            "the program's tap_pixels shows {} pixels from column {} on; the processor has {}",
            run_.pixels, run_.column, frame_buffer_->columns()));
    }
    depth_.clear();
    const std::size_t first =
        static_cast<std::size_t>(*row) * static_cast<std::size_t>(frame_buffer_->columns()) +
        static_cast<std::size_t>(run_.column);
    for (int i = 0; i < run_.pixels; ++i) {
        depth_.push_back(depth_word(core, run_.column + i));
        ++complexity_[first + static_cast<std::size_t>(i)];
    }
}

void AppendixCMeter::end_run(const isa::Core& core, std::int64_t cycles) {
    std::int64_t drawn = 0;
    for (int i = 0; i < run_.pixels; ++i) {
        const bool changed =
            depth_word(core, run_.column + i) != depth_[static_cast<std::size_t>(i)];
        drawn += changed ? 1 : 0;
    }
    frame_.drawn += drawn;
    if (run_.pixels > 1) {  // the tiler draws a single one without its loop
        frame_.pixel_fit.add(drawn, run_.pixels - drawn, cycles);
    }
}

void AppendixCMeter::end_segment() {
    if (segment_open_) {
        frame_.lengths.add(run_.pixels);
        area_ += run_.pixels;
        run_ = {};
        segment_open_ = false;
    }
}

void AppendixCMeter::end_polygon() {
    end_segment();
    if (polygon_open_) {
        frame_.heights.add(std::exchange(height_, 0));
        frame_.areas.add(std::exchange(area_, 0));
        polygon_open_ = false;
    }
}

void AppendixCMeter::end_frame() {
    for (std::uint32_t& polygons : complexity_) {
        frame_.depth.add(polygons);
        polygons = 0;
    }
    frames_.push_back(std::exchange(frame_, {}));
}

std::vector<observe::AppendixC> AppendixCMeter::finish(std::int64_t cycles) {
    book(cycles, section_between(last_, std::nullopt));
    end_polygon();
    end_frame();
    return std::exchange(frames_, {});
}

AppendixCCollector::AppendixCCollector(const isa::Image& image,
                                       const std::vector<Processor*>& processors)
    : taps_(image), processors_(processors) {
    const std::vector<std::uint32_t> addresses = taps_.addresses();
    for (Processor* processor : processors_) {
        if (processor->frame_buffer() == nullptr) {
            throw std::invalid_argument(
                fmt::format("{} has no frame buffer, which appendix C needs", processor->name()));
        }
        meters_.push_back(std::make_unique<AppendixCMeter>(taps_, *processor->frame_buffer()));
        processor->core().set_taps(addresses);
        processor->probe().attach(*meters_.back());
    }
}

observe::AppendixCReport AppendixCCollector::finish(const std::string& machine,
                                                    const std::vector<std::string>& names) {
    observe::AppendixCReport report{machine, {}, 0};
    for (std::size_t i = 0; i < meters_.size(); ++i) {
        report.nodes.push_back({processors_[i]->node(), names.at(i),
                                meters_[i]->finish(processors_[i]->statistics().cycles)});
        report.frames =
            std::max(report.frames, static_cast<std::int64_t>(report.nodes.back().frames.size()));
    }
    return report;
}

}  // namespace rasterloom::emulation
