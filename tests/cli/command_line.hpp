// SPDX-License-Identifier: MIT
// Runs the `rasterloom` command as a user does.
#pragma once

#include "tests/temporary_folder.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <sys/types.h>

namespace rasterloom::cli {

struct Finished {
    int status = -1;
    std::string out;
    std::string err;
};

std::string read_text(const std::filesystem::path& path);

// A test with an empty folder of its own, work_, in which the command runs.
class CommandLine : public testing::Test {
  protected:
    void SetUp() override;

    Finished rasterloom(const std::vector<std::string>& arguments) const;
    // Likewise, but not waited for. `room`: bytes that a file may have; a write beyond fails.
    pid_t start(std::vector<std::string> arguments, rlim_t room = RLIM_INFINITY) const;
    // Waits for it; -1 when a signal has ended it.
    static int status_of(pid_t child);
    // What the command, which must succeed, prints.
    nlohmann::json json_of(const std::vector<std::string>& arguments) const;
    // That it ends with status 2, says this, and prints nothing.
    void expect_refused(const std::vector<std::string>& arguments, const std::string& what) const;
    // A file in the folder.
    void write(const std::string& name, const std::string& text) const;
    // What the command left in the folder, hidden files included.
    std::vector<std::string> files() const;

    TemporaryFolder temporary_;
    std::filesystem::path folder_ = temporary_.path();
    std::filesystem::path work_ = folder_ / "work";
};

inline std::string program(const std::string& name) {
    return RASTERLOOM_SOURCE_DIR "/tests/cli/programs/" + name;
}

}  // namespace rasterloom::cli
