// SPDX-License-Identifier: MIT
// Where a machine lost its time, read from the trace of a run
// (machine/observe/trace/trace_schema.hpp).
#pragma once

#include "machine/kernel/time.hpp"
#include "machine/observe/database.hpp"
#include "machine/observe/machine_names.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rasterloom::observe {

// One component, or the wires behind all of a kind: kind "wire", name "from link".
struct PathShare {
    ComponentLabel who;
    Duration time;
    std::int64_t steps = 0;
};

// What the critical path of a frame is made of; each list sums up to the frame's time, but for
// activities and lines, which are those of processors that execute.
struct PathQuestions {
    struct Phase {
        std::string name;
        std::vector<Duration> by_kind;  // in the order of `kinds`
    };
    struct Line {
        std::string place;  // "draw.s:120"
        std::int64_t instructions = 0;
        Duration time;
    };

    std::int64_t frame = 0;
    Duration length;
    std::vector<PathShare> kinds;       // largest first; names as kinds
    std::vector<PathShare> components;  // likewise
    std::vector<Phase> phases;          // in their order
    std::vector<std::pair<std::string, Duration>> activities;
    std::vector<Line> lines;  // largest first; empty where the run did not look
};

// How much of the run a component was busy; the largest first.
struct Use {
    ComponentLabel who;
    Duration busy;
    Duration blocked;  // had something to hand on for which there was no room
};

// How much processors waited because of a component, or of the wire behind it; the largest first.
struct Contention {
    ComponentLabel who;
    bool on_wire = false;
    std::int64_t waits = 0;
    Duration time;  // summed over those who waited
};

// How evenly a phase's work was dealt out, over all frames.
struct Balance {
    std::string phase;
    Duration lasted;
    Duration mean;  // busy time of a processor
    Duration most;
    std::string busiest;

    double imbalance() const;  // most over mean; 1 where there is no work
};

// What held up others: a component, its queue, and who they were; or all wires behind one kind of
// component.
struct HotSpot {
    ComponentLabel who;         // kind "wires", name "behind links"
    Duration on_path;           // of all frames
    std::vector<double> queue;  // messages that waited for it, on average, by parts of the run
    int longest_queue = 0;
    std::vector<std::pair<std::string, Duration>> waiters;  // the longest first, at most 5
};

// Time in which processors of the machine waited for something, by what took the time.
struct IdleCause {
    std::string state;  // "waiting_input"
    std::string cause;  // kind of component, "wire", or "unknown"
    Duration time;
};

struct Bottlenecks {
    std::string machine;
    Duration cycle;
    Duration run;
    std::int64_t nodes = 0;
    std::vector<PathQuestions> paths;  // [frame]
    std::vector<HotSpot> hot_spots;    // what the frames spent most of their time on, at most 3
    std::vector<Use> busiest;          // at most 8
    std::vector<Contention> contention;
    std::vector<Balance> phases;
    Duration idle;  // of all processors
    std::vector<IdleCause> idle_causes;
};

// Throws DatabaseError when the file cannot be read or is no trace of this format.
Bottlenecks find_bottlenecks(const std::filesystem::path& trace);

// Two pages for a person. What the frames spent most of their time on comes first.
std::string bottlenecks_text(const Bottlenecks& found);

}  // namespace rasterloom::observe
