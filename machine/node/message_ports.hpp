// SPDX-License-Identifier: MIT
// A node's message ports: an output and an input queue for each neighbour, and who transmits next.
// State only; the Processor gives it the time and carries what it decides over the wires.
#pragma once

#include "machine/node/message.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rasterloom {

enum class SendPolicy : std::uint8_t {
    one_at_a_time,  // a node transmits one message at a time: the oldest whose link is ready
    each_port,      // every port transmits on its own
};

// Kept by each port over the whole run.
struct PortStatistics {
    std::int64_t messages_sent = 0;
    std::int64_t bytes_sent = 0;
    std::int64_t messages_received = 0;  // consumed by the program
    std::int64_t bytes_received = 0;
    Duration blocked;  // a message stood ready to go, the link idle, and the receiver's input queue
                       // was full
    int peak_output_queue = 0;  // messages, the one in transfer included
    int peak_input_queue = 0;
};

class MessagePorts {
  public:
    static constexpr std::uint32_t kAllPorts = ~0U;
    struct Settings {
        int ports = 0;         // 0 to kMaxPorts
        int output_queue = 2;  // messages, the one in transfer included; at least 1
        int input_queue = 4;   // messages; at least 1, and the same at the other end of every link
        SendPolicy send = SendPolicy::one_at_a_time;
        // Messages that can wait at the other end of a link; none: as many as here.
        std::optional<int> receivers_queue = {};
        // Bit k: port k has a way out, and a way in. A port without a way out never has room.
        std::uint32_t transmitting = kAllPorts;
        std::uint32_t receiving = kAllPorts;
    };
    struct Transmission {
        int port = 0;
        Message* message = nullptr;
    };

    // Throws std::invalid_argument when a number is out of range.
    MessagePorts(NodeIndex node, const Settings& settings);

    int count() const { return static_cast<int>(ports_.size()); }
    bool transmits(int port) const { return port < count() && (transmitting_ >> port & 1U) != 0; }
    bool receives(int port) const { return port < count() && (receiving_ >> port & 1U) != 0; }
    int input_queue() const { return input_queue_; }
    const PortStatistics& statistics(int port) const { return at(port).statistics; }

    // Output.
    bool has_room(int port) const { return (room_ >> port & 1U) != 0; }
    std::uint32_t room() const { return room_; }  // bit k: has_room(k)
    int used(int port) const { return at(port).used; }
    int queued(int port) const { return at(port).queued(); }                // not in transfer
    void enqueue(int port, std::span<const std::uint8_t> bytes, Time now);  // has_room(port)
    // Takes the next message that may be transmitted now, if there is one; to be called until there
    // is none.
    std::optional<Transmission> next_transmission(Time now);
    void transfer_done(int port, bool link_ready, Time now);
    void link_ready(int port, Time now);

    // Input.
    bool deliver(int port, Message* message,
                 Time now);  // false: the queue was full, which must not be
    int waiting(int port) const { return at(port).waiting; }
    bool any_waiting() const { return total_waiting_ != 0; }
    // The port whose oldest message has waited longest, the lowest such port.
    std::optional<int> longest_waiting() const;
    const Message& oldest(int port) const;  // waiting(port) > 0
    // Likewise. `when` may lie ahead of what has been delivered: the place is taken until then.
    void consume_oldest(int port, Time when);

  private:
    struct Arrived {
        Message* message = nullptr;
        Time consumed;  // once it is
    };
    struct Port {
        // Output: places are used in turn. There are as many as messages can be under way (output
        // and input queue).
        std::vector<Message> places;
        std::uint32_t next_place = 0;
        std::uint32_t oldest_queued = 0;  // place of the oldest message that is not in transfer yet
        int used = 0;                     // queued or in transfer
        bool in_transfer = false;
        bool link_ready = true;
        std::optional<Time> blocked_since;
        // Input: a ring, which grows up to the input queue's places as they are needed.
        std::vector<Arrived> arrived;
        std::uint32_t oldest_arrived = 0;
        int held = 0;  // places of the ring in use: at first those of messages consumed, when a
                       // later one was delivered last, then those of the ones that wait
        int waiting = 0;
        PortStatistics statistics;

        int queued() const { return used - (in_transfer ? 1 : 0); }
        std::size_t ring_index(int place) const {
            return (oldest_arrived + static_cast<std::size_t>(place)) % arrived.size();
        }
    };

    Port& at(int port) { return ports_[static_cast<std::size_t>(port)]; }
    const Port& at(int port) const { return ports_[static_cast<std::size_t>(port)]; }
    std::optional<int> next_sender() const;
    static void note_blocked(Port& port, Time now);
    void grow_arrived(Port& port) const;

    NodeIndex node_;
    int output_queue_;
    int input_queue_;
    SendPolicy send_;
    std::uint32_t transmitting_;
    std::uint32_t receiving_;
    std::vector<Port> ports_;
    std::uint32_t sent_ = 0;  // messages of this node so far
    int transfers_ = 0;       // ports in transfer
    int queued_ = 0;          // messages queued and not in transfer, at all ports
    std::uint32_t room_ = 0;
    int total_waiting_ = 0;
};

}  // namespace rasterloom
