// SPDX-License-Identifier: MIT
// Every kind of bad input to a sweep ends with one clear message, status 2 and no output.
#include "machine/observe/database.hpp"
#include "tests/cli/command_line.hpp"

#include <algorithm>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct BadSweep {
    const char* name;
    std::string text;  // of s.yaml
    std::vector<std::string> said;
};

void PrintTo(const BadSweep& input, std::ostream* out) {
    *out << input.name;
}

const std::vector<BadSweep> kBadSweeps{
    {"UnknownParameter",
     "configs: [ring.yaml]\nvary: { links.time_per_byt: [1us] }\n",
     {"s.yaml:2:9: links.time_per_byt: unknown key", "did you mean 'time_per_byte'?"}},
    {"Value",
     "configs: [ring.yaml]\nvary: { links.latency: [1us, fast] }\n",
     {"s.yaml:2:30: links.latency: not a number with a unit 'fast'; expected a duration"}},
    {"NoPoints", "configs: []\n", {"s.yaml:1:10: configs: an empty list: the sweep has no points"}},
    {"NoConfigurations",
     "vary: { links.latency: [1us] }\n",
     {"s.yaml:1:1: configs: missing: the sweep has no points"}},
    {"NoValues",
     "configs: [ring.yaml]\nvary: { links.latency: [] }\n",
     {"s.yaml:2:24: links.latency: an empty list: the sweep has no points"}},
    {"UnknownKey",
     "configs: [ring.yaml]\nscene: [scenes/cube.yaml]\n",
     {"s.yaml:2:1: scene: unknown key", "did you mean 'scenes'?"}},
    {"Scene",
     "configs: [ring.yaml]\nscenes: [scenes/cub.yaml]\n",
     {"s.yaml:2:10: scene: no such file"}},
    {"Machine", "machine: x\ntopology: { kind: ring }\n", {"s.yaml:1:1: machine: unknown key"}},
    {"Frames", "configs: [ring.yaml]\nframes: 0\n", {"s.yaml:2:9: run.frames: out of range '0'"}},
    {"Empty", "", {"s.yaml:1:1: the file is empty"}},
    {"Yaml", "configs: [ring.yaml\n", {"s.yaml:2:1: not valid YAML"}},
};

class BadSweeps : public CommandLine, public testing::WithParamInterface<BadSweep> {};

TEST_P(BadSweeps, EndWithOneMessageAndNoOutput) {
    std::ofstream(folder_ / "work/s.yaml") << GetParam().text;
    const Finished finished = rasterloom({"sweep", "s.yaml"});
    EXPECT_EQ(finished.status, 2);
    for (const std::string& part : GetParam().said) {
        EXPECT_THAT(finished.err, HasSubstr(part));
    }
    EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1);
    EXPECT_THAT(finished.out, IsEmpty());
    EXPECT_THAT(files(), ElementsAre("s.yaml"));
}

INSTANTIATE_TEST_SUITE_P(Cases, BadSweeps, testing::ValuesIn(kBadSweeps),
                         [](const auto& info) { return info.param.name; });

class BadSweepResults : public CommandLine {
  protected:
    void SetUp() override {
        CommandLine::SetUp();
        std::ofstream(folder_ / "work/s.yaml") << "configs: [ring.yaml]\nout: results\n";
    }
    // One message of a line with `said`, status 2.
    void expect_refused(const std::string& said, std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"sweep", "s.yaml"});
        const Finished finished = rasterloom(more);
        EXPECT_EQ(finished.status, 2);
        EXPECT_THAT(finished.err, HasSubstr(said));
        EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1);
        EXPECT_THAT(finished.out, IsEmpty());
    }
    std::filesystem::path results_ = folder_ / "work/results";
};

TEST_F(BadSweepResults, AreRefusedWhereNothingCanBeWritten) {
    expect_refused("s.yaml/here: cannot make a folder here", {"--out", "s.yaml/here"});
    std::filesystem::create_directories(results_ / "results.sqlite");
    expect_refused("results/results.sqlite: cannot be opened");
}

TEST_F(BadSweepResults, AreLeftAloneWhenTheyAreForeign) {
    std::filesystem::create_directories(results_);
    const std::string mine(3000, 'm');
    std::ofstream(results_ / "results.sqlite") << mine;
    expect_refused("results/results.sqlite: is no SQLite file");
    expect_refused("results/results.sqlite: is no SQLite file", {"--fresh"});
    EXPECT_EQ(read_text(results_ / "results.sqlite"), mine);
    std::filesystem::remove(results_ / "results.sqlite");
    observe::Database::open(results_ / "results.sqlite", observe::Database::Access::change)
        .execute("CREATE TABLE mine(i)");
    expect_refused("is a database, but not a sweep's", {"--fresh"});
    EXPECT_THAT(files(), ElementsAre("results", "results/results.sqlite", "s.yaml"));
}

TEST_F(BadSweepResults, AreRefusedWhenTheyAreCutOff) {
    ASSERT_EQ(rasterloom({"sweep", "s.yaml"}).status, 0);
    std::filesystem::resize_file(results_ / "results.sqlite", 5000);
    expect_refused("results/results.sqlite: is damaged, perhaps cut off");
}

TEST_F(BadSweepResults, AreRefusedWhenTheyAreOfOtherParameters) {
    ASSERT_EQ(rasterloom({"sweep", "s.yaml"}).status, 0);
    std::ofstream(folder_ / "work/s.yaml")
        << "configs: [ring.yaml]\nout: results\nvary: { links.latency: [1us] }\n";
    expect_refused("holds a sweep over no parameter; expected a sweep over links.latency");
    EXPECT_EQ(rasterloom({"sweep", "s.yaml", "--fresh"}).status, 0);
}

TEST_F(BadSweepResults, DoNotComeOfAMissingSweepOrNoWorkers) {
    expect_refused("--workers", {"--workers", "0"});
    std::filesystem::remove(folder_ / "work/s.yaml");
    expect_refused("s.yaml: cannot be read: no such file");
    EXPECT_THAT(files(), IsEmpty());
}

TEST_F(BadSweepResults, HoldAConfigurationThatDoesNotLoadAsAFailedPoint) {
    std::ofstream(folder_ / "work/bad.yaml") << "machine: bad\ntopology: [\n";
    std::ofstream(folder_ / "work/s.yaml")
        << "configs: [bad.yaml, nowhere.yaml, ring.yaml]\nout: results\n";
    const Finished finished = rasterloom({"sweep", "s.yaml"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_THAT(finished.out, HasSubstr("2 failed"));
    const std::string csv = read_text(results_ / "results.csv");
    EXPECT_THAT(csv, HasSubstr("bad.yaml:3:1: not valid YAML"));
    EXPECT_THAT(csv, HasSubstr("s.yaml:1:21: configs: no such file"));
    EXPECT_THAT(csv, HasSubstr("\nconfig=ring.yaml,ring.yaml,,done,,ring16,16,32,"));
}

}  // namespace
}  // namespace rasterloom::cli
