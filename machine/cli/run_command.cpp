// SPDX-License-Identifier: MIT
// rasterloom run: emulates a machine, prints a summary, writes pictures and statistics.
#include "machine/cli/command.hpp"
#include "machine/cli/config_options.hpp"
#include "machine/cli/interruption.hpp"
#include "machine/cli/progress_bar.hpp"
#include "machine/cli/trace_options.hpp"
#include "machine/config/error.hpp"
#include "machine/emulation/run.hpp"
#include "machine/emulation/wiring.hpp"
#include "machine/host/animation.hpp"
#include "machine/host/png.hpp"
#include "machine/node/lockstep/lockstep_array.hpp"
#include "machine/observe/appendix_c/appendix_c_files.hpp"
#include "machine/observe/appendix_c/appendix_c_text.hpp"
#include "machine/observe/output_folder.hpp"
#include "machine/observe/page/report_page.hpp"
#include "machine/observe/statistics_files.hpp"
#include "machine/observe/summary.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace rasterloom::cli {

namespace {

constexpr int kMatchLevels = 2;   // grey levels within which a pixel counts as the same
constexpr int kFrameDelay = 100;  // milliseconds a frame of the animation

struct RunCommandOptions {
    ConfigOptions config;
    std::string out;
    bool compare = false;
    bool check_communication = false;
    bool bottlenecks = false;
    bool report = false;
    TraceOptions trace;
    std::string vectors;
    std::string appendix_c;  // "table", "all" or names of processors; empty: none
    bool no_files = false;
    bool quiet = false;
};

void write_pictures(const emulation::RunOutcome& outcome, const observe::OutputFolder& folder) {
    for (std::size_t frame = 0; frame < outcome.pictures.size(); ++frame) {
        host::write_png(folder.file(fmt::format("frame-{:03}.png", frame)),
                        outcome.pictures[frame]);
    }
    for (std::size_t frame = 0; frame < outcome.videos.size(); ++frame) {
        host::write_png(folder.file(fmt::format("video-{:03}.png", frame)), outcome.videos[frame]);
    }
    for (std::size_t frame = 0; frame < outcome.references.size(); ++frame) {
        host::write_png(folder.file(fmt::format("reference-{:03}.png", frame)),
                        outcome.references[frame]);
    }
    if (outcome.pictures.size() > 1) {
        host::write_apng(folder.file("frames.png"), outcome.pictures, kFrameDelay);
    }
}

void write_statistics(const emulation::RunOutcome& outcome, const observe::OutputFolder& folder) {
    observe::write_file_whole(folder.file("statistics.json"),
                              observe::statistics_json(outcome.report));
    observe::write_file_whole(folder.file("nodes.csv"), observe::nodes_csv(outcome.report));
    if (outcome.report.array) {
        observe::write_file_whole(folder.file("procedures.csv"),
                                  observe::procedures_csv(*outcome.report.array));
    }
    if (outcome.report.buckets) {
        observe::write_file_whole(folder.file("rasterizers.csv"),
                                  observe::rasterizers_csv(*outcome.report.buckets));
    }
    if (outcome.report.fabric.empty()) {
        observe::write_file_whole(folder.file("links.csv"), observe::links_csv(outcome.report));
    } else {
        observe::write_file_whole(
            folder.file("fabric.csv"),
            observe::fabric_csv(outcome.report.fabric, outcome.report.end.since_start()));
    }
    if (outcome.appendix_c) {
        observe::write_file_whole(folder.file("appendix-c.json"),
                                  observe::appendix_c_json(*outcome.appendix_c));
        observe::write_file_whole(folder.file("appendix-c.csv"),
                                  observe::appendix_c_csv(*outcome.appendix_c));
    }
    if (outcome.timeline) {
        observe::write_file_whole(folder.file("report.html"),
                                  observe::report_page({outcome.report, *outcome.timeline,
                                                        outcome.drawing, outcome.pictures}));
    }
}

void print_comparison(const emulation::RunOutcome& outcome) {
    for (std::size_t frame = 0; frame < outcome.references.size(); ++frame) {
        const host::PictureComparison same =
            host::compare(outcome.pictures[frame], outcome.references[frame], outcome.background);
        fmt::print(
            "Frame {:<3}       {:.3f} % of all pixels and {:.3f} % of the object's within {} "
            "levels of the reference; {} pixels differ; greatest difference {}\n",
            frame, 100 * same.all.share_within(kMatchLevels),
            100 * same.covered.share_within(kMatchLevels), kMatchLevels, same.all.differing(),
            same.all.greatest());
    }
}

constexpr const char* kTable = "table";  // --appendix-c without a value
constexpr const char* kAll = "all";

// The processors that are to be shown in full.
std::vector<std::string> asked_for(const std::string& appendix_c) {
    std::vector<std::string> names;
    std::istringstream text(appendix_c);
    for (std::string name; std::getline(text, name, ',');) {
        if (name != kTable && name != kAll) {
            names.push_back(name);
        }
    }
    return names;
}

void print_appendix_c(const RunCommandOptions& options, const observe::AppendixCReport& report) {
    fmt::print("\n{}", observe::appendix_c_table(report));
    const std::vector<std::string> names = asked_for(options.appendix_c);
    for (const observe::AppendixCNode& node : report.nodes) {
        if (options.appendix_c == kAll ||
            std::find(names.begin(), names.end(), node.name) != names.end()) {
            fmt::print("\n{}", observe::appendix_c_of(node));
        }
    }
}

std::filesystem::path output_folder(const RunCommandOptions& options) {
    if (!options.out.empty()) {
        return options.out;
    }
    return std::filesystem::path("out") / std::filesystem::path(options.config.file).stem();
}

void print_outcome(const RunCommandOptions& options, const emulation::RunOutcome& outcome) {
    if (!options.quiet) {
        fmt::print("{}", observe::summary(outcome.report, outcome.wall_seconds));
        if (!outcome.remarks.empty()) {
            fmt::print("\n{}\n", outcome.remarks);
        }
    }
    if (options.bottlenecks) {
        fmt::print("\n{}", observe::bottlenecks_text(*outcome.bottlenecks));
    }
    if (outcome.appendix_c) {
        print_appendix_c(options, *outcome.appendix_c);
    }
    if (options.compare) {
        print_comparison(outcome);
    }
}

// Throws ConfigError for options that do not go together.
void check_options(const RunCommandOptions& options, const config::MachineDescription& machine) {
    if (options.compare && !machine.scene) {
        config::refuse({"--compare", 0, 0}, {}, {}, "nothing is drawn without a scene",
                       "a machine with a scene");
    }
    if (options.check_communication && !(machine.scene && emulation::is_lockstep(machine))) {
        config::refuse({"--check-communication", 0, 0}, {}, {},
                       "no polygons go from lane to lane here",
                       "a machine of lanes (nodes.isa vliw) with a scene");
    }
    if (options.report && options.no_files) {
        config::refuse({"--report", 0, 0}, {}, {}, "the report is a file",
                       "a run without --no-files");
    }
    if (options.report && !observe::page_template()) {
        config::refuse({"--report", 0, 0}, {}, {}, "this program was built without the report",
                       "a build with the CMake option RASTERLOOM_REPORT=ON");
    }
}

void use_vectors(const std::string& name) {
    const std::vector<std::string> paths = LockstepArray::paths();
    if (std::find(paths.begin(), paths.end(), name) == paths.end()) {
        config::refuse({"--vectors", 0, 0}, {}, name, "this host has no such vector instructions",
                       fmt::format("one of {}", fmt::join(paths, ", ")));
    }
    LockstepArray::use_path(name);
}

void run(const RunCommandOptions& options, Session& session) {
    const config::MachineDescription machine = load(options.config, session);
    check_options(options, machine);
    if (!options.vectors.empty()) {
        use_vectors(options.vectors);
    }
    emulation::RunOptions run_options;
    run_options.traces = to_run(options.trace);
    std::optional<observe::OutputFolder> folder;
    std::optional<Interruption> interruption;  // ends before the folder does
    if (!options.no_files) {
        interruption.emplace([&] { folder.emplace(output_folder(options)); },
                             [&folder] { folder->abandon(); });
        run_options.messages_csv = folder->file("messages.csv");
    }
    run_options.reference_pictures = options.compare;
    run_options.check_communication = options.check_communication;
    run_options.bottlenecks = options.bottlenecks;
    run_options.page = options.report;
    run_options.appendix_c = !options.appendix_c.empty();
    run_options.appendix_c_of = asked_for(options.appendix_c);
    ProgressBar bar(!options.quiet);
    if (bar.visible()) {
        run_options.progress = [&bar](const emulation::Progress& progress) { bar.show(progress); };
    }
    const emulation::RunOutcome outcome = emulation::run_machine(machine, run_options);
    bar.clear();
    if (!outcome.failure.empty()) {
        fmt::print(stderr, "rasterloom: {}\n", outcome.failure);
        session.status = ExitStatus::guest_error;
        return;
    }
    if (folder) {
        write_pictures(outcome, *folder);
        write_statistics(outcome, *folder);
        folder->commit();
    }
    print_outcome(options, outcome);
    if (folder && !options.quiet) {
        fmt::print("\nFiles in {}\n", folder->final_folder().string());
    }
}

}  // namespace

void add_run_command(CLI::App& app, Session& session) {
    auto options = std::make_shared<RunCommandOptions>();
    CLI::App* command = app.add_subcommand("run",
                                           "Emulate a machine: pictures, statistics.json, "
                                           "nodes.csv, links.csv, messages.csv and a summary");
    add_config_options(*command, options->config);
    command->add_option("--frames", options->config.frames, "Draw so many frames: run.frames")
        ->type_name("N");
    command
        ->add_option("--max-time", options->config.max_time,
                     "Give up after so much machine time: run.max_time")
        ->type_name("TIME");
    command
        ->add_option("--threads", options->config.threads,
                     "Emulate on so many threads, or auto; changes no result: run.threads")
        ->type_name("N");
    command
        ->add_option(
            "--vectors", options->vectors,
            "Emulate the lanes of an array by these vector instructions, such as AVX2, not "
            "by the best that the host has; changes no result")
        ->type_name("NAME");
    command
        ->add_option("--out", options->out,
                     "Folder for the files; default: out/ and the configuration's name")
        ->type_name("DIR");
    command->add_flag("--no-files", options->no_files, "Write no files");
    command->add_flag("--compare", options->compare,
                      "Compare each picture with the reference renderer's");
    command->add_flag("--check-communication", options->check_communication,
                      "Lanes: check after each communication that every polygon is on every lane "
                      "that needs it, on no other, on none twice");
    add_trace_options(*command, options->trace);
    command->add_flag("--bottlenecks", options->bottlenecks,
                      "Print what limits the machine: the critical path of each frame down to the "
                      "program's lines (also in statistics.json), load, who waited for whom");
    command->add_flag("--report", options->report,
                      "Write report.html: the run to look at in a browser, in one file");
    command->add_flag(
        "--appendix-c{table}", options->appendix_c,
        "Statistics of every processor as in Parks' appendix C: a table, appendix-c.json and "
        "appendix-c.csv. --appendix-c=P3,P7 and --appendix-c=all print all data of processors");
    command->add_flag("--quiet", options->quiet, "No summary, no progress bar");
    command->callback([options, &session] { run(*options, session); });
}

}  // namespace rasterloom::cli
