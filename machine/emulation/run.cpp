// SPDX-License-Identifier: MIT
#include "machine/emulation/run.hpp"

#include "machine/config/error.hpp"
#include "machine/emulation/appendix_c_collector.hpp"
#include "machine/emulation/drawing.hpp"
#include "machine/emulation/job.hpp"
#include "machine/emulation/machine.hpp"
#include "machine/emulation/names.hpp"
#include "machine/emulation/observers.hpp"
#include "machine/emulation/path_collector.hpp"
#include "machine/emulation/path_lines.hpp"
#include "machine/emulation/phase_stopwatch.hpp"
#include "machine/emulation/programs.hpp"
#include "machine/emulation/report.hpp"
#include "machine/emulation/slices.hpp"
#include "machine/emulation/threads.hpp"
#include "machine/observe/message_csv.hpp"
#include "machine/observe/phase_log.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::emulation {

using config::MachineDescription;

namespace {

using WallClock = std::chrono::steady_clock;

double seconds_since(WallClock::time_point start) {
    return std::chrono::duration<double>(WallClock::now() - start).count();
}

// Reads the picture at the very end of each frame, before the next one begins, or when the video
// has shown it: supervisor and sequencer make the run pause there.
class PictureCollector final : public SupervisorListener {
  public:
    PictureCollector(HostJob& job, Machine& machine, std::vector<host::Picture>& pictures,
                     std::vector<host::Picture>& videos)
        : job_(job), machine_(machine), pictures_(pictures), videos_(videos) {}
    void frame_ended(int, Time) override { due_ = true; }
    void collect() {
        if (std::exchange(due_, false)) {
            ++frames_;
            job_.frame_ended(machine_, frames_ - 1);
        }
        const std::int64_t visible =
            job_.has_video(machine_) ? machine_.lockstep()->pictures_shown() : frames_;
        if (visible > static_cast<std::int64_t>(pictures_.size())) {
            pictures_.push_back(job_.collect(machine_));
            if (std::optional<host::Picture> video = job_.video(machine_)) {
                videos_.push_back(std::move(*video));
            }
        }
    }

  private:
    HostJob& job_;
    Machine& machine_;
    std::vector<host::Picture>& pictures_;
    std::vector<host::Picture>& videos_;
    std::int64_t frames_ = 0;  // ended
    bool due_ = false;
};

// Messages take one fixed time when their bytes take none: the phases then have rounds.
std::optional<Duration> round_of(const config::LinkDescription& links) {
    const bool fixed = links.time_per_byte == Duration() && links.time_per_message > Duration();
    return fixed ? std::optional(links.time_per_message) : std::nullopt;
}

void tell_progress(const RunOptions& options, const Machine& machine,
                   const MachineDescription& description, Time now) {
    Progress progress{.now = now,
                      .frame = 0,
                      .frames = description.run.frames,
                      .phase = 0,
                      .phases = machine.phases_per_frame()};
    if (const Supervisor* supervisor = machine.supervisor()) {
        progress.frame = std::min<std::int64_t>(supervisor->phase().frame, progress.frames - 1);
        progress.phase = supervisor->phase().phase;
    }
    if (const LockstepMachine* lockstep = machine.lockstep()) {
        progress.frame = std::min<std::int64_t>(lockstep->phase().frame, progress.frames - 1);
        progress.phase = lockstep->phase().phase;
    }
    options.progress(progress);
}

// A deadlock of thousands of nodes names the first waiting ones and counts the rest.
std::string first_lines(const std::string& text) {
    constexpr int kShown = 24;
    std::size_t end = 0;
    for (int line = 0; line < kShown; ++line) {
        const std::size_t newline = text.find('\n', end);
        if (newline == std::string::npos) {
            return text;
        }
        end = newline + 1;
    }
    const auto rest =
        1 + std::count(text.begin() + static_cast<std::ptrdiff_t>(end), text.end(), '\n');
    return fmt::format("{}  and {} more", text.substr(0, end), rest);
}

// What everybody is at who has not finished.
std::string activities(const Machine& machine) {
    std::string text;
    for (const Processor* processor : machine.processors()) {
        if (const auto activity = processor->activity()) {
            text += "\n  " + *activity;
        }
    }
    if (const LockstepMachine* lockstep = machine.lockstep()) {
        text += "\n  " + lockstep->activity();
    }
    const auto add = [&text](const Component* component) {
        if (component == nullptr) {
            return;
        }
        if (const auto waits = component->waits_for()) {
            text += fmt::format("\n  {} waits for {}", component->name(), *waits);
        }
    };
    add(machine.supervisor());
    if (const PolygonNetwork* fabric = machine.fabric()) {
        add(fabric->source);
        std::for_each(fabric->splitters.begin(), fabric->splitters.end(), add);
        std::for_each(fabric->buses.begin(), fabric->buses.end(), add);
    }
    return text;
}

std::string failure_of(const RunResult& result, const MachineDescription& description,
                       const Machine& machine) {
    if (result.end == RunEnd::failed) {
        return first_lines(result.failure->message());
    }
    if (result.end == RunEnd::limit) {
        return first_lines(fmt::format(
            "the machine has not finished after {} of its time (run.max_time, --max-time){}",
            config::format_duration(description.run.max_time), activities(machine)));
    }
    return {};
}

void tap(std::optional<AppendixCCollector>& collector, const RunOptions& options,
         const isa::Image& image, const topology::Topology& topology, const Machine& machine) {
    std::vector<std::string> names;
    for (const topology::Node& node : topology.nodes) {
        names.push_back(node.name);
    }
    for (const std::string& name : options.appendix_c_of) {
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            config::refuse({"--appendix-c", 0, 0}, {}, name, "no such processor",
                           "names as `rasterloom describe` shows them, or all",
                           config::nearest_name(name, names));
        }
    }
    try {
        collector.emplace(image, machine.processors());
    } catch (const std::invalid_argument& error) {
        config::refuse({"--appendix-c", 0, 0}, {}, {}, error.what(),
                       "a machine that draws polygons with pdp11/tiler.s");
    }
}

bool wants_paths(const RunOptions& options, const Machine& machine) {
    if ((options.paths || options.bottlenecks) && machine.frame_probe() == nullptr) {
        config::refuse({options.bottlenecks ? "--bottlenecks" : "critical path", 0, 0}, {}, {},
                       "a bare processor has no frames",
                       "a machine with several processors or a scene");
    }
    const bool for_trace =
        std::any_of(options.traces.paths.begin(), options.traces.paths.end(),
                    [](const auto& path) { return kind_of_trace(path) == TraceKind::sqlite; });
    return options.paths || options.bottlenecks ||
           ((for_trace || options.page) && machine.frame_probe() != nullptr);
}

observe::AppendixCReport gather_appendix_c(AppendixCCollector& collector,
                                           const observe::RunReport& report) {
    std::vector<std::string> names;
    for (const observe::NodeReport& node : report.nodes) {
        names.push_back(node.name);
    }
    return collector.finish(report.machine, names);
}

}  // namespace

RunOutcome run_machine(const MachineDescription& description, const RunOptions& options) {
    isa::IsaRegistry registry = built_in_isas();
    const Blueprint blueprint(description, registry);
    const std::unique_ptr<HostJob> job = make_job(blueprint);
    Machine machine(blueprint, job ? job->polygons() : std::vector<std::vector<Polygon>>());
    RunOutcome outcome;
    std::optional<PictureCollector> collector;
    if (job) {
        job->load(machine);
        if (options.check_communication) {
            job->check_communication(machine);
        }
        collector.emplace(*job, machine, outcome.pictures, outcome.videos);
        machine.frame_probe()->attach(*collector);
        outcome.remarks = job->remarks();
        outcome.background = job->background();
    }
    observe::PhaseLog phases(round_of(description.links));
    std::optional<observe::MessageCsv> messages;
    if (options.messages_csv) {
        messages.emplace(*options.messages_csv);
    }
    machine.simulation().use_threads(threads_for(description, machine));
    std::optional<PathCollector> paths;
    if (wants_paths(options, machine)) {
        paths.emplace(machine);
    }
    const observe::MachineNames names = machine_names(blueprint, machine);
    Traces traces(options.traces, names, paths ? &paths->causes() : nullptr, options.bottlenecks);
    if (options.page) {
        outcome.timeline.emplace(timeline_subjects(blueprint, machine));
    }
    Observers observers(machine, phases,
                        {.messages = messages ? &*messages : nullptr,
                         .timeline = outcome.timeline ? &*outcome.timeline : nullptr,
                         .traces = traces.sinks(),
                         .paths = paths ? &*paths : nullptr});
    std::optional<AppendixCCollector> appendix_c;
    if (options.appendix_c) {
        tap(appendix_c, options, *blueprint.image, blueprint.topology, machine);
    }

    std::optional<PhaseStopwatch> stopwatch;
    if (machine.lockstep() != nullptr) {
        stopwatch.emplace(*machine.lockstep());
    }
    const auto start = WallClock::now();
    const RunResult result =
        run_in_slices(machine.simulation(), Time::zero() + description.run.max_time,
                      observers.slice(), [&](Time now) {
                          if (stopwatch) {
                              stopwatch->stand();
                          }
                          observers.catch_up(now);
                          if (collector) {
                              collector->collect();
                          }
                          if (options.progress) {
                              tell_progress(options, machine, description, now);
                          }
                          if (stopwatch) {
                              stopwatch->go();
                          }
                      });
    observers.finish();
    outcome.wall_seconds = seconds_since(start);

    outcome.failure = failure_of(result, description, machine);
    outcome.report = gather_report(blueprint, machine, phases, result.time);
    if (stopwatch) {
        stopwatch->tell(outcome.report);
    }
    if (paths) {
        outcome.report.paths = paths->finish(names, outcome.report.phases);
        if (options.bottlenecks && outcome.failure.empty()) {
            const auto lines = lines_on_paths(blueprint, job.get(), machine, paths->paths());
            for (std::size_t i = 0; i < lines.size(); ++i) {
                outcome.report.paths[i].lines = lines[i];
            }
        }
    }
    if (outcome.failure.empty()) {
        observers.finish();  // what nodes were at when the run ended
        traces.close(outcome.report, paths ? paths->paths() : std::vector<observe::CriticalPath>());
        if (options.bottlenecks) {
            outcome.bottlenecks = traces.search();
        }
    }
    if (options.page) {
        outcome.drawing = draw_machine(blueprint, outcome.report.fabric);
    }
    if (appendix_c) {
        outcome.appendix_c = gather_appendix_c(*appendix_c, outcome.report);
    }
    if (messages) {
        messages->close();
    }
    if (job && options.reference_pictures) {
        for (std::int64_t frame = 0; frame < static_cast<std::int64_t>(outcome.pictures.size());
             ++frame) {
            outcome.references.push_back(job->reference(frame));
        }
    }
    return outcome;
}

}  // namespace rasterloom::emulation
