// SPDX-License-Identifier: MIT
// What a run was like: plain numbers, gathered once it is over. All of it is emulated, so it is the
// same on any machine; how long the emulation itself took is not part of it.
#pragma once

#include "machine/kernel/clock.hpp"
#include "machine/kernel/time.hpp"
#include "machine/node/node_statistics.hpp"
#include "machine/observe/array_report.hpp"
#include "machine/observe/bucket_report.hpp"
#include "machine/observe/fabric_report.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rasterloom::observe {

struct NodeReport {
    std::string name;
    NodeStatistics statistics;
    std::int64_t messages_sent = 0;
    std::int64_t bytes_sent = 0;
    std::int64_t messages_received = 0;
    std::int64_t bytes_received = 0;
    int peak_output_queue = 0;  // messages, at the fullest of its ports
    int peak_input_queue = 0;
};

// One direction of an edge.
struct LinkReport {
    NodeIndex from = 0;
    NodeIndex to = 0;
    int port = 0;  // of `from`
    std::int64_t messages = 0;
    std::int64_t bytes = 0;
    Duration busy;     // transferring
    Duration blocked;  // a message ready, the link idle, the receiver's input queue full
    int peak_output_queue = 0;
    int peak_input_queue = 0;  // at the receiver
};

// Rounds of a phase in which a message takes a fixed time whatever its length
// (links.time_per_message above zero and links.time_per_byte zero): round r lasts from r to r + 1
// such times after the phase began.
struct RoundsReport {
    // Until the last message has arrived, the round that finds it arrived included: one more than
    // its route where nothing delays it (Strothotte 1981, 5.2.1). 0 when there was no message.
    std::int64_t rounds = 0;
    std::vector<std::int64_t> senders;  // [round]: nodes that began to send in it
};

struct PhaseReport {
    std::int64_t frame = 0;
    std::int64_t phase = 0;  // of the frame
    Time start;
    Time end;
    std::int64_t messages = 0;  // hops
    std::int64_t bytes = 0;
    std::int64_t longest_route =
        0;  // hops of the message that had gone farthest, by the programs' count
    std::optional<RoundsReport> rounds;
};

// What the critical path of a frame is made of (machine/observe/bottlenecks/critical_path.hpp). The
// times of each list sum up to the frame's.
struct PathReport {
    struct Share {
        std::string kind;  // of component: "node", "link", "bus", ...; "wire" for latencies
        std::string name;  // of the component; in a list of kinds the kind
        Duration time;
        std::int64_t steps = 0;
    };
    struct ActivityShare {
        int activity = 0;  // that MARK named
        Duration time;
    };
    struct LineShare {     // of the programs' source
        std::string file;  // seen from the program's folder
        int line = 0;
        std::int64_t instructions = 0;
        Duration time;
    };
    struct PhaseShare {
        std::int64_t phase = 0;  // of the frame
        std::string kind;
        Duration time;
    };

    std::int64_t frame = 0;
    Time began;
    Time ended;
    std::int64_t steps = 0;
    std::vector<Share> kinds;          // largest first
    std::vector<Share> components;     // likewise
    std::vector<PhaseShare> by_phase;  // in the order of phases
    // What the programs were at while processors executed on the path; what is missing to the
    // nodes' time is spent on the way to the next edge of a clock.
    std::vector<ActivityShare> activities;  // in the order of activities
    std::vector<LineShare> lines;           // likewise; largest first; empty unless looked for
};

struct RunReport {
    std::string machine;
    Clock clock = Clock::with_period(Duration::microseconds(
        1));  // of the nodes: one cycle is the unit u of the thesis' cost model
    Time end;
    std::int64_t frames = 0;
    std::vector<Time> frame_ends;
    std::vector<PhaseReport> phases;
    std::vector<NodeReport> nodes;
    std::vector<LinkReport> links;            // of a graph
    std::vector<FabricPartReport> fabric;     // of a machine that deals out the screen
    std::optional<ArrayReport> array;         // of a lock-step machine
    std::optional<BucketReport> buckets;      // of a bucket tiler
    std::vector<PathReport> paths;            // one a frame, if asked for
    std::vector<std::string> phase_names;     // [phase of the frame]; may be shorter
    std::vector<std::string> activity_names;  // [activity that MARK names]; may be shorter
    // Handled by the kernel: depends on how the run was sliced, so it is in no file.
    std::uint64_t events = 0;

    std::string phase_name(std::int64_t phase) const;  // "rotate", or "phase 0" when it has no name
    std::string activity_name(int activity) const;
    std::int64_t units(Duration duration) const {
        return clock.edge_at_or_before(Time::zero() + duration).count();
    }
    const NodeReport& busiest() const;  // the first of those that executed longest; nodes not empty
    double imbalance() const;           // its busy time over the mean; 1 is perfect balance
    std::int64_t instructions() const;
    std::int64_t cycles() const;
    std::int64_t messages() const;  // over all links, or to all processors where there are none
    std::int64_t bytes() const;
};

}  // namespace rasterloom::observe
