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
    "      (each frame turns by 30 degrees; the machine does the rotating)\n"
    "  rasterloom run configs/geodesic482.yaml --set scene.rotate.start=180\n"
    "      (the first frame is turned by 180 degrees already)\n"
    "  rasterloom describe configs/geodesic482.yaml\n"
    "  rasterloom run configs/geodesic482.yaml --report\n"
    "      (report.html: all of it to look at in a browser)\n"
    "  rasterloom run configs/geodesic482.yaml --bottlenecks\n"
    "  rasterloom run configs/geodesic482.yaml --trace teapot.sqlite\n"
    "  rasterloom bottlenecks teapot.sqlite\n"
    "  rasterloom whatif configs/geodesic482.yaml --vary nodes.clock=x0.5,x2 --vary "
    "links.latency=x10\n"
    "      (what the frame time is made of, and what would change it)\n"
    "  rasterloom run configs/splitter16.yaml --set fabric.ideal=true --compare\n"
    "      (Parks' machine of 16 processors, as the thesis assumes it)\n"
    "  rasterloom sweep configs/sweeps/fifos.yaml\n"
    "      (many runs: results.sqlite and results.csv; docs/sweep.md)\n"
    "  rasterloom boxes --object teapot --out teapot.boxes\n"
    "  rasterloom communicate teapot.boxes --strides 16,1\n"
    "      (what a ring of 1024 processors spends on sorting polygons; docs/ring-model.md)\n"
    "  rasterloom triangles --object teapot --out teapot.triangles\n"
    "  rasterloom overlap teapot.triangles --tile 8,16,32\n"
    "      (how many tiles a triangle overlaps; docs/overlap.md)\n"
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
        ->check(CLI::ExistingDirectory)
        ->type_name("DIR");
    add_run_command(app, session);
    add_describe_command(app, session);
    add_bottlenecks_command(app, session);
    add_sweep_command(app, session);
    add_assemble_command(app, session);
    add_what_if_command(app, session);
    add_boxes_command(app, session);
    add_communicate_command(app, session);
    add_triangles_command(app, session);
    add_overlap_command(app, session);
    add_list_command(app, session);
}

// CLI11 only says that a subcommand is missing when the user's is not known.
void check_subcommand(const CLI::App& app, const std::vector<std::string>& words) {
    const std::vector<const CLI::App*> commands = app.get_subcommands({});
    if (commands.empty() || (!words.empty() && words[0].starts_with('-'))) {
        return;
    }
    std::vector<std::string> names;
    for (const CLI::App* command : commands) {
        names.push_back(command->get_name());
    }
    const std::string expected = fmt::format("one of {}", fmt::join(names, ", "));
    if (words.empty()) {
        config::refuse({"command line", 0, 0}, {}, {}, "a subcommand is missing",
                       expected + "; --help explains them");
    }
    const auto known = std::find(names.begin(), names.end(), words[0]);
    if (known == names.end()) {
        config::refuse({"command line", 0, 0}, {}, words[0], "no such subcommand", expected,
                       config::nearest_name(words[0], names));
    }
    check_subcommand(*commands[static_cast<std::size_t>(known - names.begin())],
                     {words.begin() + 1, words.end()});
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
        check_subcommand(app, {argv + 1, argv + argc});
        app.parse(argc, argv);
        return status(session.status);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0) {
            return complain(
                ExitStatus::bad_input,
                fmt::format("command line: {}; --help explains it", error.what()).c_str());
        }
        return app.exit(error);  // --help, --version
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
