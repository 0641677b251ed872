// SPDX-License-Identifier: MIT
// Every configuration that the project ships.
#include "machine/config/export.hpp"
#include "machine/config/sweep.hpp"
#include "tests/config/machine_text.hpp"

#include <filesystem>
#include <fstream>
#include <vector>

#include <gtest/gtest.h>

namespace rasterloom::config {
namespace {

std::vector<std::filesystem::path> files_in(const char* folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() == ".yaml") {
            files.push_back(entry.path());
        }
    }
    return files;
}

TEST(ShippedConfigurations, LoadAndExportAndLoadAgain) {
    const auto files = files_in(RASTERLOOM_SOURCE_DIR "/configs");
    EXPECT_GE(files.size(), 17U);
    for (const auto& file : files) {
        const auto machine = load_machine(file.string(), {}, source_tree());
        EXPECT_FALSE(machine.machine.empty()) << file;
        const std::string text = export_machine(machine);
        EXPECT_EQ(export_machine(read_machine(text, "exported.yaml", {}, source_tree())), text)
            << file;
    }
}

TEST(ShippedConfigurations, OpenWithTheQuestionTheyAnswer) {
    for (const auto& file : files_in(RASTERLOOM_SOURCE_DIR "/configs")) {
        std::ifstream stream(file);
        std::string line;
        std::getline(stream, line);
        EXPECT_TRUE(line.starts_with("# ") && line.find('?') != std::string::npos)
            << file << ": " << line;
    }
}

TEST(ShippedSweeps, OpenWithTheQuestionTheyAnswerAndLoadAtEveryPoint) {
    const auto files = files_in(RASTERLOOM_SOURCE_DIR "/configs/sweeps");
    EXPECT_GE(files.size(), 1U);
    for (const auto& file : files) {
        std::ifstream stream(file);
        std::string line;
        std::getline(stream, line);
        EXPECT_TRUE(line.starts_with("# ") && line.find('?') != std::string::npos) << file;
        const SweepDescription sweep = load_sweep(file.string(), source_tree());
        for (std::size_t i = 0; i < sweep.size(); ++i) {
            EXPECT_NO_THROW(load_point(sweep.point(i), source_tree())) << file << ": " << i;
        }
    }
}

TEST(ShippedScenes, FitIntoAMachine) {
    const auto files = files_in(RASTERLOOM_SOURCE_DIR "/configs/scenes");
    EXPECT_GE(files.size(), 8U);
    for (const auto& file : files) {
        EXPECT_TRUE(load_text(kSmallMachine, {"scene=" + file.string()}).scene.has_value()) << file;
    }
}

}  // namespace
}  // namespace rasterloom::config
