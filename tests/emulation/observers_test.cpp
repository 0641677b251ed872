// SPDX-License-Identifier: MIT
// What a machine does is told on a thread of its own, which may be slow, and may fail.
#include "machine/emulation/observers.hpp"

#include "machine/emulation/job.hpp"
#include "machine/emulation/programs.hpp"
#include "machine/emulation/slices.hpp"
#include "machine/observe/output_folder.hpp"
#include "tests/emulation/machines.hpp"

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace rasterloom::emulation {
namespace {

class Scribe : public observe::TraceSink {
  public:
    void interval_ended(const StateInterval& interval) override {
        note("node " + std::to_string(interval.node), interval.to);
    }
    void message_consumed(const MessageRecord& message) override {
        note("message " + std::to_string(message.id), message.consumed);
    }
    void phase_ended(const PhaseRecord& phase) override { note("phase", phase.ended); }
    void close(const observe::RunReport&, const std::vector<observe::CriticalPath>&) override {}

    std::vector<std::string> told;
    std::thread::id thread;

  protected:
    virtual void note(const std::string& what, Time time) {
        told.push_back(what + " at " + std::to_string(time.picoseconds()));
        thread = std::this_thread::get_id();
    }
};

class SlowScribe final : public Scribe {
    void note(const std::string& what, Time time) override {
        if (told.size() % 500 == 0) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        Scribe::note(what, time);
    }
};

class FullDisk final : public Scribe {
    void note(const std::string& what, Time time) override {
        Scribe::note(what, time);
        if (told.size() == 100) {
            throw observe::OutputError("trace: no room");
        }
    }
};

// Runs the machine; says how far it has come.
Time observe_run(Scribe& scribe, std::int64_t threads, std::int64_t frames = 2) {
    config::MachineDescription description = small_geodesic();
    description.run.frames = frames;
    isa::IsaRegistry registry = built_in_isas();
    const Blueprint blueprint(description, registry);
    const std::unique_ptr<HostJob> job = make_job(blueprint);
    Machine machine(blueprint, job->frames());
    job->load(machine);
    machine.simulation().use_threads(static_cast<std::size_t>(threads));
    observe::PhaseLog phases(std::nullopt);
    Observers observers(machine, phases, {.traces = {&scribe}});
    Time reached;
    try {
        run_in_slices(machine.simulation(), Time::zero() + description.run.max_time, kObservedSlice,
                      [&](Time now) {
                          observers.catch_up(now);
                          reached = now;
                      });
        observers.finish();
    } catch (const observe::OutputError& error) {
        EXPECT_STREQ(error.what(), "trace: no room");
    }
    return reached;
}

TEST(Observers, AreToldTheSameInTheSameOrderHoweverSlowTheyAre) {
    Scribe quick;
    const Time end = observe_run(quick, 1);
    ASSERT_GT(quick.told.size(), 1000U);
    EXPECT_NE(quick.thread, std::this_thread::get_id());
    for (const std::int64_t threads : {1, 2}) {
        SlowScribe slow;
        EXPECT_EQ(observe_run(slow, threads), end);
        EXPECT_TRUE(slow.told == quick.told) << threads << " threads";
    }
}

TEST(Observers, ThatFailEndTheRunWithTheirWords) {
    Scribe whole;
    FullDisk full;
    const Time end = observe_run(whole, 1, 4);
    EXPECT_LT(observe_run(full, 1, 4), end);
    EXPECT_EQ(full.told.size(), 100U);
}

}  // namespace
}  // namespace rasterloom::emulation
