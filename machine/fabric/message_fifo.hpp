// SPDX-License-Identifier: MIT
// The FIFOs at both ends of a wire of the polygon fabric. The sending end may let a message go when
// the receiving FIFO has a free place (a credit); messages travel by address, and the sending end
// uses a message's memory again when its credit has come back (machine/node/message.hpp).
//
// A FIFO allocates only when more messages than ever before are under way, so a depth that is never
// reached costs nothing.
#pragma once

#include "machine/node/message.hpp"

#include <cstdint>
#include <deque>
#include <vector>

#include <boost/circular_buffer.hpp>

namespace rasterloom {

// How full a FIFO was. A message that goes on at the time at which it came was never in it.
struct FifoStatistics {
    int peak = 0;  // messages
    Duration full;
    std::int64_t message_picoseconds = 0;  // the integral of their number over time

    // Messages in the FIFO on average over `whole`, a time longer than 0.
    double mean(Duration whole) const {
        return static_cast<double>(message_picoseconds) / static_cast<double>(whole.picoseconds());
    }
};

// Keeps them: told of every change.
class FifoMeter {
  public:
    explicit FifoMeter(int places) : places_(places) {}
    void change(int messages, Time now);
    const FifoStatistics& statistics() const { return statistics_; }

  private:
    int places_;
    int messages_ = 0;
    Time since_;
    FifoStatistics statistics_;
};

// Messages by address, in the order in which they came; grows as needed.
class MessageRing {
  public:
    bool empty() const { return ring_.empty(); }
    int size() const { return static_cast<int>(ring_.size()); }
    Message* front() const { return ring_.front(); }
    void push(Message* message);
    Message* pop();

  private:
    boost::circular_buffer<Message*> ring_;
};

// The receiving end.
class InputFifo {
  public:
    explicit InputFifo(int places) : places_(places), meter_(places) {}

    int places() const { return places_; }
    bool empty() const { return messages_.empty(); }
    // False when the FIFO was full, which must not be.
    bool deliver(Message* message, Time now);
    const Message& oldest() const { return *messages_.front(); }  // not empty()
    // Frees the oldest message's place; its credit is to be sent back.
    void drop_oldest(Time now);
    const FifoStatistics& statistics() const { return meter_.statistics(); }

  private:
    int places_;
    MessageRing messages_;
    FifoMeter meter_;
};

// The sending end, for a receiver of `receiver_places` places.
class OutputFifo {
  public:
    OutputFifo(int places, int receiver_places)
        : places_(places), credits_(receiver_places), meter_(places) {}

    bool has_room() const { return waiting_.size() < places_; }
    bool receiver_has_room() const { return credits_ > 0; }
    // A message that is to be filled and waits from now on; has_room().
    Message& add();
    // To be called after add() and credit(): sends the messages that can go at `now`, each through
    // `send(Message*)`.
    template <class Send>
    void release(Time now, Send&& send) {
        while (credits_ > 0 && !waiting_.empty()) {
            --credits_;
            Message* message = waiting_.pop();
            message->started = now;
            under_way_.push(message);
            send(message);
        }
        meter_.change(waiting_.size(), now);
    }
    // The receiver has freed the place of the oldest message under way.
    void credit();
    bool empty() const { return waiting_.empty(); }
    const FifoStatistics& statistics() const { return meter_.statistics(); }

  private:
    int places_;
    int credits_;
    std::deque<Message> memory_;  // addresses stay
    std::vector<Message*> free_;
    MessageRing waiting_;
    MessageRing under_way_;
    FifoMeter meter_;
};

}  // namespace rasterloom
