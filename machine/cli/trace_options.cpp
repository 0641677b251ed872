// SPDX-License-Identifier: MIT
#include "machine/cli/trace_options.hpp"

#include "machine/config/error.hpp"
#include "machine/config/units.hpp"

#include <stdexcept>

namespace rasterloom::cli {

namespace {

// "10ms..20ms"; either end may be left out.
void set_window(const std::string& text, emulation::TraceOptions& traces) {
    const std::size_t dots = text.find("..");
    try {
        if (dots == std::string::npos) {
            throw std::invalid_argument("no window of time");
        }
        if (const std::string from = text.substr(0, dots); !from.empty()) {
            traces.from = Time::zero() + config::parse_duration(from);
        }
        if (const std::string to = text.substr(dots + 2); !to.empty()) {
            traces.to = Time::zero() + config::parse_duration(to);
        }
        if (traces.from >= traces.to) {
            throw std::invalid_argument("an empty window");
        }
    } catch (const std::invalid_argument& error) {
        config::refuse({"--trace-window", 0, 0}, {}, text, error.what(), "FROM..TO, as 10ms..20ms");
    }
}

}  // namespace

emulation::TraceOptions to_run(const TraceOptions& options) {
    emulation::TraceOptions traces;
    for (const std::string& trace : options.files) {
        if (!emulation::kind_of_trace(trace)) {
            config::refuse({"--trace", 0, 0}, {}, trace, "not a kind of trace",
                           "a name that ends in .perfetto-trace or .sqlite");
        }
        traces.paths.emplace_back(trace);
    }
    if (!options.window.empty()) {
        set_window(options.window, traces);
    }
    traces.components = options.of;
    return traces;
}

void add_trace_options(CLI::App& command, TraceOptions& options) {
    CLI::Option* trace =
        command
            .add_option(
                "--trace", options.files,
                "Write what every part of the machine did and when: NAME.perfetto-trace for "
                "ui.perfetto.dev, NAME.sqlite for `rasterloom bottlenecks` and SQL; repeatable")
            ->type_name("FILE")
            ->allow_extra_args(false);
    command
        .add_option("--trace-window", options.window,
                    "Trace only what happens in this machine time: 10ms..20ms")
        ->type_name("FROM..TO")
        ->needs(trace);
    command
        .add_option("--trace-of", options.of,
                    "Trace only these processors, links and parts, and their messages")
        ->delimiter(',')
        ->type_name("NAME,...")
        ->allow_extra_args(false)
        ->needs(trace);
}

}  // namespace rasterloom::cli
