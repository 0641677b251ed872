// SPDX-License-Identifier: MIT
// Traces of whole machines, read back by protoc, which knows nothing of ours.
#include "machine/emulation/run.hpp"
#include "machine/observe/output_folder.hpp"
#include "tests/emulation/bucket_machines.hpp"

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

namespace rasterloom::emulation {
namespace {

class Trace : public testing::Test {
  protected:
    std::filesystem::path file_ = std::filesystem::path(testing::TempDir()) /
                                  ("trace-" + std::to_string(getpid()) + ".perfetto-trace");

    ~Trace() override { std::filesystem::remove(file_); }

    RunOutcome run(config::MachineDescription description, std::int64_t threads = 1) const {
        description.run.threads = threads;
        RunOptions options;
        options.traces.paths = {file_};
        return run_machine(description, options);
    }
    std::string bytes() const {
        std::ifstream stream(file_, std::ios::binary);
        std::ostringstream text;
        text << stream.rdbuf();
        return text.str();
    }
    // The file as text; empty when protoc finds it broken.
    std::string decoded() const {
        const std::string schema = RASTERLOOM_SOURCE_DIR "/tests/emulation";
        const std::string command = "protoc --proto_path='" + schema +
                                    "' --decode=Trace perfetto_subset.proto < '" + file_.string() +
                                    "'";
        const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"),
                                                                   pclose);
        std::string text;
        std::array<char, 4096> part;
        while (const std::size_t size = std::fread(part.data(), 1, part.size(), pipe.get())) {
            text.append(part.data(), size);
        }
        return text;
    }
    static bool names(const std::string& text, const std::string& name) {
        return text.find("\"" + name + "\"") != std::string::npos;
    }
    static std::size_t count(const std::string& text, const std::string& what) {
        std::size_t found = 0;
        for (std::size_t at = text.find(what); at != std::string::npos;
             at = text.find(what, at + what.size())) {
            ++found;
        }
        return found;
    }
};

TEST_F(Trace, HoldsEveryProcessorsStatesAndEveryMessage) {
    const RunOutcome outcome = run(small_geodesic());
    ASSERT_EQ(outcome.failure, "");
    const std::string text = decoded();
    EXPECT_NE(text.find("(1 ns here is 1 ns of the machine"), std::string::npos);
    for (const char* name :
         {"processors", "links", "phases", "waits for a message", "frame 0: draw"}) {
        EXPECT_TRUE(names(text, name)) << name;
    }
    for (const observe::NodeReport& node : outcome.report.nodes) {
        EXPECT_TRUE(names(text, node.name)) << node.name;
    }
    // Each message is sent, transferred and taken; its arrows end where it is taken.
    const auto messages = static_cast<std::size_t>(outcome.report.messages());
    ASSERT_GT(messages, 100U);
    EXPECT_EQ(count(text, " terminating_flow_ids: "), messages);
    EXPECT_EQ(count(text, " flow_ids: "), 2 * messages);
    // What is begun is ended, and nothing is there that the format does not know.
    EXPECT_EQ(count(text, "type: SLICE_BEGIN"), count(text, "type: SLICE_END"));
    // All queues are empty in the end; some held several messages.
    EXPECT_GT(count(text, "counter {"), outcome.report.nodes.size() / 2);
    EXPECT_TRUE(names(text, "messages waiting"));
    EXPECT_TRUE(names(text, "messages waiting to be sent"));
    EXPECT_EQ(count(text, "counter_value: -"), 0U);
    EXPECT_GT(count(text, "counter_value: 0\n"), 0U);
    EXPECT_GT(count(text, "counter_value: 2\n"), 0U);
    EXPECT_EQ(count(text, "\n  1: "), 0U);
}

TEST_F(Trace, IsTheSameOnAnyNumberOfThreads) {
    run(small_geodesic(), 1);
    const std::string expected = bytes();
    for (const std::int64_t threads : {2, 3}) {
        run(small_geodesic(), threads);
        EXPECT_TRUE(bytes() == expected) << threads << " threads";
    }
}

TEST_F(Trace, ShowsMachinesWithoutLinks) {
    const RunOutcome outcome =
        run(shipped("interlace4.yaml", {"screen={width: 64, height: 64}", "scene.polygons=10",
                                        "scene=scenes/random.yaml"}));
    ASSERT_EQ(outcome.failure, "");
    const std::string text = decoded();
    EXPECT_FALSE(names(text, "links"));
    EXPECT_TRUE(names(text, "P3"));
    EXPECT_TRUE(names(text, "fabric"));
    EXPECT_TRUE(names(text, "host"));
    EXPECT_TRUE(names(text, "bus/0"));
    EXPECT_TRUE(names(text, "blocked"));
    EXPECT_GT(count(text, "type: INSTANT"), 10U);
}

TEST_F(Trace, ShowsWhatLiesBeforeAndWithinRasterizers) {
    const std::vector<std::string> changes{"topology.rasterizers=2", "sorter.time_per_pair=1us"};
    ASSERT_EQ(run(small_bucket(kHardware, changes)).failure, "");
    const std::string hardware = decoded();
    for (const char* name : {"sorter", "triangle_unit/R0", "pixel_unit/R1", "R0", "R1", "set_up",
                             "pixels", "busy", "blocked", "frame 0: draw"}) {
        EXPECT_TRUE(names(hardware, name)) << name;
    }
    const RunOutcome outcome = run(small_bucket(kSoftware, changes));
    ASSERT_EQ(outcome.failure, "");
    const std::string software = decoded();
    for (const char* name : {"sorter", "feeder/R0", "R1", "frame 0: draw"}) {
        EXPECT_TRUE(names(software, name)) << name;
    }
    EXPECT_TRUE(names(software, "messages waiting"));
    EXPECT_EQ(count(software, "type: INSTANT"),
              static_cast<std::size_t>(outcome.report.messages()));
    for (const std::string& text : {hardware, software}) {
        EXPECT_EQ(count(text, "type: SLICE_BEGIN"), count(text, "type: SLICE_END"));
        EXPECT_EQ(count(text, "counter_value: -"), 0U);
    }
}

TEST_F(Trace, OfAWindowKnowsTheQueuesFromBefore) {
    RunOptions options;
    options.traces.paths = {file_};
    options.traces.from = Time::zero() + Duration::milliseconds(2);
    options.traces.to = Time::zero() + Duration::milliseconds(3);
    options.traces.components = {"P1"};
    const RunOutcome outcome =
        run_machine(shipped("splitter4.yaml", {"screen={width: 64, height: 64}",
                                               "scene={object: random_polygons, polygons: 60}"}),
                    options);
    ASSERT_EQ(outcome.failure, "");
    const std::string text = decoded();
    // P1's queue of four places is full when the window opens, and nothing comes or goes in it.
    EXPECT_EQ(count(text, "counter_value: 4\n"), 1U);
    EXPECT_EQ(count(text, "counter_value:"), 1U);
    EXPECT_GT(count(text, "type: SLICE_BEGIN"), 0U);
    EXPECT_FALSE(names(text, "waits for the next phase"));
}

TEST_F(Trace, OfARunThatFailsLeavesNoFile) {
    EXPECT_NE(run(small_geodesic({"run.max_time=1ms"})).failure, "");
    EXPECT_FALSE(std::filesystem::exists(file_));
    EXPECT_FALSE(std::filesystem::exists(file_.string() + ".partial"));
}

TEST_F(Trace, ThatCannotBeWrittenIsRefused) {
    RunOptions options;
    options.traces.paths = {file_ / "below" / "a-file.perfetto-trace"};
    EXPECT_THROW(run_machine(small_geodesic(), options), observe::OutputError);
}

TEST_F(Trace, ThatDoesNotFitOnTheDiskIsRefused) {
    RunOptions options;
    std::filesystem::create_symlink("/dev/full", file_.string() + ".partial");
    options.traces.paths = {file_};
    EXPECT_THROW(run_machine(small_geodesic(), options), observe::OutputError);
    EXPECT_FALSE(std::filesystem::exists(file_));
}

}  // namespace
}  // namespace rasterloom::emulation
