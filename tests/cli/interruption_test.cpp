// SPDX-License-Identifier: MIT
// A run that the user stops ends at once and leaves nothing half-written.
#include "tests/cli/command_line.hpp"

#include <chrono>
#include <csignal>
#include <ostream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rasterloom::cli {
namespace {

using testing::IsEmpty;

class Interrupted : public CommandLine, public testing::WithParamInterface<int> {
  protected:
    // A run that would take for ever.
    pid_t start() const {
        const pid_t child = ::fork();
        if (child == 0) {
            const std::string work = (folder_ / "work").string();
            const std::string program_set = "nodes.program=" + program("endless.s");
            if (::chdir(work.c_str()) == 0) {
                ::execl(RASTERLOOM_BINARY_DIR "/rasterloom", "rasterloom", "run", "ring.yaml",
                        "--max-time", "100000s", "--out", "far/away", "--set", program_set.c_str(),
                        "--quiet", nullptr);
            }
            ::_exit(99);
        }
        return child;
    }

    bool wait_for_files(bool there) const {
        for (int i = 0; i < 1000 && files().empty() == there; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return files().empty() != there;
    }
};

TEST_P(Interrupted, EndsByTheSignalAndLeavesNothing) {
    const pid_t child = start();
    ASSERT_GT(child, 0);
    EXPECT_TRUE(wait_for_files(true));
    EXPECT_EQ(::kill(child, GetParam()), 0);
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), GetParam());
    EXPECT_THAT(files(), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupted, testing::Values(SIGINT, SIGTERM, SIGHUP));

}  // namespace
}  // namespace rasterloom::cli
