// SPDX-License-Identifier: MIT
// rasterloom sweep: runs many machines, writes one row for each.
#include "machine/cli/command.hpp"
#include "machine/cli/progress_bar.hpp"
#include "machine/config/error.hpp"
#include "machine/config/sweep.hpp"
#include "machine/emulation/process_workers.hpp"
#include "machine/emulation/rank_workers.hpp"
#include "machine/emulation/sweep.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include <fmt/format.h>

namespace rasterloom::cli {

namespace {

constexpr std::size_t kMostWorkers = 1024;

struct SweepCommandOptions {
    std::string file;
    std::string out;
    std::size_t workers = 0;  // 0: as many as cores, with --mpi one a rank
    bool mpi = false;
    bool fresh = false;
    bool retry_failed = false;
    bool quiet = false;
};

std::filesystem::path output_folder(const SweepCommandOptions& options,
                                    const config::SweepDescription& sweep) {
    if (!options.out.empty()) {
        return options.out;
    }
    return sweep.out ? std::filesystem::path(*sweep.out)
                     : std::filesystem::path("out") / std::filesystem::path(options.file).stem();
}

std::size_t worker_count(const SweepCommandOptions& options,
                         const config::SweepDescription& sweep) {
    const std::size_t cores = std::max<std::size_t>(1, std::thread::hardware_concurrency());
    const std::size_t usual = options.mpi ? 1 : cores;
    return std::min(options.workers != 0 ? options.workers : usual, sweep.size());
}

void print_outcome(const emulation::SweepProgress& outcome, const std::filesystem::path& folder) {
    fmt::print("{} point{}, {} of them run now in {:.1f} s, {} failed\n", outcome.points,
               outcome.points == 1 ? "" : "s", outcome.points - outcome.before, outcome.seconds,
               outcome.failed);
    if (outcome.failed > 0) {
        fmt::print("Why: sqlite3 {} \"SELECT key, error FROM points WHERE status = 'failed'\"\n",
                   (folder / "results.sqlite").string());
    }
    fmt::print("results.sqlite and results.csv in {}\n", folder.string());
}

void run_with(emulation::PointWorkers& workers, const SweepCommandOptions& options,
              const config::SweepDescription& sweep, const config::Locator& locator) {
    emulation::SweepOptions sweep_options;
    sweep_options.folder = output_folder(options, sweep);
    sweep_options.fresh = options.fresh;
    sweep_options.retry_failed = options.retry_failed;
    ProgressBar bar(!options.quiet);
    if (bar.visible()) {
        sweep_options.progress = [&bar](const emulation::SweepProgress& progress) {
            bar.show(progress);
        };
    }
    const emulation::SweepProgress outcome =
        emulation::run_sweep(sweep, locator, workers, sweep_options);
    bar.clear();
    if (!options.quiet) {
        print_outcome(outcome, sweep_options.folder);
    }
}

// What every process of a sweep makes before anything is opened and before ranks meet: the workers
// are copies of it.
struct Preparation {
    Preparation(const SweepCommandOptions& options, const config::Locator& locator)
        : sweep(config::load_sweep(options.file, locator)),
          workers(worker_count(options, sweep), emulation::sweep_task(sweep, locator)) {}

    config::SweepDescription sweep;
    emulation::ProcessWorkers workers;
};

void run_as_a_rank(const SweepCommandOptions& options, const config::Locator& locator) {
    if (!emulation::has_mpi()) {
        config::refuse({"--mpi", 0, 0}, {}, {}, "not in this build",
                       "one that was configured where OpenMPI is, with RASTERLOOM_MPI=ON");
    }
    std::optional<Preparation> prepared;
    std::optional<config::ConfigError> fault;
    try {
        prepared.emplace(options, locator);
    } catch (const config::ConfigError& error) {
        fault = error;  // most likely every rank's: one is to say it
    }
    const bool is_to_say_it = emulation::run_on_ranks(
        prepared ? &prepared->workers : nullptr,
        [&](emulation::PointWorkers& all) { run_with(all, options, prepared->sweep, locator); });
    if (is_to_say_it && fault) {
        throw config::ConfigError(*fault);
    }
}

void run(const SweepCommandOptions& options, const Session& session) {
    const config::Locator locator = config::make_locator(session.data);
    if (options.mpi) {
        run_as_a_rank(options, locator);
        return;
    }
    Preparation prepared(options, locator);
    run_with(prepared.workers, options, prepared.sweep, locator);
}

}  // namespace

void add_sweep_command(CLI::App& app, Session& session) {
    auto options = std::make_shared<SweepCommandOptions>();
    CLI::App* command = app.add_subcommand(
        "sweep",
        "Run the product of machines, scenes and values: results.sqlite and results.csv. Started "
        "again, it goes on with what is missing; docs/sweep.md");
    command
        ->add_option("sweep", options->file,
                     "What to run; looked for here, then in configs/, such as sweeps/fifos.yaml")
        ->required()
        ->type_name("FILE");
    command
        ->add_option("--out", options->out,
                     "Folder for the files; default: the sweep's, else out/ and its name")
        ->type_name("DIR");
    command
        ->add_option("--workers", options->workers,
                     "Run so many points side by side; default: as many as the host has cores")
        ->check(CLI::Range(std::size_t{1}, kMostWorkers))
        ->type_name("N");
    command->add_flag(
        "--mpi", options->mpi,
        "This is a rank of an MPI job (mpirun, srun): all ranks run points, --workers "
        "each (default: 1), and the first writes the files");
    command->add_flag("--fresh", options->fresh, "Forget the results that are there");
    command->add_flag("--retry-failed", options->retry_failed, "Run failed points once more");
    command->add_flag("--quiet", options->quiet, "No summary, no progress bar");
    command->callback([options, &session] { run(*options, session); });
}

}  // namespace rasterloom::cli
