// SPDX-License-Identifier: MIT
// rasterloom bottlenecks: where the machine lost its time, read from the trace of a run.
#include "machine/cli/command.hpp"
#include "machine/observe/bottlenecks/bottlenecks.hpp"

#include <memory>
#include <string>

#include <fmt/format.h>

namespace rasterloom::cli {

void add_bottlenecks_command(CLI::App& app, Session& /*session*/) {
    auto trace = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand(
        "bottlenecks",
        "Where a machine lost its time: from a trace that `rasterloom run --trace NAME.sqlite` "
        "wrote");
    command->add_option("trace", *trace, "The trace, NAME.sqlite")->required()->type_name("FILE");
    command->callback([trace] {
        fmt::print("{}", observe::bottlenecks_text(observe::find_bottlenecks(*trace)));
    });
}

}  // namespace rasterloom::cli
