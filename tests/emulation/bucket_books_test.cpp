// SPDX-License-Identifier: MIT
// What a run of a bucket tiler reports, held against the scene and against the times of
// machine/fabric/rasterizer.hpp, computed here in another way.
#include "machine/emulation/run.hpp"
#include "machine/emulation/triangle_frames.hpp"
#include "machine/host/overlap_census.hpp"
#include "machine/host/tile_overlap.hpp"
#include "tests/emulation/bucket_machines.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::emulation {
namespace {

using observe::BucketReport;

// [tile]: pixels of each triangle in it, in the order of the triangles.
using Tiles = std::map<std::size_t, std::vector<std::int64_t>>;

topology::BucketTiles tiles_of(const config::MachineDescription& machine) {
    return {static_cast<int>(machine.screen.width), static_cast<int>(machine.screen.height),
            topology::parse_tile_size(machine.topology.parameters.at("tile"))};
}

Tiles sorted(const std::vector<host::ScreenTriangle>& triangles,
             const config::MachineDescription& machine) {
    Tiles tiles;
    for (const host::ScreenTriangle& triangle : triangles)
        for (const host::TilePixels& tile :
             host::overlapped_tiles(triangle, tiles_of(machine), machine.sorter.rule))
            tiles[tile.tile].push_back(tile.pixels);
    return tiles;
}

// The recurrence over the pairs that one rasterizer gets in a frame.
class Pipeline {
  public:
    explicit Pipeline(const config::RasterizerDescription& settings) : settings_(settings) {}

    void draw(const std::vector<std::int64_t>& pairs) {
        for (const std::int64_t pixels : pairs) {
            const std::int64_t set_up = handed_over_ + settings_.cycles_per_triangle;
            ends_.push_back(std::max(set_up, drawn()) + pixels * settings_.cycles_per_pixel);
            handed_over_ = std::max(set_up, end_before(settings_.fifo));
        }
    }
    std::int64_t free() const { return handed_over_; }
    std::int64_t drawn() const { return ends_.empty() ? 0 : ends_.back(); }
    bool drew() const { return !ends_.empty(); }

  private:
    std::int64_t end_before(const std::optional<std::int64_t>& places) const {
        const auto pairs = static_cast<std::int64_t>(ends_.size());
        return places && *places < pairs ? ends_[static_cast<std::size_t>(pairs - 1 - *places)] : 0;
    }

    config::RasterizerDescription settings_;
    std::int64_t handed_over_ = 0;
    std::vector<std::int64_t> ends_;
};

// What makes a tile large, by sorter.largest_by.
std::int64_t size_of(const std::vector<std::int64_t>& pairs,
                     const config::MachineDescription& machine) {
    std::int64_t size = 0;
    for (const std::int64_t pixels : pairs)
        switch (machine.sorter.largest_by) {
            case config::TileMeasure::triangles:
                size += 1;
                break;
            case config::TileMeasure::pixels:
                size += pixels;
                break;
            case config::TileMeasure::work:
                size += std::max(machine.rasterizer.cycles_per_triangle,
                                 pixels * machine.rasterizer.cycles_per_pixel);
                break;
        }
    return size;
}

// As the assignments are described in machine/fabric/tile_assignment.hpp.
std::vector<Pipeline> drawn(const Tiles& tiles, const config::MachineDescription& machine) {
    const std::size_t count = std::stoul(machine.topology.parameters.at("rasterizers"));
    std::vector<Pipeline> pipelines(count, Pipeline(machine.rasterizer));
    std::vector<std::pair<std::size_t, std::vector<std::int64_t>>> order(tiles.begin(),
                                                                         tiles.end());
    if (machine.sorter.assignment == TileAssignment::largest_first)
        std::stable_sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
            return size_of(a.second, machine) > size_of(b.second, machine);
        });
    const auto columns = static_cast<std::size_t>(tiles_of(machine).columns());
    const auto step = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)));
    for (const auto& [tile, pairs] : order) {
        const auto first_free =
            std::min_element(pipelines.begin(), pipelines.end(),
                             [](const auto& a, const auto& b) { return a.free() < b.free(); });
        if (machine.sorter.assignment == TileAssignment::interleaved)
            pipelines[(tile % columns + step * (tile / columns)) % count].draw(pairs);
        else
            first_free->draw(pairs);
    }
    return pipelines;
}

std::int64_t cycles_to_draw(const Tiles& tiles, const config::MachineDescription& machine) {
    std::int64_t last = 0;
    for (const Pipeline& pipeline : drawn(tiles, machine))
        last = std::max(last, pipeline.drawn());
    return last;
}

TEST(BucketBooks, SayTheCyclesThatTheRecurrenceGives) {
    for (const char* assignment : {"interleaved", "next_free", "largest_first"})
        for (const char* count : {"1", "3", "16"})
            for (const char* costs :
                 {"{fifo: 0}", "{fifo: 1}", "{fifo: 2}", "{fifo: unlimited}",
                  "{fifo: 3, cycles_per_triangle: 7, cycles_per_pixel: 3}",
                  "{fifo: 1, cycles_per_triangle: 1}", "{fifo: 1, cycles_per_pixel: 0}",
                  "{fifo: unlimited, cycles_per_triangle: 300}"}) {
                const auto machine =
                    small_bucket(kHardware, {"run.frames=2", std::string("rasterizer=") + costs,
                                             std::string("topology.rasterizers=") + count,
                                             std::string("sorter.assignment=") + assignment});
                const auto scene = make_triangle_frames(machine);
                const RunOutcome outcome = run_machine(machine, {});
                ASSERT_EQ(outcome.failure, "");
                const auto& frames = outcome.report.buckets->frames;
                ASSERT_EQ(frames.size(), 2U);
                for (std::size_t frame = 0; frame < 2; ++frame)
                    EXPECT_EQ(frames[frame].draw_cycles,
                              cycles_to_draw(sorted(scene.frames[frame], machine), machine))
                        << assignment << ' ' << count << ' ' << costs << ' ' << frame;
            }
}

TEST(BucketBooks, SayTheCyclesOfEveryOrderOfTiles) {
    std::set<std::int64_t> all;
    for (const char* measure :
         {"{largest_by: triangles", "{largest_by: pixels", "{largest_by: work"}) {
        const auto machine = small_bucket(
            kHardware, {"topology.rasterizers=3", "rasterizer.cycles_per_triangle=25",
                        "rasterizer.cycles_per_pixel=2",
                        std::string("sorter=") + measure + ", assignment: largest_first}"});
        const Tiles tiles = sorted(make_triangle_frames(machine).frames[0], machine);
        const RunOutcome outcome = run_machine(machine, {});
        all.insert(outcome.report.buckets->frames.at(0).draw_cycles);
        EXPECT_EQ(outcome.report.buckets->frames.at(0).draw_cycles, cycles_to_draw(tiles, machine))
            << measure;
    }
    EXPECT_GT(all.size(), 1U);  // the order matters
}

TEST(BucketBooks, SayWhatTheCensusOfTheSceneSays) {
    for (const std::string& kind : {kHardware, kSoftware})
        for (const char* tile : {"8", "16x4", "7x5", "64x48"})
            for (const auto rule : {"bounding_box", "exact", "covered"}) {
                const auto machine = small_bucket(
                    kind, {kTurningCube, "run.frames=2", std::string("topology.tile=") + tile,
                           std::string("sorter.rule=") + rule});
                const auto scene = make_triangle_frames(machine);
                const RunOutcome outcome = run_machine(machine, {});
                for (std::size_t i = 0; i < 2; ++i) {
                    const auto& triangles = scene.frames[i];
                    const auto census = host::count_triangles(triangles, kSmallWidth, kSmallHeight);
                    const auto overlaps = host::count_overlaps(triangles, tiles_of(machine));
                    const std::map<host::OverlapRule, std::uint64_t> pairs{
                        {host::OverlapRule::bounding_box, overlaps.bounding_box},
                        {host::OverlapRule::exact, overlaps.exact},
                        {host::OverlapRule::covered, overlaps.covered}};
                    const BucketReport::Frame& frame = outcome.report.buckets->frames.at(i);
                    EXPECT_EQ(frame.triangles, static_cast<std::int64_t>(census.triangles));
                    EXPECT_EQ(frame.pixels, static_cast<std::int64_t>(census.pixels));
                    EXPECT_EQ(frame.pairs,
                              static_cast<std::int64_t>(pairs.at(machine.sorter.rule)));
                    EXPECT_EQ(frame.tiles,
                              static_cast<std::int64_t>(sorted(triangles, machine).size()));
                    // Some triangles lie between the samples.
                    if (machine.sorter.rule == host::OverlapRule::covered)
                        EXPECT_LE(frame.visible, static_cast<std::int64_t>(census.visible));
                    else
                        EXPECT_EQ(frame.visible, static_cast<std::int64_t>(census.visible));
                    EXPECT_DOUBLE_EQ(frame.overlap(), static_cast<double>(frame.pairs) /
                                                          static_cast<double>(frame.visible));
                }
            }
}

// What rasterizers did adds up to what the frames had for them.
void expect_dealt_out(const BucketReport& report) {
    std::int64_t pairs = 0, pixels = 0, tiles = 0;
    for (const BucketReport::Frame& frame : report.frames) {
        pairs += frame.pairs;
        pixels += frame.pixels;
        tiles += frame.tiles;
    }
    for (const BucketReport::Rasterizer& rasterizer : report.rasterizers) {
        pairs -= rasterizer.pairs;
        pixels -= rasterizer.pixels;
        tiles -= rasterizer.tiles;
    }
    EXPECT_EQ(pairs, 0);
    EXPECT_EQ(tiles, 0);
    EXPECT_EQ(pixels, report.hardware ? 0 : pixels);
}

// How long each node was at anything.
std::vector<Duration> whole_nodes(const observe::RunReport& report) {
    std::vector<Duration> whole;
    for (const observe::NodeReport& node : report.nodes) {
        whole.emplace_back();
        for (const NodePhaseStatistics& phase : node.statistics.phases)
            for (const Duration time : phase.in_state) {
                EXPECT_GE(time, Duration()) << node.name;
                whole.back() += time;
            }
        const auto& busy_with = node.statistics.busy_with;
        EXPECT_EQ(std::accumulate(busy_with.begin(), busy_with.end(), Duration()),
                  node.statistics.in_state(NodeState::busy))
            << node.name;
    }
    return whole;
}

TEST(BucketBooks, AddUpWhereSeveralDrawSeveralFrames) {
    for (const std::string& kind : {kHardware, kSoftware})
        for (const char* assignment : {"blocks", "next_free", "largest_first"}) {
            const RunOutcome outcome = run_machine(
                small_bucket(kind, {kTurningTeapot, "run.frames=3", "topology.rasterizers=3",
                                    std::string("sorter.assignment=") + assignment}),
                {});
            ASSERT_EQ(outcome.failure, "");
            expect_dealt_out(*outcome.report.buckets);
            // Processors halt when they hear of the end, the last one some cycles after the others.
            const std::int64_t halted = kind == kHardware ? 0 : 10;
            const Duration end = outcome.report.end.since_start();
            for (const Duration whole : whole_nodes(outcome.report)) {
                EXPECT_LE(whole, end);
                EXPECT_GE(whole, end - halted * Duration::nanoseconds(300));
            }
            EXPECT_EQ(outcome.report.phases.size(), 3U);
            EXPECT_EQ(outcome.report.frame_ends.size(), 3U);
        }
}

// Within a frame the units work, or wait for each other, until the last pair.
TEST(BucketBooks, SayWhatTheUnitsDidInEveryCycle) {
    for (const char* fifo : {"0", "1", "unlimited"})
        for (const char* assignment : {"interleaved", "next_free"}) {
            const auto machine = small_bucket(
                kHardware, {std::string("rasterizer.fifo=") + fifo, "topology.rasterizers=3",
                            std::string("sorter.assignment=") + assignment});
            const auto pipelines =
                drawn(sorted(make_triangle_frames(machine).frames[0], machine), machine);
            const RunOutcome outcome = run_machine(machine, {});
            for (std::size_t i = 0; i < 3; ++i) {
                const BucketReport::Rasterizer& each = outcome.report.buckets->rasterizers.at(i);
                EXPECT_EQ(each.triangle_busy, 25 * each.pairs);
                EXPECT_EQ(each.pixel_busy, each.pixels);
                EXPECT_EQ(each.triangle_busy + each.triangle_blocked + each.triangle_starved,
                          pipelines[i].free());
                EXPECT_EQ(each.pixel_busy + each.pixel_starved, pipelines[i].drawn());
                EXPECT_EQ(outcome.report.nodes.at(i).statistics.cycles, pipelines[i].drawn());
            }
        }
}

TEST(BucketBooks, AddTheSortersTimeToTheFrame) {
    for (const std::string& kind : {kHardware, kSoftware}) {
        const auto run = [&](const std::vector<std::string>& changes) {
            return run_machine(small_bucket(kind, changes), {}).report;
        };
        const observe::RunReport quick = run({"sorter.time_per_triangle=1500ns"});
        const observe::RunReport slow =
            run({"sorter.time_per_triangle=1800ns", "sorter.time_per_pair=900ns"});
        const BucketReport::Frame& frame = slow.buckets->frames.at(0);
        const Duration more =
            frame.triangles * Duration::nanoseconds(300) + frame.pairs * Duration::nanoseconds(900);
        const Duration sorting = frame.triangles * Duration::nanoseconds(1500) + more;
        EXPECT_EQ(slow.frame_ends.at(0) - quick.frame_ends.at(0), more) << kind;
        EXPECT_EQ(slow.fabric.at(0).busy, sorting);
        EXPECT_EQ(slow.fabric.at(0).part, observe::FabricPart::tile_sorter);
        EXPECT_EQ(slow.units(sorting), frame.sort_cycles);
        EXPECT_EQ(quick.buckets->frames.at(0).draw_cycles, frame.draw_cycles);
        EXPECT_EQ(run({}).buckets->frames.at(0).sort_cycles, 0);
    }
}

TEST(BucketBooks, SayOfEachFrameWhatItWouldBeAlone) {
    for (const std::string& kind : {kHardware, kSoftware}) {
        const auto frames = [&](const std::vector<std::string>& changes) {
            return run_machine(small_bucket(kind, changes), {}).report.buckets->frames;
        };
        const auto all = frames({kTurningTeapot, "run.frames=3"});
        const auto last = frames({kTurningTeapot, "scene.rotate.start=60"});
        EXPECT_NE(all.at(0).pixels, all.at(2).pixels);
        EXPECT_EQ(all.at(2).triangles, last.at(0).triangles);
        EXPECT_EQ(all.at(2).pairs, last.at(0).pairs);
        EXPECT_EQ(all.at(2).pixels, last.at(0).pixels);
        // A program begins where the frame before has left it.
        EXPECT_NEAR(static_cast<double>(all.at(2).draw_cycles),
                    static_cast<double>(last.at(0).draw_cycles), kind == kHardware ? 0 : 100);
    }
}

TEST(BucketBooks, CountAMessageForEachTileTriangleAndEndOfFrame) {
    for (const char* count : {"1", "5"}) {
        const RunOutcome outcome =
            run_machine(small_bucket(kSoftware, {"run.frames=2", "sorter.time_per_word=1us",
                                                 std::string("topology.rasterizers=") + count}),
                        {});
        const observe::RunReport& report = outcome.report;
        for (std::size_t i = 0; i < report.nodes.size(); ++i) {
            const BucketReport::Rasterizer& each = report.buckets->rasterizers.at(i);
            EXPECT_EQ(report.nodes[i].messages_received, each.tiles + each.pairs + 2);
            EXPECT_EQ(report.nodes[i].bytes_received, 12 * each.tiles + 40 * each.pairs + 2 * 4);
            const observe::FabricPartReport& feeder = report.fabric.at(1 + i);
            EXPECT_EQ(feeder.part, observe::FabricPart::tile_feeder);
            EXPECT_EQ(feeder.polygons, each.pairs);
            EXPECT_EQ(2 * feeder.words, report.nodes[i].bytes_received);
            EXPECT_EQ(feeder.busy, feeder.words * Duration::microseconds(1));
            EXPECT_LE(feeder.busy + feeder.blocked, report.end.since_start());
        }
    }
}

TEST(BucketBooks, OfAProgramAreTheSameOnSeveralThreads) {
    std::vector<std::int64_t> cycles;
    for (std::int64_t threads = 1; threads <= 4; ++threads) {
        auto machine = small_bucket(
            kSoftware, {"topology.rasterizers=5", "sorter.assignment=next_free", "run.frames=2"});
        machine.run.threads = threads;
        const RunOutcome outcome = run_machine(machine, {});
        cycles.push_back(outcome.report.cycles());
        cycles.push_back(outcome.report.buckets->frames.at(1).draw_cycles);
        EXPECT_EQ(cycles[cycles.size() - 2], cycles[0]) << threads;
        EXPECT_EQ(cycles.back(), cycles[1]) << threads;
    }
}

TEST(BucketBooks, OfARunThatIsCutOffSayHowFarItCame) {
    for (const std::string& kind : {kHardware, kSoftware}) {
        const std::string time = kind == kHardware ? "20us" : "20ms";
        const RunOutcome outcome =
            run_machine(small_bucket(kind, {"run.max_time=" + time, "topology.rasterizers=2"}), {});
        EXPECT_THAT(outcome.failure,
                    testing::HasSubstr("has not finished after " + time + " of its time"));
        EXPECT_THAT(outcome.failure, testing::HasSubstr("\n  sorter waits for "));
        EXPECT_THAT(outcome.failure, testing::HasSubstr("2 rasterizers to have drawn frame 0"));
        EXPECT_THAT(outcome.failure, testing::HasSubstr("\n  supervisor waits for "));
        EXPECT_TRUE(outcome.pictures.empty());
        ASSERT_TRUE(outcome.report.buckets);
        ASSERT_EQ(outcome.report.buckets->frames.size(), 1U);
        EXPECT_GE(outcome.report.buckets->frames[0].draw_cycles, 0);
        // Who works ahead has done so beyond the end.
        EXPECT_THAT(whole_nodes(outcome.report),
                    testing::Each(testing::Ge(outcome.report.end.since_start())));
    }
}

TEST(BucketBooks, OfARunThatIsCutOffWhileSortingSaySo) {
    const RunOutcome outcome =
        run_machine(small_bucket(kHardware, {"sorter.time_per_pair=1s", "run.max_time=1ms"}), {});
    EXPECT_THAT(outcome.failure,
                testing::HasSubstr("\n  sorter waits for the end of sorting frame 0"));
    EXPECT_EQ(outcome.report.buckets->rasterizers.at(0).pairs, 0);
}

TEST(BucketBooks, CountThePairsThatAnExactSorterWouldSpare) {
    const RunOutcome covered = run_machine(small_bucket(kHardware, {"sorter.rule=covered"}), {});
    EXPECT_EQ(covered.report.buckets->rasterizers.at(0).pairs_without_pixels, 0);
    const RunOutcome boxes = run_machine(small_bucket(kHardware), {});
    EXPECT_EQ(
        boxes.report.buckets->rasterizers.at(0).pairs_without_pixels,
        boxes.report.buckets->frames.at(0).pairs - covered.report.buckets->frames.at(0).pairs);
}

}  // namespace
}  // namespace rasterloom::emulation
