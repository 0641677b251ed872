// SPDX-License-Identifier: MIT
// `rasterloom`: reads the command line, runs a subcommand, and turns what went wrong into one
// message and an exit status.
#include "isa/diagnostic.hpp"
#include "machine/cli/command.hpp"
#include "machine/config/error.hpp"
#include "machine/observe/output_folder.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace rasterloom::cli {

namespace {

constexpr const char* kFooter =
    "Examples:\n"
    "  rasterloom run configs/geodesic482.yaml --out out/teapot\n"
    "  rasterloom run configs/geodesic482.yaml --set scene.rotate.degrees=30 --frames 3\n"
    "  rasterloom describe configs/geodesic482.yaml\n"
    "\n"
    "Exit status: 0 success; 1 a defect of the emulator; 2 wrong usage, configuration or input;\n"
    "3 the emulated machine failed (guest error, deadlock, time limit).\n"
    "docs/configuration.md describes the YAML files.";

void set_up(CLI::App& app, Session& session) {
    app.name("rasterloom");
    app.set_version_flag("--version", "rasterloom " RASTERLOOM_VERSION);
    app.footer(kFooter);
    app.require_subcommand(1);
    app.fallthrough();
    app.add_option("--data", session.data, "The folder that holds programs/ and configs/")
        ->envname("RASTERLOOM_DATA")
        ->type_name("DIR");
    add_run_command(app, session);
    add_describe_command(app, session);
    add_assemble_command(app, session);
    add_list_command(app, session);
}

// CLI11 only says that a subcommand is missing when the user's is not known.
void check_subcommand(const CLI::App& app, int argc, char** argv) {
    if (argc < 2 || argv[1][0] == '-') {
        return;
    }
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) {
        names.push_back(command->get_name());
    }
    if (std::find(names.begin(), names.end(), argv[1]) == names.end()) {
        config::refuse({"command line", 0, 0}, {}, argv[1], "no such subcommand",
                       fmt::format("one of {}", fmt::join(names, ", ")),
                       config::nearest_name(argv[1], names));
    }
}

int status(ExitStatus value) {
    return static_cast<int>(value);
}

int complain(ExitStatus value, const char* message) {
    fmt::print(stderr, "rasterloom: {}\n", message);
    return status(value);
}

int run(int argc, char** argv) {
    CLI::App app(
        "Emulates parallel rendering machines, instruction by instruction and message by message.");
    Session session;
    set_up(app, session);
    try {
        check_subcommand(app, argc, argv);
        app.parse(argc, argv);
        return status(session.status);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? status(ExitStatus::success) : status(ExitStatus::bad_input);
    } catch (const config::ConfigError& error) {
        return complain(ExitStatus::bad_input, error.what());
    } catch (const observe::OutputError& error) {
        return complain(ExitStatus::bad_input, error.what());
    } catch (const isa::AssemblyError& error) {
        fmt::print(stderr, "{}", error.what());
        return status(ExitStatus::bad_input);
    } catch (const std::exception& error) {
        return complain(ExitStatus::internal_error, error.what());
    }
}

}  // namespace

}  // namespace rasterloom::cli

int main(int argc, char** argv) {
    return rasterloom::cli::run(argc, argv);
}
