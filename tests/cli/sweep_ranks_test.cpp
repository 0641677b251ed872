// SPDX-License-Identifier: MIT
// A sweep as an MPI job of several ranks is the same sweep.
#include "tests/cli/command_line.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

namespace rasterloom::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

#ifdef RASTERLOOM_MPIRUN

class SweepOnRanks : public CommandLine {
  protected:
    void SetUp() override {
        CommandLine::SetUp();
        std::ofstream(work_ / "s.yaml")
            << "configs: [splitter4.yaml, ring.yaml]\n"
               "scenes: [scenes/random.yaml]\n"
               "vary: { scene.polygons: [20, 40, 60], scene.seed: [1, 2] }\n";
    }

    Finished on_ranks(int ranks, const std::string& arguments) const {
        // MPI leaves memory behind, which a build with sanitizers would complain of.
        const std::string line = "cd '" + work_.string() +
                                 "' && ASAN_OPTIONS=detect_leaks=0 " RASTERLOOM_MPIRUN
                                 " --allow-run-as-root --oversubscribe -n " +
                                 std::to_string(ranks) +
                                 " " RASTERLOOM_BINARY_DIR "/rasterloom sweep --mpi " + arguments +
                                 " >'" + (folder_ / "stdout").string() + "' 2>'" +
                                 (folder_ / "stderr").string() + "'";
        const int raw = std::system(line.c_str());
        return {WIFEXITED(raw) ? WEXITSTATUS(raw) : -1, read_text(folder_ / "stdout"),
                read_text(folder_ / "stderr")};
    }
};

TEST_F(SweepOnRanks, GivesTheSameResults) {
    ASSERT_EQ(rasterloom({"sweep", "s.yaml", "--out", "alone", "--quiet"}).status, 0);
    const Finished one = on_ranks(1, "s.yaml --out one");
    EXPECT_EQ(one.status, 0) << one.err;
    const Finished three = on_ranks(3, "s.yaml --out three --workers 2");
    EXPECT_EQ(three.status, 0) << three.err;
    EXPECT_THAT(three.out, HasSubstr("12 points, 12 of them run now"));
    EXPECT_EQ(std::count(three.out.begin(), three.out.end(), '\n'), 3) << "one rank speaks";
    const std::string alone = read_text(work_ / "alone/results.csv");
    EXPECT_THAT(alone, HasSubstr("done"));
    EXPECT_EQ(read_text(work_ / "one/results.csv"), alone);
    EXPECT_EQ(read_text(work_ / "three/results.csv"), alone);
}

TEST_F(SweepOnRanks, GoesOnWithWhatIsMissing) {
    std::ofstream(work_ / "part.yaml")
        << "configs: [splitter4.yaml]\n"
           "scenes: [scenes/random.yaml]\n"
           "vary: { scene.polygons: [20, 40], scene.seed: [1, 2] }\n";
    ASSERT_EQ(rasterloom({"sweep", "part.yaml", "--out", "here", "--quiet"}).status, 0);
    EXPECT_THAT(on_ranks(2, "s.yaml --out here").out, HasSubstr("12 points, 8 of them run now"));
}

TEST_F(SweepOnRanks, EndsOnEveryRankWhenTheInputIsBad) {
    std::ofstream(work_ / "bad.yaml") << "configs: []\n";
    const Finished bad = on_ranks(3, "bad.yaml");
    EXPECT_EQ(bad.status, 2);
    const std::string said = "rasterloom: bad.yaml:1:10: configs: an empty list";
    EXPECT_THAT(bad.err, HasSubstr(said));
    EXPECT_EQ(bad.err.find(said), bad.err.rfind(said)) << "one rank speaks";
    const Finished unwritable = on_ranks(3, "s.yaml --out s.yaml/here");
    EXPECT_EQ(unwritable.status, 2);
    EXPECT_THAT(unwritable.err, HasSubstr("s.yaml/here: cannot make a folder here"));
    EXPECT_THAT(files(), ElementsAre("bad.yaml", "s.yaml"));
}

#else

class SweepOnRanks : public CommandLine {};

TEST_F(SweepOnRanks, IsRefusedInABuildWithoutThem) {
    std::ofstream(folder_ / "work/s.yaml") << "configs: [ring.yaml]\n";
    const Finished finished = rasterloom({"sweep", "s.yaml", "--mpi"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("--mpi: not in this build"));
    EXPECT_THAT(finished.out, IsEmpty());
}

#endif

}  // namespace
}  // namespace rasterloom::cli
