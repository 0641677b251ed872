// SPDX-License-Identifier: MIT
// The subcommands of `rasterloom`. Each adds itself to the command line; CLI11 calls it when the
// user names it.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace rasterloom::cli {

enum class ExitStatus : int {
    success = 0,
    internal_error = 1,  // a broken invariant: a defect of the emulator
    bad_input = 2,       // usage, configuration, program source, mesh, output folder
    guest_error = 3,     // the emulated machine failed: guest error, deadlock, time limit
};

// What the subcommands share.
struct Session {
    std::string data;  // --data
    ExitStatus status = ExitStatus::success;
};

void add_run_command(CLI::App& app, Session& session);
void add_bottlenecks_command(CLI::App& app, Session& session);
void add_describe_command(CLI::App& app, Session& session);
void add_sweep_command(CLI::App& app, Session& session);
void add_assemble_command(CLI::App& app, Session& session);
void add_what_if_command(CLI::App& app, Session& session);
void add_boxes_command(CLI::App& app, Session& session);
void add_communicate_command(CLI::App& app, Session& session);
void add_triangles_command(CLI::App& app, Session& session);
void add_overlap_command(CLI::App& app, Session& session);
void add_list_command(CLI::App& app, Session& session);

}  // namespace rasterloom::cli
