// SPDX-License-Identifier: MIT
// What has become of one point of a sweep, and the same as bytes, to go from the process that ran
// it to the one that writes it down.
#pragma once

#include "machine/observe/sweep/run_figures.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::observe {

struct SweepResult {
    std::string error;           // why there are no figures; empty: there are
    std::vector<Cell> figures;   // [figure of run_figures()]
    double wall_seconds = 0;     // of the emulation
    double machine_seconds = 0;  // that were emulated in them
    std::string fingerprint;     // of everything that the result depends on
};

SweepResult failed_result(std::string error);
SweepResult result_of(const RunReport& report, double wall_seconds);

std::string encode(const SweepResult& result);
// Of what encode() gave.
SweepResult decode_result(std::string_view bytes);

struct SweepRow {
    std::string key;
    std::string config;
    std::optional<std::string> scene;
    std::vector<std::string> values;  // [parameter]
    SweepResult result;
};

}  // namespace rasterloom::observe
