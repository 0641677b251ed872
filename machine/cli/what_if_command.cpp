// SPDX-License-Identifier: MIT
// rasterloom whatif: how the frame time answers to each parameter.
#include "machine/cli/command.hpp"
#include "machine/cli/config_options.hpp"
#include "machine/config/error.hpp"
#include "machine/config/variation.hpp"
#include "machine/emulation/what_if.hpp"
#include "machine/observe/figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

namespace rasterloom::cli {

namespace {

struct WhatIfOptions {
    ConfigOptions config;
    std::vector<std::string> vary;
    std::size_t workers = std::max(1U, std::thread::hardware_concurrency());
};

double percent(Duration from, Duration to) {
    return 100 * observe::share(to - from, from);
}

void print(const emulation::WhatIfReport& report,
           const std::vector<config::Variation>& variations) {
    fmt::print("Frame time as it is: {}\n\n", observe::human(report.frame_time));
    fmt::print("{:<34}{:>8}{:>12}{:>14}{:>10}{:>12}\n", "Parameter", "change", "value",
               "frame time", "change", "predicted");
    double error = 0;
    int predictions = 0;
    for (std::size_t i = 0; i < variations.size(); ++i) {
        const config::Variation& variation = variations[i];
        const emulation::WhatIfResult& result = report.results[i];
        fmt::print("{:<34}{:>8}{:>12}", variation.key, variation.change, variation.value);
        if (!result.failure.empty()) {
            fmt::print("  {}\n", result.failure.substr(0, result.failure.find('\n')));
            continue;
        }
        fmt::print("{:>14}{:>+9.2f}%", observe::human(result.frame_time),
                   percent(report.frame_time, result.frame_time));
        if (result.predicted) {
            fmt::print("{:>+11.2f}%\n", percent(report.frame_time, *result.predicted));
            error += std::abs(percent(result.frame_time, *result.predicted));
            ++predictions;
        } else {
            fmt::print("{:>12}\n", "-");
        }
    }
    if (predictions > 0) {
        fmt::print("\nThe critical path's prediction is off by {:.2f} % on the mean.\n",
                   error / predictions);
    }
}

void run(const WhatIfOptions& options, Session& session) {
    const config::MachineDescription base = load(options.config, session);
    std::vector<config::Variation> variations;
    std::vector<emulation::WhatIf> questions;
    for (const std::string& text : options.vary) {
        for (config::Variation& variation : config::parse_variations(text, base)) {
            questions.push_back({variation.key, load(options.config, session, variation.setting)});
            variations.push_back(std::move(variation));
        }
    }
    const emulation::WhatIfReport report =
        emulation::what_if(base, questions, options.workers, [](std::size_t) {});
    if (!report.failure.empty()) {
        fmt::print(stderr, "rasterloom: {}\n", report.failure);
        session.status = ExitStatus::guest_error;
        return;
    }
    print(report, variations);
}

}  // namespace

void add_what_if_command(CLI::App& app, Session& session) {
    auto options = std::make_shared<WhatIfOptions>();
    CLI::App* command = app.add_subcommand(
        "whatif",
        "How the frame time answers to each parameter, beside what the critical path "
        "predicts");
    add_config_options(*command, options->config);
    command
        ->add_option("--vary", options->vary,
                     "Other values for a key, each tried alone: factors (links.latency=x0.5,x2) or "
                     "values; may be given several times")
        ->required()
        ->type_name("KEY=CHANGE,...")
        ->allow_extra_args(false);
    command->add_option("--frames", options->config.frames, "Draw so many frames: run.frames")
        ->type_name("N");
    command
        ->add_option("--workers", options->workers,
                     "Run so many machines at once; default: all cores")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    command->callback([options, &session] { run(*options, session); });
}

}  // namespace rasterloom::cli
