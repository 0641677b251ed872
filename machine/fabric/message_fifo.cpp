// SPDX-License-Identifier: MIT
#include "machine/fabric/message_fifo.hpp"

#include <algorithm>

namespace rasterloom {

void FifoMeter::change(int messages, Time now) {
    const Duration passed = now - since_;
    statistics_.message_picoseconds += messages_ * passed.picoseconds();
    if (messages_ == places_) {
        statistics_.full += passed;
    }
    since_ = now;
    messages_ = messages;
    statistics_.peak = std::max(statistics_.peak, messages);
}

void MessageRing::push(Message* message) {
    if (ring_.full()) {
        ring_.set_capacity(std::max<std::size_t>(4, 2 * ring_.capacity()));
    }
    ring_.push_back(message);
}

Message* MessageRing::pop() {
    Message* oldest = ring_.front();
    ring_.pop_front();
    return oldest;
}

bool InputFifo::deliver(Message* message, Time now) {
    if (messages_.size() == places_) {
        return false;
    }
    message->delivered = now;
    messages_.push(message);
    meter_.change(messages_.size(), now);
    return true;
}

void InputFifo::drop_oldest(Time now) {
    messages_.pop();
    meter_.change(messages_.size(), now);
}

Message& OutputFifo::add() {
    if (free_.empty()) {
        free_.push_back(&memory_.emplace_back());
    }
    Message* message = free_.back();
    free_.pop_back();
    waiting_.push(message);
    return *message;
}

void OutputFifo::credit() {
    ++credits_;
    free_.push_back(under_way_.pop());
}

}  // namespace rasterloom
