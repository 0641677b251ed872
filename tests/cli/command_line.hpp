// SPDX-License-Identifier: MIT
// Runs the `rasterloom` command as a user does.
#pragma once

#include "tests/temporary_folder.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rasterloom::cli {

struct Finished {
    int status = -1;
    std::string out;
    std::string err;
};

std::string read_text(const std::filesystem::path& path);

// A test with an empty folder of its own, in which the command runs.
class CommandLine : public testing::Test {
  protected:
    void SetUp() override;

    Finished rasterloom(const std::vector<std::string>& arguments) const;
    // What the command left in the folder, hidden files included.
    std::vector<std::string> files() const;

    TemporaryFolder temporary_;
    std::filesystem::path folder_ = temporary_.path();
};

inline std::string program(const std::string& name) {
    return RASTERLOOM_SOURCE_DIR "/tests/cli/programs/" + name;
}

}  // namespace rasterloom::cli
