// SPDX-License-Identifier: MIT
// The part of the command line that names a configuration and changes it: shared by run and
// describe.
#pragma once

#include "machine/cli/command.hpp"
#include "machine/config/description.hpp"
#include "machine/config/value.hpp"

#include <string>
#include <vector>

namespace rasterloom::cli {

struct ConfigOptions {
    std::string file;
    std::vector<std::string> overrides;  // --set
    std::string mesh;
    std::string frames;
    std::string max_time;
    std::string threads;
};

// `options` must outlive the parsing.
void add_config_options(CLI::App& command, ConfigOptions& options);

// --machine FILE, for a group of which the user gives one, and --set: for commands that take what a
// machine draws. Returns the former. `options` must outlive the parsing.
CLI::Option* add_machine_source(CLI::App& command, CLI::App& group, ConfigOptions& options,
                                const std::string& summary);

// Throws config::ConfigError.
config::MachineDescription load(const ConfigOptions& options, const Session& session);
// With one more change.
config::MachineDescription load(const ConfigOptions& options, const Session& session,
                                const config::Override& change);

}  // namespace rasterloom::cli
