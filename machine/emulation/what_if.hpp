// SPDX-License-Identifier: MIT
// What would the frame time be if one parameter were another? Runs the machine again for each
// value, and compares with what the critical path of the unchanged machine predicts.
#pragma once

#include "machine/config/description.hpp"
#include "machine/observe/run_report.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rasterloom::emulation {

struct WhatIf {
    std::string key;
    config::MachineDescription machine;  // with the other value
};

struct WhatIfResult {
    std::string failure;  // why it did not finish; empty when it did
    Duration frame_time;  // mean of the frames
    // As the critical path has it: the steps on it that the parameter governs are scaled, and no
    // other path becomes critical. None for a parameter that governs no time.
    std::optional<Duration> predicted;
};

struct WhatIfReport {
    observe::RunReport base;  // with its critical paths
    std::string failure;      // of the unchanged machine; nothing else has run then
    Duration frame_time;
    std::vector<WhatIfResult> results;  // in the order of what was asked
};

// Runs on `workers` threads, at least 1, each machine on one. `progress(n)`: n runs are done;
// called from any of them, one at a time. Throws what run_machine throws; for a machine without
// frames ConfigError.
WhatIfReport what_if(const config::MachineDescription& base, const std::vector<WhatIf>& questions,
                     std::size_t workers, const std::function<void(std::size_t)>& progress);

// The sum of all critical paths of the frames of `run`, divided by their number, if `key` had the
// value that it has in `other`.
std::optional<Duration> predict(const observe::RunReport& run, const std::string& key,
                                const config::MachineDescription& base,
                                const config::MachineDescription& other);

}  // namespace rasterloom::emulation
