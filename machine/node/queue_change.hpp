// SPDX-License-Identifier: MIT
// A message joins a queue or leaves it, as observers are told.
#pragma once

#include "machine/kernel/event.hpp"
#include "machine/kernel/time.hpp"

#include <cstdint>

namespace rasterloom {

// Which of a component's queues.
enum class QueuePlace : std::uint8_t {
    input,      // in front of it; who leaves is told by the message's record, not as a change
    at_sender,  // of a link or bus: at the processor that wants to send over it
    low,        // a splitter's output FIFOs
    high,
};
inline constexpr int kQueuePlaces = 4;

struct QueueChange {
    ComponentId component{};
    QueuePlace place = QueuePlace::input;
    Time time;
    int change = 1;  // in messages
};

}  // namespace rasterloom
