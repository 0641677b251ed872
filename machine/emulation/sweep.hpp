// SPDX-License-Identifier: MIT
// A sweep from its description to results.sqlite and results.csv.
#pragma once

#include "machine/config/sweep.hpp"
#include "machine/emulation/point_workers.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>

namespace rasterloom::emulation {

struct SweepProgress {
    std::size_t points = 0;
    std::size_t done = 0;    // failed ones and those of earlier starts included
    std::size_t before = 0;  // of earlier starts
    std::size_t failed = 0;  // of all that are done
    double seconds = 0;      // of wall time, this start's

    // By the pace so far; 0 when there is none yet.
    double seconds_left() const;
};

struct SweepOptions {
    std::filesystem::path folder;
    bool fresh = false;         // forget what an earlier start has found
    bool retry_failed = false;  // forget what has failed
    std::function<void(const SweepProgress&)> progress;
};

// What a worker does with a point of the sweep, which must outlive it.
PointTask sweep_task(const config::SweepDescription& sweep, const config::Locator& locator);

// Runs what is missing and writes the files. Points whose configuration has changed since they were
// run are run again. A point whose worker dies is tried once more. Throws observe::OutputError when
// the files cannot be written, with everything that was before it in them.
SweepProgress run_sweep(const config::SweepDescription& sweep, const config::Locator& locator,
                        PointWorkers& workers, const SweepOptions& options);

}  // namespace rasterloom::emulation
