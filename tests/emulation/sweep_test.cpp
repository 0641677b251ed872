// SPDX-License-Identifier: MIT
#include "machine/emulation/sweep.hpp"

#include "machine/emulation/process_workers.hpp"
#include "machine/emulation/sweep_point.hpp"
#include "machine/observe/output_folder.hpp"
#include "machine/observe/sweep/folder_lock.hpp"
#include "tests/temporary_folder.hpp"

#include <csignal>
#include <deque>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::emulation {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// In this process, one point at a time; counts them.
class WorkersInPlace final : public PointWorkers {
  public:
    explicit WorkersInPlace(PointTask task) : task_(std::move(task)) {}
    std::size_t idle() const override { return started_.empty() ? 1 : 0; }
    void start(std::size_t point) override { started_.push_back(point); }
    std::vector<FinishedPoint> wait(std::chrono::milliseconds) override {
        std::vector<FinishedPoint> finished;
        for (const std::size_t point : started_) {
            ran.push_back(point);
            finished.push_back({point, task_(point), {}});
        }
        started_.clear();
        return finished;
    }

    std::vector<std::size_t> ran;

  private:
    PointTask task_;
    std::deque<std::size_t> started_;
};

class SweepOfRings : public testing::Test {
  protected:
    static inline const std::string kSweep =
        "configs: [ring.yaml, nowhere.yaml]\n"
        "vary: { links.latency: [1us, 2us], topology.nodes: [1, 4, 8] }\n";

    config::SweepDescription sweep(const std::string& text = kSweep) const {
        return config::read_sweep(text, "sweep.yaml", locator_);
    }

    // Which points were run.
    std::vector<std::size_t> run(const config::SweepDescription& sweep,
                                 const std::function<void(SweepOptions&)>& change = {}) {
        WorkersInPlace workers(sweep_task(sweep, locator_));
        SweepOptions options;
        options.folder = folder_.path() / "out";
        if (change) {
            change(options);
        }
        outcome_ = run_sweep(sweep, locator_, workers, options);
        return workers.ran;
    }

    std::string csv() const {
        std::ifstream file(folder_.path() / "out/results.csv", std::ios::binary);
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }

    config::Locator locator_{RASTERLOOM_SOURCE_DIR};
    TemporaryFolder folder_;
    SweepProgress outcome_;
};

TEST_F(SweepOfRings, WritesDownWhatFailsAndGoesOn) {
    EXPECT_EQ(run(sweep()).size(), 12U);
    // All of the file that is not there, and rings of one node.
    EXPECT_EQ(outcome_.failed, 8U);
    EXPECT_THAT(csv(), HasSubstr("failed,sweep.yaml:1:22: configs: no such file (looked in"));
    EXPECT_THAT(csv(), HasSubstr("topology.kind: ring: nodes = 1: expected 2 to"));
    EXPECT_THAT(csv(),
                HasSubstr("ring.yaml links.latency=2us topology.nodes=8,ring.yaml,,2us,8,done,,"));
}

TEST_F(SweepOfRings, RunsOnlyWhatIsMissing) {
    run(sweep("configs: [ring.yaml]\nvary: { links.latency: [1us], topology.nodes: [4, 8] }\n"));
    EXPECT_EQ(run(sweep()).size(), 10U);
    EXPECT_EQ(outcome_.before, 2U);
    const std::string grown = csv();
    EXPECT_EQ(run(sweep()).size(), 0U) << "all is there";
    EXPECT_EQ(csv(), grown);
    EXPECT_EQ(run(sweep(), [](auto& options) { options.retry_failed = true; }).size(), 8U);
    EXPECT_EQ(run(sweep(), [](auto& options) { options.fresh = true; }).size(), 12U);
    EXPECT_EQ(csv(), grown);
}

TEST_F(SweepOfRings, GivesTheSameFilesFromManyProcessesAsFromOne) {
    run(sweep());
    const std::string one = csv();
    const config::SweepDescription again = sweep();
    ProcessWorkers workers(3, sweep_task(again, locator_));
    run_sweep(again, locator_, workers, {folder_.path() / "out", true, false, {}});
    EXPECT_EQ(csv(), one);
}

TEST_F(SweepOfRings, RunsAPointAgainWhoseConfigurationHasChanged) {
    const fs::path ring = folder_.path() / "mine.yaml";
    fs::copy_file(RASTERLOOM_SOURCE_DIR "/configs/ring.yaml", ring);
    const auto text = "configs: [" + ring.string() + ", edge-list.yaml]\n";
    EXPECT_EQ(run(sweep(text)).size(), 2U);
    std::ofstream(ring, std::ios::app) << "# a word more, the same machine\n";
    EXPECT_EQ(run(sweep(text)).size(), 0U);
    std::ofstream(ring, std::ios::app) << "screen: { width: 8 }\n";
    EXPECT_EQ(run(sweep(text)), std::vector<std::size_t>{0});
}

TEST_F(SweepOfRings, TriesAPointOnceMoreWhoseWorkerEnded) {
    const config::SweepDescription rings =
        sweep("configs: [ring.yaml]\nvary: { topology.nodes: [4, 5, 6] }\n");
    const fs::path mark = folder_.path() / "mark";
    const PointTask task = sweep_task(rings, locator_);
    ProcessWorkers workers(2, [&](std::size_t point) {
        const bool first_time = point == 1 && !fs::exists(mark);
        if (first_time) {
            std::ofstream(mark) << "x";
        }
        if (first_time || point == 2) {
            std::raise(SIGKILL);
        }
        return task(point);
    });
    const SweepProgress outcome =
        run_sweep(rings, locator_, workers, {folder_.path() / "out", false, false, {}});
    EXPECT_EQ(outcome.done, 3U);
    EXPECT_EQ(outcome.failed, 1U);
    EXPECT_THAT(csv(), HasSubstr(",5,done,"));
    EXPECT_THAT(csv(), HasSubstr(",6,failed,the process that ran it was ended by signal 9"));
}

TEST_F(SweepOfRings, TellsHowFarItIs) {
    std::vector<std::size_t> done;
    run(sweep(), [&done](SweepOptions& options) {
        options.progress = [&done](const SweepProgress& progress) {
            done.push_back(progress.done);
            EXPECT_EQ(progress.points, 12U);
        };
    });
    EXPECT_EQ(done.size(), 12U);
    EXPECT_EQ(done.back(), 12U);
}

TEST_F(SweepOfRings, HasItsFolderForItself) {
    const observe::FolderLock other(folder_.path() / "out");
    EXPECT_THROW(run(sweep()), observe::OutputError);
    EXPECT_FALSE(fs::exists(folder_.path() / "out/results.sqlite"));
}

TEST(SweepProgress, KnowsTheTimeLeftByThePaceOfThisStart) {
    SweepProgress progress{.points = 100, .done = 50, .before = 50, .failed = 0, .seconds = 3};
    EXPECT_EQ(progress.seconds_left(), 0) << "no pace yet";
    progress.done = 60;
    EXPECT_DOUBLE_EQ(progress.seconds_left(), 12);
    progress.done = 100;
    EXPECT_EQ(progress.seconds_left(), 0);
}

TEST(RunPoint, KeepsTheFailureOfTheGuest) {
    const config::Locator locator{RASTERLOOM_SOURCE_DIR};
    const config::SweepDescription sweep = config::read_sweep(
        "configs: [ring.yaml]\nvary: { nodes.program: [" RASTERLOOM_SOURCE_DIR
        "/tests/cli/programs/fault.s, " RASTERLOOM_SOURCE_DIR "/tests/cli/programs/wrong.s] }\n",
        "sweep.yaml", locator);
    EXPECT_THAT(run_point(sweep.point(0), locator).error, HasSubstr("FAULT 000042"));
    EXPECT_THAT(run_point(sweep.point(1), locator).error, HasSubstr("'bogus' is no instruction"));
}

}  // namespace
}  // namespace rasterloom::emulation
