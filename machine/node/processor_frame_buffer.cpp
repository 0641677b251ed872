// SPDX-License-Identifier: MIT
// The processor's frame buffer as its program sees it: FBROW, FBCLEAR, and the image window over
// the frame-buffer bus.
#include "machine/node/processor.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom {

void Processor::add_frame_buffer(const FrameBuffer::Settings& settings) {
    try {
        frame_buffer_.emplace(*core_, settings);
    } catch (const std::invalid_argument& problem) {
        throw std::invalid_argument(fmt::format("{}: {}", name(), problem.what()));
    }
    if (settings.over_bus) {
        add_port("frame buffer");
    }
}

// A row and the clearing are the node's own business: nobody has to catch up for them.
isa::Bus::Status Processor::write_frame_buffer(std::uint32_t address, std::uint32_t value) {
    if (address != kFbRow && address != kFbClear) {
        return write_image_window(address, value);
    }
    if (!frame_buffer_) {
        return refuse(fmt::format("{} {} on a node without a frame buffer",
                                  address == kFbRow ? "FBROW" : "FBCLEAR",
                                  format_word(value, settings_.radix)));
    }
    ++accesses_;
    if (address == kFbRow) {
        return select_row(value);
    }
    frame_buffer_probe_.tell([this](FrameBufferListener& listener) {
        listener.frame_buffer_cleared(node(), *core_, *frame_buffer_);
    });
    frame_buffer_->clear(static_cast<std::uint16_t>(value));
    return Status::ok;
}

isa::Bus::Status Processor::select_row(std::uint32_t row) {
    if (row >= static_cast<std::uint32_t>(frame_buffer_->rows())) {
        return refuse(fmt::format(
            "FBROW {}: the frame buffer has rows 0 to {}", format_word(row, settings_.radix),
            format_word(static_cast<std::uint32_t>(frame_buffer_->rows() - 1), settings_.radix)));
    }
    frame_buffer_->select(static_cast<int>(row));
    return Status::ok;
}

isa::Bus::Status Processor::write_image_window(std::uint32_t address, std::uint32_t value) {
    if (!frame_buffer_ || !frame_buffer_->over_bus() || address % 2 != 0 ||
        address < kBusImageWindow) {
        return Status::fault;
    }
    const std::uint32_t column = (address - kBusImageWindow) / 2;
    if (column >= static_cast<std::uint32_t>(frame_buffer_->columns())) {
        return Status::fault;
    }
    if (!frame_buffer_->selected()) {
        return refuse("an image word is written before FBROW has selected a row");
    }
    if (!pixel_written_) {
        return ask_for_bus(column);
    }
    pixel_written_ = false;
    ++accesses_;
    frame_buffer_->write_image(static_cast<int>(column), static_cast<std::uint16_t>(value));
    return Status::ok;
}

// The write stalls; when the bus has taken the word it is tried again, and then it stands.
isa::Bus::Status Processor::ask_for_bus(std::uint32_t column) {
    if (!reach_local_time()) {
        must_catch_up_ = true;
        return Status::retry;
    }
    const Status status = stall(Stall::pixel, column);
    if (stall_ == Stall::pixel) {
        send(frame_buffer_port(), static_cast<EventKind>(FrameBufferEvent::request), 0, now());
    }
    return status;
}

}  // namespace rasterloom
