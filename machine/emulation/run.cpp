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
    if (const BucketNetwork* buckets = machine.buckets()) {
        add(buckets->sorter);
        std::for_each(buckets->rasterizers.begin(), buckets->rasterizers.end(), add);
        std::for_each(buckets->feeders.begin(), buckets->feeders.end(), add);
    }
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
    if (image.segments.empty()) {
        config::refuse({"--appendix-c", 0, 0}, {}, {}, "the machine runs no program",
                       "a machine that draws polygons with pdp11/tiler.s");
    }
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

// One run, from its configuration to what came of it.
class Run {
  public:
    Run(const MachineDescription& description, const RunOptions& options)
        : description_(description),
          options_(options),
          blueprint_(description, registry_),
          job_(make_job(blueprint_)),
          machine_(blueprint_, job_ ? job_->frames() : HostFrames()),
          phases_(round_of(description.links)) {
        if (job_) {
            load();
        }
        machine_.simulation().use_threads(threads_for(description, machine_));
        names_ = machine_names(blueprint_, machine_);
        observe();
    }

    RunOutcome outcome() {
        execute();
        report_paths();
        report_traces();
        if (options_.page) {
            outcome_.drawing = draw_machine(blueprint_, machine_, outcome_.report.fabric);
        }
        if (appendix_c_) {
            outcome_.appendix_c = gather_appendix_c(*appendix_c_, outcome_.report);
        }
        if (messages_) {
            messages_->close();
        }
        draw_references();
        return std::move(outcome_);
    }

  private:
    void load() {
        job_->load(machine_);
        if (options_.check_communication) {
            job_->check_communication(machine_);
        }
        collector_.emplace(*job_, machine_, outcome_.pictures, outcome_.videos);
        machine_.frame_probe()->attach(*collector_);
        outcome_.remarks = job_->remarks();
        outcome_.background = job_->background();
    }

    void observe() {
        if (options_.messages_csv) {
            messages_.emplace(*options_.messages_csv);
        }
        if (wants_paths(options_, machine_)) {
            paths_.emplace(machine_);
        }
        traces_.emplace(options_.traces, names_, paths_ ? &paths_->causes() : nullptr,
                        options_.bottlenecks);
        if (options_.page) {
            outcome_.timeline.emplace(timeline_subjects(blueprint_, machine_));
        }
        observers_.emplace(
            machine_, phases_,
            Observers::Listeners{.messages = messages_ ? &*messages_ : nullptr,
                                 .timeline = outcome_.timeline ? &*outcome_.timeline : nullptr,
                                 .traces = traces_->sinks(),
                                 .paths = paths_ ? &*paths_ : nullptr});
        if (options_.appendix_c) {
            tap(appendix_c_, options_, *blueprint_.image, blueprint_.topology, machine_);
        }
        if (machine_.lockstep() != nullptr) {
            stopwatch_.emplace(*machine_.lockstep());
        }
    }

    void execute() {
        const auto start = WallClock::now();
        const RunResult result =
            run_in_slices(machine_.simulation(), Time::zero() + description_.run.max_time,
                          observers_->slice(), [this](Time now) { look_between_slices(now); });
        observers_->finish();
        outcome_.wall_seconds = seconds_since(start);
        outcome_.failure = failure_of(result, description_, machine_);
        outcome_.report = gather_report(blueprint_, machine_, phases_, result.time);
        if (stopwatch_) {
            stopwatch_->tell(outcome_.report);
        }
    }

    void look_between_slices(Time now) {
        if (stopwatch_) {
            stopwatch_->stand();
        }
        observers_->catch_up(now);
        if (collector_) {
            collector_->collect();
        }
        if (options_.progress) {
            tell_progress(options_, machine_, description_, now);
        }
        if (stopwatch_) {
            stopwatch_->go();
        }
    }

    void report_paths() {
        if (!paths_) {
            return;
        }
        outcome_.report.paths = paths_->finish(names_, outcome_.report.phases);
        if (options_.bottlenecks && outcome_.failure.empty()) {
            const auto lines = lines_on_paths(blueprint_, job_.get(), machine_, paths_->paths());
            for (std::size_t i = 0; i < lines.size(); ++i) {
                outcome_.report.paths[i].lines = lines[i];
            }
        }
    }

    void report_traces() {
        if (!outcome_.failure.empty()) {
            return;
        }
        observers_->finish();  // what nodes were at when the run ended
        traces_->close(outcome_.report,
                       paths_ ? paths_->paths() : std::vector<observe::CriticalPath>());
        if (options_.bottlenecks) {
            outcome_.bottlenecks = traces_->search();
        }
    }

    void draw_references() {
        if (job_ && options_.reference_pictures) {
            for (std::size_t frame = 0; frame < outcome_.pictures.size(); ++frame) {
                outcome_.references.push_back(job_->reference(static_cast<std::int64_t>(frame)));
            }
        }
    }

    const MachineDescription& description_;
    const RunOptions& options_;
    isa::IsaRegistry registry_ = built_in_isas();
    RunOutcome outcome_;
    const Blueprint blueprint_;
    const std::unique_ptr<HostJob> job_;
    Machine machine_;
    observe::MachineNames names_;
    observe::PhaseLog phases_;
    std::optional<PictureCollector> collector_;
    std::optional<observe::MessageCsv> messages_;
    std::optional<PathCollector> paths_;
    std::optional<Traces> traces_;
    std::optional<Observers> observers_;
    std::optional<AppendixCCollector> appendix_c_;
    std::optional<PhaseStopwatch> stopwatch_;
};

}  // namespace

RunOutcome run_machine(const MachineDescription& description, const RunOptions& options) {
    return Run(description, options).outcome();
}

}  // namespace rasterloom::emulation
