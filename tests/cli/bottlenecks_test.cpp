// SPDX-License-Identifier: MIT
// Traces and the search for bottlenecks as a user meets them, bad input first of all.
#include "machine/observe/database.hpp"
#include "tests/cli/command_line.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class Bottlenecks : public CommandLine {
  protected:
    static std::vector<std::string> small_run(const std::vector<std::string>& more) {
        std::vector<std::string> words{
            "run",        RASTERLOOM_SOURCE_DIR "/configs/splitter4.yaml",
            "--no-files", "--quiet",
            "--set",      "screen={width: 64, height: 64}",
            "--set",      "scene={object: random_polygons, polygons: 20}"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    void expect_refused(const std::string& file, const std::string& why) const {
        const Finished finished = rasterloom({"bottlenecks", file});
        EXPECT_EQ(finished.status, 2);
        EXPECT_EQ(finished.out, "");
        EXPECT_THAT(finished.err, StartsWith("rasterloom: " + file + ": " + why));
        EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1);
    }
};

TEST_F(Bottlenecks, OfATraceAreTheSameAsThoseOfTheRun) {
    const Finished run = rasterloom(small_run({"--trace", "x.sqlite", "--bottlenecks"}));
    ASSERT_EQ(run.status, 0) << run.err;
    const Finished read = rasterloom({"bottlenecks", "x.sqlite"});
    ASSERT_EQ(read.status, 0) << read.err;
    EXPECT_EQ(run.out, "\n" + read.out);
    EXPECT_THAT(read.out, StartsWith("Bottleneck: node P"));
    EXPECT_THAT(read.out, HasSubstr("tiler/"));
    EXPECT_THAT(files(), ElementsAre("x.sqlite"));
}

TEST_F(Bottlenecks, OfAFileThatIsNotThereAreRefused) {
    expect_refused("missing.sqlite", "cannot be opened");
}

TEST_F(Bottlenecks, OfAForeignFileAreRefused) {
    std::ofstream(work_ / "text.sqlite") << std::string(5000, 'x');
    expect_refused("text.sqlite", "is no SQLite file");
    observe::Database::open(work_ / "other.sqlite", observe::Database::Access::change)
        .execute("CREATE TABLE message (event INTEGER)");
    expect_refused("other.sqlite", "is no trace; expected a file that `rasterloom run --trace");
    std::ofstream(work_ / "empty.sqlite").close();
    expect_refused("empty.sqlite", "is no trace");
}

TEST_F(Bottlenecks, OfAnotherFormatAreRefused) {
    ASSERT_EQ(rasterloom(small_run({"--trace", "x.sqlite"})).status, 0);
    observe::Database::open(work_ / "x.sqlite", observe::Database::Access::change)
        .execute("PRAGMA user_version = 99");
    expect_refused("x.sqlite", "is a trace of format 99; this program reads format");
}

TEST_F(Bottlenecks, OfATruncatedFileAreRefused) {
    ASSERT_EQ(rasterloom(small_run({"--trace", "x.sqlite"})).status, 0);
    const auto whole = std::filesystem::file_size(work_ / "x.sqlite");
    for (const auto size : {whole / 2, whole - 4096, std::uintmax_t{4096}, std::uintmax_t{50}}) {
        std::filesystem::resize_file(work_ / "x.sqlite", size);
        expect_refused("x.sqlite", "is damaged, perhaps cut off");
    }
}

TEST_F(Bottlenecks, TracesWithAnUnknownEndingAreRefused) {
    const Finished finished = rasterloom(small_run({"--trace", "x.db"}));
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("--trace: not a kind of trace 'x.db'; expected a name that "
                                        "ends in .perfetto-trace or .sqlite"));
}

TEST_F(Bottlenecks, TracesThatCannotBeWrittenAreRefused) {
    for (const std::string name : {"no/folder/x.sqlite", "no/folder/x.perfetto-trace"}) {
        const Finished finished = rasterloom(small_run({"--trace", name}));
        EXPECT_EQ(finished.status, 2);
        EXPECT_THAT(finished.err, StartsWith("rasterloom: " + name));
    }
    EXPECT_THAT(files(), IsEmpty());
}

TEST_F(Bottlenecks, TracesForWhichTheDiskHasNoRoomLeaveNothingBehind) {
    for (const std::string name : {"x.sqlite", "x.perfetto-trace"}) {
        ASSERT_EQ(rasterloom(small_run({"--trace", name})).status, 0);
        const auto whole = std::filesystem::file_size(work_ / name);
        std::filesystem::remove(work_ / name);
        for (const auto room : {std::uintmax_t{4096}, whole / 3, whole * 2 / 3, whole - 4096}) {
            EXPECT_EQ(status_of(start(small_run({"--trace", name}), room)), 2) << name << room;
            EXPECT_THAT(files(), IsEmpty()) << name << room;
        }
    }
}

TEST_F(Bottlenecks, WindowsAndPartsThatAreNoneAreRefused) {
    const auto refused = [&](const std::vector<std::string>& words, const std::string& message) {
        std::vector<std::string> more{"--trace", "x.sqlite"};
        more.insert(more.end(), words.begin(), words.end());
        const Finished finished = rasterloom(small_run(more));
        EXPECT_EQ(finished.status, 2);
        EXPECT_THAT(finished.err, HasSubstr(message));
    };
    refused({"--trace-window", "5ms"},
            "--trace-window: no window of time '5ms'; expected FROM..TO");
    refused({"--trace-window", "5ms..1ms"}, "--trace-window: an empty window '5ms..1ms'");
    refused({"--trace-window", "5..9"}, "--trace-window:");
    refused({"--trace-of", "P3,spliter/0"}, "--trace-of: no such part of the machine 'spliter/0'");
    refused({"--trace-of", "P3,spliter/0"}, "did you mean 'splitter/0'?");
    EXPECT_THAT(files(), IsEmpty());
}

TEST_F(Bottlenecks, WithoutATraceAWindowMeansNothing) {
    const Finished finished = rasterloom(small_run({"--trace-window", "1ms..2ms"}));
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("--trace-window requires --trace"));
}

}  // namespace
}  // namespace rasterloom::cli
