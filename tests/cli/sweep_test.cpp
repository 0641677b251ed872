// SPDX-License-Identifier: MIT
// Whatever happens to a sweep on the way, it ends with the same results.
#include "machine/observe/database.hpp"
#include "tests/cli/command_line.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rasterloom::cli {
namespace {

using observe::Database;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// 24 points, a third of them failing: no polygons are drawn on a ring.
constexpr const char* kSweep =
    "configs: [splitter4.yaml, uniprocessor.yaml, ring.yaml]\n"
    "scenes: [scenes/random.yaml]\n"
    "vary: { scene.polygons: [50, 100], scene.seed: [1, 2], run.max_time: [10s, 20s] }\n"
    "out: results\n";
constexpr int kPoints = 24;

class SweepCommand : public CommandLine {
  protected:
    void SetUp() override {
        CommandLine::SetUp();
        std::ofstream(work_ / "s.yaml") << kSweep;
    }

    // Rows of the results; 0 also when they cannot be read at the moment.
    std::int64_t rows(const std::string& folder) const {
        try {
            const Database database =
                Database::open(work_ / folder / "results.sqlite", Database::Access::read);
            observe::Statement count = database.prepare("SELECT count(*) FROM points");
            return count.step() ? count.column<std::int64_t>(0) : 0;
        } catch (const observe::DatabaseError&) {
            return 0;
        }
    }

    // Everything in table `points`, as it comes.
    std::string dump(const std::string& folder) const {
        const Database database =
            Database::open(work_ / folder / "results.sqlite", Database::Access::read);
        observe::Statement all = database.prepare("SELECT * FROM points");
        std::string text;
        while (all.step()) {
            for (int column = 0; column < all.columns(); ++column) {
                text += all.column<std::string>(column) + (all.is_null(column) ? "~|" : "|");
            }
            text += "\n";
        }
        return text;
    }

    std::string csv(const std::string& folder) const {
        return read_text(work_ / folder / "results.csv");
    }

    std::vector<std::string> results(const std::string& folder) const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(work_ / folder)) {
            names.push_back(entry.path().filename().string());
        }
        std::sort(names.begin(), names.end());
        return names;
    }

    void expect_same_results(const std::string& folder) const {
        const Finished whole =
            rasterloom({"sweep", "s.yaml", "--workers", "1", "--out", "whole", "--quiet"});
        ASSERT_EQ(whole.status, 0) << whole.err;
        EXPECT_EQ(rows("whole"), kPoints);
        EXPECT_EQ(csv(folder), csv("whole"));
        EXPECT_EQ(dump(folder), dump("whole"));
        EXPECT_THAT(results(folder), ElementsAre("results.csv", "results.sqlite"));
    }
};

TEST_F(SweepCommand, SaysWhatItHasDone) {
    const Finished first = rasterloom({"sweep", "s.yaml"});
    EXPECT_EQ(first.status, 0) << first.err;
    EXPECT_THAT(first.out, HasSubstr("24 points, 24 of them run now"));
    EXPECT_THAT(first.out, HasSubstr("8 failed"));
    EXPECT_THAT(first.err, IsEmpty()) << "no progress bar where there is no terminal";
    EXPECT_THAT(csv("results"), HasSubstr("ring.yaml"));
    const Finished second = rasterloom({"sweep", "s.yaml"});
    EXPECT_THAT(second.out, HasSubstr("24 points, 0 of them run now"));
    const Finished third = rasterloom({"sweep", "s.yaml", "--retry-failed"});
    EXPECT_THAT(third.out, HasSubstr("24 points, 8 of them run now"));
    EXPECT_THAT(rasterloom({"sweep", "s.yaml", "--quiet"}).out, IsEmpty());
    expect_same_results("results");
}

TEST_F(SweepCommand, EndsWithTheSameResultsHoweverOftenItIsKilled) {
    std::mt19937 random(1);
    std::uniform_int_distribution<std::int64_t> anywhere(0, kPoints - 1);
    for (int kill = 0; kill < 6; ++kill) {
        const std::int64_t enough = anywhere(random);
        const pid_t child = start({"sweep", "s.yaml", "--workers", "2", "--quiet"});
        ASSERT_GT(child, 0);
        bool over = false;
        while (rows("results") < enough && !over) {
            over = ::waitpid(child, nullptr, WNOHANG) != 0;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        if (!over) {
            ::kill(child, SIGKILL);
            ::waitpid(child, nullptr, 0);
        }
    }
    const Finished last = rasterloom({"sweep", "s.yaml", "--quiet"});
    EXPECT_EQ(last.status, 0) << last.err;
    expect_same_results("results");
}

TEST_F(SweepCommand, LosesNothingOnAFullDisk) {
    constexpr rlim_t kRoom = 20'000;  // for the tables and some rows
    EXPECT_EQ(status_of(start({"sweep", "s.yaml", "--quiet"}, kRoom)), 2);
    EXPECT_LT(rows("results"), kPoints);
    EXPECT_EQ(csv("results"), "") << "half a file under its final name";
    EXPECT_EQ(rasterloom({"sweep", "s.yaml", "--quiet"}).status, 0);
    expect_same_results("results");
}

TEST_F(SweepCommand, KeepsAnEarlierTableWhenThereIsNoRoomForTheNewOne) {
    ASSERT_EQ(rasterloom({"sweep", "s.yaml", "--quiet"}).status, 0);
    std::ofstream(work_ / "results/results.csv") << "earlier";
    constexpr rlim_t kRoom = 1000;
    EXPECT_EQ(status_of(start({"sweep", "s.yaml", "--quiet"}, kRoom)), 2);
    EXPECT_EQ(csv("results"), "earlier");
    EXPECT_THAT(results("results"), ElementsAre("results.csv", "results.sqlite"));
}

}  // namespace
}  // namespace rasterloom::cli
