// SPDX-License-Identifier: MIT
// From a description to a finished run: build, load, run, collect.
#pragma once

#include "machine/config/description.hpp"
#include "machine/emulation/traces.hpp"
#include "machine/host/picture.hpp"
#include "machine/kernel/failure.hpp"
#include "machine/observe/appendix_c/appendix_c.hpp"
#include "machine/observe/bottlenecks/bottlenecks.hpp"
#include "machine/observe/page/machine_drawing.hpp"
#include "machine/observe/page/run_timeline.hpp"
#include "machine/observe/run_report.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rasterloom::emulation {

struct Progress {
    Time now;
    std::int64_t frame = 0;  // being drawn, from 0
    std::int64_t frames = 1;
    std::int64_t phase = 0;  // of the frame, from 0
    std::int64_t phases = 1;
};

struct RunOptions {
    // Where to stream messages.csv to; none: not written.
    std::optional<std::filesystem::path> messages_csv;
    bool reference_pictures = false;
    // Where lanes send each other polygons: Eldridge's three checks after each communication
    // (princeton_check.hpp). What they find wrong is RunOutcome::failure. Takes time of the host's;
    // whoever measures that leaves them out.
    bool check_communication = true;
    // Statistics as in Parks' appendix C; the run takes somewhat longer.
    bool appendix_c = false;
    std::vector<std::string> appendix_c_of;  // processors that somebody will want to see
    TraceOptions traces;
    bool paths = false;        // RunReport::paths; the run takes somewhat longer
    bool bottlenecks = false;  // RunOutcome::bottlenecks, and paths; takes up to twice as long
    // What report.html shows: RunOutcome::timeline and drawing, and paths where there are frames.
    bool page = false;
    // Called now and then while the machine runs; about ten times a second of wall time.
    std::function<void(const Progress&)> progress;
};

struct RunOutcome {
    // Why the machine did not finish: guest error, deadlock, time limit. Empty when it did.
    std::string failure;
    observe::RunReport report;                           // also of a failed run, as far as it went
    std::vector<host::Picture> pictures;                 // one a frame
    std::vector<host::Picture> videos;                   // likewise, if the machine has an output
    std::vector<host::Picture> references;               // likewise, if asked for
    std::optional<observe::AppendixCReport> appendix_c;  // if asked for
    std::optional<observe::Bottlenecks> bottlenecks;     // if asked for
    std::optional<observe::RunTimeline> timeline;        // likewise
    observe::MachineDrawing drawing;                     // with the timeline
    int background = 0;                                  // grey level
    std::string remarks;                                 // on how the object was prepared
    double wall_seconds = 0;  // of the run itself, building and loading not counted
};

// Throws ConfigError and isa::AssemblyError for what is wrong with the input, OutputError for
// messages.csv.
RunOutcome run_machine(const config::MachineDescription& description, const RunOptions& options);

}  // namespace rasterloom::emulation
