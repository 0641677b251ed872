// SPDX-License-Identifier: MIT
// The bucket tiler as a whole: a sorter and many rasterizers.
#include "tests/fabric/tile_machine.hpp"

#include <map>
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom {
namespace {

// Never answers.
class Silent final : public Component {
  public:
    explicit Silent(std::string name) : Component(std::move(name)) { add_port("anybody"); }
    void handle(const Event&) override {}
};

// Gives back more than its own credit.
class Spendthrift final : public Component {
  public:
    explicit Spendthrift(std::string name) : Component(std::move(name)) { add_port("supervisor"); }
    void start() override {
        send(PortIndex{0}, static_cast<EventKind>(SupervisorEvent::credit), credit_payload({-2, 0}),
             now());
    }
    void handle(const Event&) override {}
};

TileMachineSettings random_machine(int least_k) {
    TileMachineSettings settings;
    settings.rasterizer = random_rasterizer(least_k);
    settings.sorter.queues = random_queues();
    return settings;
}

TEST(TileSorter, HasEveryPairDrawnOnceTileByTileInTheOrderOfTheTriangles) {
    EXPECT_TRUE(rc::check([] {
        const TileMachineSettings settings = random_machine(0);
        const TileFrame frame = random_frame(tiles_of(settings.sorter.queues));
        const TileMachine machine(settings, {frame});
        std::map<TileIndex, std::vector<TileWork>> expected;
        for (const TileWork& pair : frame.pairs) {
            expected[pair.tile].push_back(pair);
        }
        std::map<TileIndex, std::vector<TileWork>> drawn;
        std::int64_t tiles = 0;
        for (std::size_t r = 0; r < machine.rasterizers.size(); ++r) {
            std::set<TileIndex> begun;
            const auto& pairs = machine.heard[r].pairs;
            for (std::size_t i = 0; i < pairs.size(); ++i) {
                const TileIndex tile = pairs[i].work.tile;
                drawn[tile].push_back(pairs[i].work);
                if (i == 0 || pairs[i - 1].work.tile != tile) {
                    RC_ASSERT(begun.insert(tile).second);
                }
            }
            tiles += machine.rasterizers[r]->statistics().tiles;
        }
        RC_ASSERT(drawn == expected);
        RC_ASSERT(tiles == static_cast<std::int64_t>(expected.size()));
    }));
}

TEST(TileSorter, LeavesATileToItsOwner) {
    EXPECT_TRUE(rc::check([] {
        TileMachineSettings settings = random_machine(0);
        TileQueueSettings& queues = settings.sorter.queues;
        queues.assignment = *rc::gen::element(TileAssignment::interleaved, TileAssignment::blocks);
        const auto owners =
            owners_of_tiles(queues.assignment, queues.columns, queues.rows, queues.rasterizers);
        const TileMachine machine(settings, random_frames(settings.sorter.queues));
        for (std::size_t r = 0; r < machine.rasterizers.size(); ++r) {
            for (const DrawnPair& pair : machine.heard[r].pairs) {
                RC_ASSERT(owners[pair.work.tile] == r);
            }
        }
    }));
}

// Of the tiles in the order in which they are handed out, each to the rasterizer whose triangle
// unit is free first; of equals, to the one whose name comes first.
TEST(TileSorter, GivesTheNextTileToTheRasterizerThatIsFreeFirst) {
    EXPECT_TRUE(rc::check([] {
        TileMachineSettings settings = random_machine(1);
        TileQueueSettings& queue = settings.sorter.queues;
        queue.assignment =
            *rc::gen::element(TileAssignment::next_free, TileAssignment::largest_first);
        const TileFrame frame = random_frame(tiles_of(settings.sorter.queues));
        const TileMachine machine(settings, {frame});
        TileQueues order(queue);
        order.fill(frame.pairs);
        std::vector<std::int64_t> free(machine.rasterizers.size());
        std::vector<std::size_t> next(free.size());
        while (const TileGrant* grant = order.take(0)) {
            const auto first =
                static_cast<std::size_t>(std::min_element(free.begin(), free.end()) - free.begin());
            const auto& pairs = machine.heard[first].pairs;
            RC_ASSERT(next[first] < pairs.size());
            RC_ASSERT(pairs[next[first]].work == grant->front());
            RC_ASSERT(pairs[next[first]].begun.count() == free[first]);
            next[first] += grant->size();
            free[first] = pairs[next[first] - 1].handed_over.count();
        }
    }));
}

TEST(TileSorter, EndsTheFrameWhenTheLastRasterizerHasDrawnItsLastTriangle) {
    EXPECT_TRUE(rc::check([] {
        const TileMachineSettings settings = random_machine(1);
        const TileMachine machine(settings, {random_frame(tiles_of(settings.sorter.queues))});
        Cycles last;
        for (const TileMachine::Heard& heard : machine.heard) {
            last = std::max(last, heard.pairs.empty() ? Cycles() : heard.pairs.back().drawn);
        }
        RC_ASSERT(machine.sorter->frames().at(0).ended == settings.rasterizer.clock.edge(last));
    }));
}

TEST(TileSorter, MakesNoDifferenceToASingleRasterizerByHandingOutTilesOneByOne) {
    EXPECT_TRUE(rc::check([] {
        TileMachineSettings settings = random_machine(1);
        settings.sorter.queues.rasterizers = 1;
        const TileFrame frame = random_frame(tiles_of(settings.sorter.queues));
        settings.sorter.queues.assignment = TileAssignment::next_free;
        const TileMachine one_by_one(settings, {frame});
        settings.sorter.queues.assignment = TileAssignment::interleaved;
        const TileMachine at_once(settings, {frame});
        RC_ASSERT(one_by_one.drawing_cycles() == at_once.drawing_cycles());
    }));
}

TEST(TileSorter, SortsTheWholeFrameBeforeAnythingIsDrawn) {
    TileMachineSettings settings;
    settings.sorter.time_per_triangle = Duration::nanoseconds(100);
    settings.sorter.time_per_pair = Duration::nanoseconds(7);
    settings.sorter.queues.columns = 2;
    settings.rasterizer.clock = Clock::with_period(Duration::nanoseconds(10));
    const TileFrame frame{5, {{1, 0, 40}, {0, 0, 50}, {0, 3, 10}}};
    const TileMachine machine(settings, {frame, {}, {4, {}}, frame});
    const std::vector<TileFrameRecord>& frames = machine.sorter->frames();
    ASSERT_EQ(frames.size(), 4U);
    EXPECT_EQ(frames[0].sorted - frames[0].began, Duration::nanoseconds(5 * 100 + 3 * 7));
    EXPECT_EQ(machine.heard[0].pairs[0].begun, Cycles(53));  // the first edge from 521 ns on
    EXPECT_EQ(frames[0].ended, machine.clock.edge(Cycles(53 + 25 + 50 + 25 + 40)));
    EXPECT_EQ(frames[1].began, frames[0].ended);
    EXPECT_EQ(frames[1].ended, frames[1].began) << "an empty frame takes no time";
    EXPECT_EQ(frames[2].ended - frames[2].began, Duration::nanoseconds(400));
    EXPECT_EQ(frames[3].began, frames[2].ended);
    EXPECT_EQ(machine.sorter->statistics().triangles, 14);
    EXPECT_EQ(machine.sorter->statistics().pairs, 6);
    EXPECT_EQ(machine.sorter->statistics().busy, Duration::nanoseconds(2 * 521 + 400));
    EXPECT_EQ(machine.sorting.sum(PartState::busy), Duration::nanoseconds(2 * 521 + 400));
}

TEST(TileSorter, DrawsTheSameFrameInTheSameTimeAgain) {
    EXPECT_TRUE(rc::check([] {
        const TileMachineSettings settings = random_machine(1);
        const TileFrame frame = random_frame(tiles_of(settings.sorter.queues));
        const TileMachine machine(settings, {frame, frame});
        RC_ASSERT(machine.drawing_cycles(0) == machine.drawing_cycles(1));
    }));
}

// Nothing else gives work to the supervisor, so a phase is a frame, and takes half the latency to
// be counted.
TEST(TileSorter, BeginsAFrameWhenTheSupervisorHasSeenTheOneBeforeDrawn) {
    EXPECT_TRUE(rc::check([] {
        TileMachineSettings settings = random_machine(1);
        settings.sorter.time_per_triangle = Duration::picoseconds(*rc::gen::inRange(0, 2));
        settings.sorter.supervised = true;
        settings.supervisor.latency = Duration::picoseconds(*rc::gen::inRange(2, 90'000));
        settings.supervisor.frames = *rc::gen::inRange(1, 7);
        const std::vector<TileFrame> frames = random_frames(settings.sorter.queues);
        const TileMachine machine(settings, frames);
        RC_ASSERT(machine.result.end == RunEnd::finished);
        const std::vector<TileFrameRecord>& records = machine.sorter->frames();
        RC_ASSERT(static_cast<int>(records.size()) == settings.supervisor.frames);
        RC_ASSERT(records.size() == machine.phases.all.size());
        std::int64_t pairs = 0;
        for (std::size_t k = 0; k < records.size(); ++k) {
            pairs += static_cast<std::int64_t>(frames[k % frames.size()].pairs.size());
            RC_ASSERT(records[k].began == machine.phases.all[k].began);
            if (k > 0) {
                RC_ASSERT(records[k].began == records[k - 1].ended + settings.supervisor.latency);
            }
        }
        RC_ASSERT(machine.sorter->statistics().pairs == pairs);
    }));
}

// What a supervised sorter's rasterizers draw, and how long they take, is what they do in frames
// that follow each other at once; what they count sums up.
TEST(TileSorter, DrawsUnderASupervisorWhatItDrawsWithoutOne) {
    EXPECT_TRUE(rc::check([] {
        TileMachineSettings settings = random_machine(1);
        const TileFrame first = random_frame(tiles_of(settings.sorter.queues));
        const TileFrame second = random_frame(tiles_of(settings.sorter.queues));
        const TileMachine alone(settings, {first, second, first});
        settings.sorter.supervised = true;
        settings.supervisor.frames = 3;
        // Whole cycles of every clock, so that frames begin at an edge.
        settings.supervisor.latency = Duration::microseconds(1);
        const TileMachine supervised(settings, {first, second});
        for (std::size_t frame = 0; frame < 3; ++frame) {
            RC_ASSERT(alone.drawing_cycles(frame) == supervised.drawing_cycles(frame));
        }
        for (std::size_t r = 0; r < alone.rasterizers.size(); ++r) {
            RC_ASSERT(alone.heard[r].pairs.size() == supervised.heard[r].pairs.size());
            const RasterizerStatistics& a = alone.rasterizers[r]->statistics();
            const RasterizerStatistics& b = supervised.rasterizers[r]->statistics();
            RC_ASSERT(a.tiles == b.tiles);
            RC_ASSERT(a.pixels == b.pixels);
            RC_ASSERT(a.triangle_busy == b.triangle_busy);
            RC_ASSERT(a.pixel_starved == b.pixel_starved);
        }
    }));
}

TEST(TileSorter, HasEmptyFramesWhenItIsToDrawNothing) {
    TileMachineSettings settings;
    settings.sorter.supervised = true;
    settings.supervisor.frames = 3;
    const TileMachine machine(settings, {});
    EXPECT_EQ(machine.result.end, RunEnd::finished);
    EXPECT_EQ(machine.sorter->frames().size(), 3U);
}

TEST(TileSorter, TellsThatItWaitsForAPhaseThatDoesNotCome) {
    TileMachineSettings settings;
    settings.sorter.supervised = true;
    Simulation simulation;
    auto& sorter = simulation.add<TileSorter>("sorter", settings.sorter);
    auto& rasterizer = simulation.add<Rasterizer>("rasterizer", settings.rasterizer);
    sorter.connect(simulation, 0, rasterizer);
    auto& supervisor = simulation.add<Silent>("supervisor");
    simulation.connect(sorter, sorter.supervisor_port(), supervisor, PortIndex{0},
                       Duration::tick());
    simulation.seal();
    const RunResult result = simulation.run();
    ASSERT_NE(result.failure, nullptr);
    EXPECT_THAT(result.failure->message(),
                testing::HasSubstr("sorter waits for the phase that begins frame 1"));
}

TEST(TileSorter, EndsTheRunWhenAPhaseEndsBeforeTheFrameIsDrawn) {
    TileMachineSettings settings;
    settings.sorter.supervised = true;
    settings.sorter.time_per_triangle = Duration::milliseconds(1);
    Simulation simulation;
    auto& sorter = simulation.add<TileSorter>("sorter", settings.sorter);
    sorter.connect(simulation, 0, simulation.add<Rasterizer>("rasterizer", settings.rasterizer));
    settings.supervisor.nodes = 2;
    auto& supervisor = simulation.add<Supervisor>("supervisor", settings.supervisor);
    supervisor.connect(simulation, 0, sorter, sorter.supervisor_port());
    supervisor.connect(simulation, 1, simulation.add<Spendthrift>("spendthrift"), PortIndex{0});
    sorter.load({{1, {}}});
    simulation.seal();
    const RunResult result = simulation.run();
    ASSERT_NE(result.failure, nullptr);
    EXPECT_THAT(result.failure->message(),
                testing::HasSubstr("sorter: a phase ends while frame 0 is being drawn"));
}

std::string all_times(const TileMachine& machine) {
    std::string all;
    for (const TileFrameRecord& frame : machine.sorter->frames()) {
        all += fmt::format("{} {} {}\n", frame.began.picoseconds(), frame.sorted.picoseconds(),
                           frame.ended.picoseconds());
    }
    for (const TileMachine::Heard& heard : machine.heard) {
        for (const DrawnPair& pair : heard.pairs) {
            all += fmt::format("{}/{}: {} {} {} {} {}\n", pair.work.tile, pair.work.triangle,
                               pair.begun.count(), pair.set_up.count(), pair.handed_over.count(),
                               pair.drawing.count(), pair.drawn.count());
        }
        all += "-\n";
    }
    return all;
}

TEST(TileSorter, DoesTheSameOnAnyNumberOfThreads) {
    EXPECT_TRUE(rc::check([] {
        TileMachineSettings settings = random_machine(0);
        const std::vector<TileFrame> frames = random_frames(settings.sorter.queues);
        const std::string alone = all_times(TileMachine(settings, frames));
        settings.threads = *rc::gen::inRange<std::size_t>(2, 5);
        const TileMachine divided(settings, frames);
        RC_ASSERT(divided.simulation.partitions() > 1U);
        RC_ASSERT(all_times(divided) == alone);
    }));
}

TEST(TileSorter, RefusesPairsOfTilesAndTrianglesThatThereAreNot) {
    TileSorterSettings settings = unsupervised();
    settings.queues.columns = 3;
    settings.queues.rows = 2;
    TileSorter sorter("sorter", settings);
    EXPECT_THAT(
        [&] {
            sorter.load({{}, {1, {{5, 0, 1}, {6, 0, 1}}}});
        },
        testing::ThrowsMessage<std::invalid_argument>(
            "pair 1 of frame 1: there is no tile 6 of 6"));
    EXPECT_THAT(
        [&] {
            sorter.load({{2, {{5, 2, 1}}}});
        },
        testing::ThrowsMessage<std::invalid_argument>(
            "pair 0 of frame 0: there is no triangle 2 of 2"));
    settings.time_per_pair = Duration::picoseconds(-1);
    EXPECT_THAT([&] { TileSorter("sorter", settings); },
                testing::ThrowsMessage<std::invalid_argument>(
                    "sorter: the time to sort a triangle or a pair is not negative"));
}

}  // namespace
}  // namespace rasterloom
