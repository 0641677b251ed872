// SPDX-License-Identifier: MIT
// What of a run is traced, and where to, as the user says it.
#pragma once

#include "machine/emulation/traces.hpp"

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace rasterloom::cli {

struct TraceOptions {
    std::vector<std::string> files;
    std::string window;
    std::vector<std::string> of;
};

void add_trace_options(CLI::App& command, TraceOptions& options);

// Throws ConfigError for what means nothing.
emulation::TraceOptions to_run(const TraceOptions& options);

}  // namespace rasterloom::cli
