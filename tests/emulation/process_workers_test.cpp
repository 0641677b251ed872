// SPDX-License-Identifier: MIT
#include "machine/emulation/process_workers.hpp"

#include <algorithm>
#include <csignal>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace rasterloom::emulation {
namespace {

using testing::HasSubstr;

// Everything that comes of `points` points, by point.
std::map<std::size_t, FinishedPoint> run_all(PointWorkers& workers, std::size_t points) {
    std::map<std::size_t, FinishedPoint> finished;
    std::size_t next = 0;
    while (finished.size() < points) {
        for (; next < points && workers.idle() > 0; ++next) {
            workers.start(next);
        }
        for (FinishedPoint& point : workers.wait(std::chrono::milliseconds(1000))) {
            finished[point.point] = std::move(point);
        }
    }
    return finished;
}

TEST(ProcessWorkers, GiveBackEveryPointsResult) {
    // Longer than what a socket holds.
    const auto text = [](std::size_t point) {
        return std::string(point * 100'000, static_cast<char>('a' + point)) + "\0end";
    };
    ProcessWorkers workers(3, text);
    const auto finished = run_all(workers, 10);
    for (std::size_t point = 0; point < 10; ++point) {
        EXPECT_EQ(finished.at(point).result, text(point));
        EXPECT_EQ(finished.at(point).loss, "");
    }
    EXPECT_EQ(workers.idle(), 3U);
}

TEST(ProcessWorkers, LoseOnlyThePointThatEndsOne) {
    ProcessWorkers workers(2, [](std::size_t point) {
        if (point == 3) {
            std::raise(SIGKILL);
        }
        if (point == 4) {
            ::_exit(42);
        }
        return std::to_string(point);
    });
    const auto finished = run_all(workers, 8);
    EXPECT_THAT(finished.at(3).loss, HasSubstr("ended by signal 9 (Killed)"));
    EXPECT_THAT(finished.at(4).loss, HasSubstr("ended with status 42"));
    for (const std::size_t point : {0U, 1U, 2U, 5U, 6U, 7U}) {
        EXPECT_EQ(finished.at(point).result, std::to_string(point));
    }
}

TEST(ProcessWorkers, AreOtherProcesses) {
    ProcessWorkers workers(1, [](std::size_t) { return std::to_string(::getpid()); });
    EXPECT_NE(run_all(workers, 1).at(0).result, std::to_string(::getpid()));
}

TEST(ProcessWorkers, AreNotWaitedForWhenNobodyWantsTheirResult) {
    ProcessWorkers workers(1, [](std::size_t) {
        ::pause();
        return std::string();
    });
    workers.start(0);
    EXPECT_EQ(workers.idle(), 0U);
    EXPECT_TRUE(workers.wait(std::chrono::milliseconds(1)).empty());
}

}  // namespace
}  // namespace rasterloom::emulation
