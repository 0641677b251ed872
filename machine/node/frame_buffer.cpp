// SPDX-License-Identifier: MIT
#include "machine/node/frame_buffer.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom {

namespace {

constexpr int kMaxRows = 65'536;

// The first row word by word, the others as copies of it.
void fill_words(std::vector<std::uint8_t>& bytes, std::size_t row, std::uint16_t word) {
    for (std::size_t i = 0; i < row; i += 2) {
        bytes[i] = static_cast<std::uint8_t>(word & 0377U);
        bytes[i + 1] = static_cast<std::uint8_t>(word >> 8U);
    }
    for (std::size_t i = row; i < bytes.size(); i += row) {
        std::copy_n(bytes.data(), row, bytes.data() + i);
    }
}

std::int16_t word_at(std::span<const std::uint8_t> bytes, std::size_t offset) {
    return static_cast<std::int16_t>(bytes[offset] | bytes[offset + 1] << 8U);
}

}  // namespace

FrameBuffer::FrameBuffer(isa::Core& core, const Settings& settings)
    : core_(&core), settings_(settings) {
    if (settings.rows < 1 || settings.rows > kMaxRows) {
        throw std::invalid_argument(
            fmt::format("a frame buffer has 1 to {} rows, not {}", kMaxRows, settings.rows));
    }
    if (settings.columns < 1 || settings.columns > kMaxFrameBufferColumns) {
        throw std::invalid_argument(fmt::format("a frame buffer has 1 to {} columns, not {}",
                                                kMaxFrameBufferColumns, settings.columns));
    }
    const std::uint32_t last_window = settings.over_bus ? kDepthWindow : kImageWindow;
    const std::size_t needed = last_window + row_bytes();
    if (core.memory().size() < needed) {
        throw std::invalid_argument(fmt::format(
            "the frame buffer's windows of {} columns need {} bytes of memory, there are {}",
            settings.columns, needed, core.memory().size()));
    }
    depth_.resize(static_cast<std::size_t>(settings.rows) * row_bytes());
    image_.resize(depth_.size());
    fill_words(depth_, row_bytes(), kFarthestDepth);
}

void FrameBuffer::keep_selected() {
    const auto memory = core_->memory();
    const std::size_t row = offset(*selected_);
    std::copy_n(memory.data() + kDepthWindow, row_bytes(), depth_.data() + row);
    if (!settings_.over_bus) {
        std::copy_n(memory.data() + kImageWindow, row_bytes(), image_.data() + row);
    }
}

void FrameBuffer::show_selected() {
    const std::size_t row = offset(*selected_);
    core_->write_memory(kDepthWindow, std::span(depth_).subspan(row, row_bytes()));
    if (!settings_.over_bus) {
        core_->write_memory(kImageWindow, std::span(image_).subspan(row, row_bytes()));
    }
}

void FrameBuffer::select(int row) {
    if (selected_ == row) {
        return;
    }
    if (selected_) {
        keep_selected();
    }
    selected_ = row;
    show_selected();
}

void FrameBuffer::clear(std::uint16_t image) {
    fill_words(depth_, row_bytes(), kFarthestDepth);
    fill_words(image_, row_bytes(), image);
    if (selected_) {
        show_selected();
    }
}

void FrameBuffer::write_image(int column, std::uint16_t value) {
    const std::size_t at = offset(*selected_) + 2 * static_cast<std::size_t>(column);
    image_[at] = static_cast<std::uint8_t>(value & 0377U);
    image_[at + 1] = static_cast<std::uint8_t>(value >> 8U);
}

std::int16_t FrameBuffer::depth(int row, int column) const {
    const std::size_t in_row = 2 * static_cast<std::size_t>(column);
    if (selected_ == row) {
        return word_at(core_->memory(), kDepthWindow + in_row);
    }
    return word_at(depth_, offset(row) + in_row);
}

std::int16_t FrameBuffer::image(int row, int column) const {
    const std::size_t in_row = 2 * static_cast<std::size_t>(column);
    if (selected_ == row && !settings_.over_bus) {
        return word_at(core_->memory(), kImageWindow + in_row);
    }
    return word_at(image_, offset(row) + in_row);
}

std::span<const std::uint8_t> FrameBuffer::image_row(int row) const {
    if (selected_ == row && !settings_.over_bus) {
        return core_->memory().subspan(kImageWindow, row_bytes());
    }
    return std::span(image_).subspan(offset(row), row_bytes());
}

}  // namespace rasterloom
