// SPDX-License-Identifier: MIT
#include "machine/fabric/frame_buffer_bus.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom {

FrameBufferBus::FrameBufferBus(std::string name, Duration time_per_pixel, int processors)
    : Component(std::move(name)), time_per_pixel_(time_per_pixel) {
    if (time_per_pixel < Duration()) {
        throw std::invalid_argument(
            fmt::format("{}: a bus' time for a pixel is not negative", this->name()));
    }
    if (processors < 1) {
        throw std::invalid_argument(
            fmt::format("{}: a frame-buffer bus has at least 1 processor", this->name()));
    }
    for (int processor = 0; processor < processors; ++processor) {
        add_port(fmt::format("processor {}", processor));
    }
    asked_.resize(ports().size());
    waits_.resize(ports().size());
    statistics_.waiting_of.resize(ports().size());
}

Duration FrameBufferBus::wire() const {
    return std::max(Duration::tick(), Duration::picoseconds(time_per_pixel_.picoseconds() / 2));
}

void FrameBufferBus::connect(Simulation& simulation, int index, Processor& processor) {
    simulation.connect(*this, static_cast<PortIndex>(index), processor,
                       processor.frame_buffer_port(), wire());
}

// The bus is granted by an event of its own, which comes after all requests of its time.
void FrameBufferBus::handle(const Event& event) {
    if (event.phase() == EventPhase::work) {
        arbitrates_ = false;
        if (waiting_ > 0) {
            grant();
        } else {
            probe_.enter(id(), PartState::idle, now());
        }
        return;
    }
    const auto processor = static_cast<std::size_t>(event.port);
    asked_[processor] = now();
    waits_[processor] = true;
    statistics_.peak_waiting = std::max(statistics_.peak_waiting, ++waiting_);
    if (!arbitrates_) {
        arbitrates_ = true;
        wake_at(now(), 0);
    }
}

void FrameBufferBus::grant() {
    const std::size_t count = waits_.size();
    std::size_t processor = next_;
    while (!waits_[processor]) {
        processor = (processor + 1) % count;
    }
    next_ = (processor + 1) % count;
    waits_[processor] = false;
    --waiting_;
    ++statistics_.pixels;
    probe_.enter(id(), PartState::busy, now());
    statistics_.busy += time_per_pixel_;
    const Duration waited = now() - asked_[processor];
    statistics_.waiting += waited;
    statistics_.waiting_of[processor] += waited;
    // The odd tick of an odd time is the answer's.
    const Time answer = std::max(now(), now() + time_per_pixel_ - 2 * wire());
    send(static_cast<PortIndex>(processor), static_cast<EventKind>(FrameBufferEvent::done), 0,
         answer);
    arbitrates_ = true;
    wake_at(now() + time_per_pixel_, 0);
}

}  // namespace rasterloom
