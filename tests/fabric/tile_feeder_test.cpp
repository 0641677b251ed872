// SPDX-License-Identifier: MIT
// The bucket tiler with software rasterizers: a sorter, feeders, and what takes their messages.
#include "tests/fabric/tile_feeder_machine.hpp"

#include <map>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom {
namespace {

using testing::HasSubstr;

FeederMachineSettings random_machine() {
    FeederMachineSettings settings;
    settings.sorter.queues = random_queues();
    settings.feeder.receiver_places = settings.taker.places = *rc::gen::inRange(1, 6);
    settings.feeder.time_per_word = Duration::picoseconds(*rc::gen::element(0, 1, 7));
    settings.feeder.latency = Duration::picoseconds(*rc::gen::inRange(1, 20));
    settings.taker.longest_work = *rc::gen::element(0, 10, 1000);
    return settings;
}

FeederMachineSettings random_supervised_machine() {
    FeederMachineSettings settings = random_machine();
    settings.sorter.supervised = true;
    settings.sorter.time_per_pair = Duration::picoseconds(*rc::gen::inRange(0, 3));
    settings.supervisor.frames = *rc::gen::inRange(1, 6);
    settings.supervisor.latency = Duration::picoseconds(*rc::gen::inRange(2, 3000));
    return settings;
}

FeederMachine machine_of(const FeederMachineSettings& settings,
                         const std::vector<TileFrame>& frames) {
    return {settings, frames, scene_of(settings.sorter.queues, frames)};
}

TriangleMessage kind_of(const Taker::Taken& taken) {
    return kind_of_triangle_message(taken.message.bytes);
}

// What a taker was sent, by frames; within each, by tiles.
struct TakenTile {
    topology::PixelBox box;
    std::vector<TriangleCorners> triangles;
};
std::vector<std::vector<TakenTile>> frames_taken(const Taker& taker) {
    std::vector<std::vector<TakenTile>> frames(1);
    for (const Taker::Taken& taken : taker.taken) {
        switch (kind_of(taken)) {
            case TriangleMessage::tile:
                frames.back().push_back({read_tile(taken.message.bytes), {}});
                break;
            case TriangleMessage::triangle:
                frames.back().back().triangles.push_back(read_triangle(taken.message.bytes));
                break;
            case TriangleMessage::end_of_frame:
                frames.emplace_back();
                break;
        }
    }
    return frames;
}

// The pairs of a frame that go to rasterizers, as they are to be drawn: by tile.
std::map<TileIndex, std::vector<TriangleCorners>> expected_tiles(
    const TileFrame& frame, const std::vector<TriangleCorners>& triangles) {
    std::map<TileIndex, std::vector<TriangleCorners>> tiles;
    for (const TileWork& pair : frame.pairs) {
        tiles[pair.tile].push_back(triangles[pair.triangle]);
    }
    return tiles;
}

TEST(TileFeeder, SendsEveryTileOfAFrameOnceWithItsTrianglesInTheirOrderAndTheEnd) {
    EXPECT_TRUE(rc::check([] {
        const FeederMachineSettings settings = random_supervised_machine();
        const std::vector<TileFrame> frames = random_frames(settings.sorter.queues);
        const auto scene = scene_of(settings.sorter.queues, frames);
        const FeederMachine machine(settings, frames, scene);
        RC_ASSERT(machine.result.end == RunEnd::finished);
        const auto run = static_cast<std::size_t>(settings.supervisor.frames);
        std::vector<std::map<TileIndex, std::vector<TriangleCorners>>> sent(run);
        for (const Taker* taker : machine.takers) {
            const auto taken = frames_taken(*taker);
            RC_ASSERT(taken.size() == run + 1);
            RC_ASSERT(taken.back().empty());
            for (std::size_t k = 0; k < run; ++k) {
                for (const TakenTile& tile : taken[k]) {
                    const TileIndex index = scene->tiles.tile_at(tile.box.x0, tile.box.y0);
                    RC_ASSERT(tile.box == scene->tiles.box_of(index));
                    RC_ASSERT(sent[k].emplace(index, tile.triangles).second);
                }
            }
        }
        for (std::size_t k = 0; k < run; ++k) {
            const std::size_t frame = k % frames.size();
            RC_ASSERT(sent[k] == expected_tiles(frames[frame], scene->frames[frame]));
        }
    }));
}

TEST(TileFeeder, LeavesATileToItsOwner) {
    EXPECT_TRUE(rc::check([] {
        FeederMachineSettings settings = random_machine();
        TileQueueSettings& queues = settings.sorter.queues;
        queues.assignment = *rc::gen::element(TileAssignment::interleaved, TileAssignment::blocks);
        const auto owners =
            owners_of_tiles(queues.assignment, queues.columns, queues.rows, queues.rasterizers);
        const std::vector<TileFrame> frames = {random_frame(tiles_of(queues))};
        const auto scene = scene_of(queues, frames);
        const FeederMachine machine(settings, frames, scene);
        for (std::size_t r = 0; r < machine.takers.size(); ++r) {
            const auto taken = frames_taken(*machine.takers[r]);
            for (const TakenTile& tile : taken.front()) {
                RC_ASSERT(owners[scene->tiles.tile_at(tile.box.x0, tile.box.y0)] == r);
            }
        }
    }));
}

Duration transfer_of(const Taker::Taken& taken, const TileFeederSettings& feeder) {
    return static_cast<std::int64_t>(taken.message.bytes.size() / 2) * feeder.time_per_word;
}

// A message's times from those of the messages before: all that a single feeder is to send it gets
// at once.
TEST(TileFeeder, TakesItsTimeForEveryWordAndIsBlockedWhileTheReceiverHasNoPlace) {
    EXPECT_TRUE(rc::check([] {
        FeederMachineSettings settings = random_machine();
        settings.sorter.queues.rasterizers = 1;
        settings.sorter.queues.assignment = TileAssignment::interleaved;
        TileFrame frame = random_frame(tiles_of(settings.sorter.queues));
        frame.pairs.push_back({0, 0, 1});
        const FeederMachine machine = machine_of(settings, {frame});
        const auto& taken = machine.takers[0]->taken;
        const auto places = static_cast<std::size_t>(settings.taker.places);
        TileFeederStatistics expected;
        Time left = Time::zero() + Duration::tick();  // the grant comes
        for (std::size_t i = 0; i < taken.size(); ++i) {
            const Message& message = taken[i].message;
            const bool last = i + 1 == taken.size();
            const Time queued = left + (last ? 2 * Duration::tick() : Duration());
            const Time place = i < places ? queued : taken[i - places].at + settings.feeder.latency;
            RC_ASSERT(message.queued == queued);
            RC_ASSERT(message.started == std::max(queued, place));
            left = message.started + transfer_of(taken[i], settings.feeder);
            RC_ASSERT(message.delivered == left + settings.feeder.latency);
            RC_ASSERT(message.id == i);
            expected.tiles += kind_of(taken[i]) == TriangleMessage::tile ? 1 : 0;
            expected.triangles += kind_of(taken[i]) == TriangleMessage::triangle ? 1 : 0;
            expected.words += static_cast<std::int64_t>(message.bytes.size() / 2);
            expected.busy += left - message.started;
            expected.blocked += message.started - queued;
        }
        const TileFeederStatistics& counted = machine.feeders[0]->statistics();
        RC_ASSERT(counted.tiles == expected.tiles);
        RC_ASSERT(counted.triangles == expected.triangles);
        RC_ASSERT(counted.words == expected.words);
        RC_ASSERT(counted.busy == expected.busy);
        RC_ASSERT(counted.blocked == expected.blocked);
        RC_ASSERT(machine.intervals[0].sum(PartState::busy) == expected.busy);
        RC_ASSERT(machine.intervals[0].sum(PartState::blocked) == expected.blocked);
    }));
}

// Dynamic assignment: to the one whose last triangle has left first; of equals, to the one whose
// name comes first. The tile before has cost it two ticks.
TEST(TileFeeder, AsksForTheNextTileWhenTheLastTriangleOfTheOneBeforeHasLeft) {
    EXPECT_TRUE(rc::check([] {
        FeederMachineSettings settings = random_machine();
        TileQueueSettings& queues = settings.sorter.queues;
        queues.assignment =
            *rc::gen::element(TileAssignment::next_free, TileAssignment::largest_first);
        const TileFrame frame = random_frame(tiles_of(queues));
        const FeederMachine machine = machine_of(settings, {frame});
        TileQueues order(queues);
        order.fill(frame.pairs);
        std::vector<Time> free(machine.takers.size(), Time::zero() - Duration::tick());
        std::vector<std::size_t> next(free.size());
        while (const TileGrant* grant = order.take(0)) {
            const auto first =
                static_cast<std::size_t>(std::min_element(free.begin(), free.end()) - free.begin());
            const auto& taken = machine.takers[first]->taken;
            RC_ASSERT(next[first] + grant->size() < taken.size());
            RC_ASSERT(kind_of(taken[next[first]]) == TriangleMessage::tile);
            RC_ASSERT(taken[next[first]].message.queued == free[first] + 2 * Duration::tick());
            const Taker::Taken& last = taken[next[first] + grant->size()];
            RC_ASSERT(read_triangle(last.message.bytes)[0].x ==
                      static_cast<std::int16_t>(grant->back().triangle));
            next[first] += grant->size() + 1;
            free[first] = last.message.started + transfer_of(last, settings.feeder);
        }
    }));
}

TEST(TileFeeder, LetsThePhaseEndWhenAllHasBeenSentAndEveryReceiverHasTakenTheEndOfTheFrame) {
    EXPECT_TRUE(rc::check([] {
        const FeederMachineSettings settings = random_supervised_machine();
        const std::vector<TileFrame> frames = random_frames(settings.sorter.queues);
        const FeederMachine machine = machine_of(settings, frames);
        const std::vector<TileFrameRecord>& records = machine.sorter->frames();
        const auto run = static_cast<std::size_t>(settings.supervisor.frames);
        RC_ASSERT(records.size() == run);
        std::vector<Time> sent(run);
        std::vector<Time> taken_by_all(run);
        for (const Taker* taker : machine.takers) {
            std::size_t frame = 0;
            for (const Taker::Taken& taken : taker->taken) {
                if (kind_of(taken) == TriangleMessage::end_of_frame) {
                    const Time left = taken.message.delivered - settings.feeder.latency;
                    sent[frame] = std::max(sent[frame], left);
                    taken_by_all[frame] = std::max(taken_by_all[frame], taken.at);
                    ++frame;
                }
            }
        }
        for (std::size_t k = 0; k < run; ++k) {
            RC_ASSERT(records[k].ended == sent[k] + Duration::tick());
            const Time done = std::max(records[k].ended, taken_by_all[k]);
            if (k + 1 < run) {
                RC_ASSERT(records[k + 1].began == done + settings.supervisor.latency);
            }
        }
    }));
}

std::string all_times(const FeederMachine& machine) {
    std::string all;
    for (const TileFrameRecord& frame : machine.sorter->frames()) {
        all += fmt::format("{} {} {}\n", frame.began.picoseconds(), frame.sorted.picoseconds(),
                           frame.ended.picoseconds());
    }
    for (std::size_t r = 0; r < machine.takers.size(); ++r) {
        for (const Taker::Taken& taken : machine.takers[r]->taken) {
            const Message& message = taken.message;
            all += fmt::format("{:02x} {} {} {} {} {}\n", fmt::join(message.bytes, ""), message.id,
                               message.queued.picoseconds(), message.started.picoseconds(),
                               message.delivered.picoseconds(), taken.at.picoseconds());
        }
        const TileFeederStatistics& statistics = machine.feeders[r]->statistics();
        all +=
            fmt::format("{} {}\n", statistics.busy.picoseconds(), statistics.blocked.picoseconds());
    }
    return all;
}

TEST(TileFeeder, DoesTheSameOnAnyNumberOfThreads) {
    EXPECT_TRUE(rc::check([] {
        FeederMachineSettings settings = random_supervised_machine();
        const std::vector<TileFrame> frames = random_frames(settings.sorter.queues);
        const std::string alone = all_times(machine_of(settings, frames));
        settings.threads = *rc::gen::inRange<std::size_t>(2, 5);
        const FeederMachine divided = machine_of(settings, frames);
        RC_ASSERT(divided.simulation.partitions() > 1U);
        RC_ASSERT(all_times(divided) == alone);
    }));
}

// Two pairs of tile 1; a receiver with one place stops after so many messages.
std::string deadlock_after(std::size_t takes) {
    FeederMachineSettings settings;
    settings.sorter.supervised = true;
    settings.sorter.queues.columns = 2;
    settings.feeder.receiver_places = settings.taker.places = 1;
    settings.taker.takes = takes;
    const FeederMachine machine = machine_of(settings, {{6, {{1, 4, 1}, {1, 5, 1}}}});
    return machine.result.failure == nullptr ? "none" : machine.result.failure->message();
}

TEST(TileFeeder, TellsWhatItWaitsForWhenTheReceiverStops) {
    EXPECT_THAT(deadlock_after(0),
                HasSubstr("feeder/000 waits for a place for triangle 4 in tile 1 of frame 0"));
    EXPECT_THAT(deadlock_after(1), HasSubstr("a place for triangle 5 in tile 1 of frame 0"));
    EXPECT_THAT(deadlock_after(2),
                HasSubstr("feeder/000 waits for a place for the end of frame 0"));
    EXPECT_THAT(deadlock_after(2),
                HasSubstr("sorter waits for 1 of 1 rasterizers to have drawn frame 0"));
    EXPECT_THAT(deadlock_after(3), testing::Not(HasSubstr("feeder")))
        << "it has sent all that it was to send";
}

TEST(TileFeeder, RefusesSettingsOutOfRangeAndAnEmptyScene) {
    const auto refuses = [](const TileFeederSettings& settings, const char* why) {
        EXPECT_THAT([&] { TileFeeder("feeder", settings); },
                    testing::ThrowsMessage<std::invalid_argument>(why));
    };
    TileFeederSettings settings;
    settings.receiver_places = 0;
    refuses(settings, "feeder: a FIFO holds at least 1 message");
    settings = {};
    settings.time_per_word = Duration::picoseconds(-1);
    refuses(settings, "feeder: the time to transfer a word is not negative");
    settings = {};
    settings.latency = Duration();
    refuses(settings, "feeder: the latency is at least 1 ps");
    auto scene = std::make_shared<TileScene>();
    scene->frames.clear();
    TileFeeder feeder("feeder", {});
    EXPECT_THAT([&] { feeder.load(scene); }, testing::ThrowsMessage<std::invalid_argument>(
                                                 "feeder: a scene has at least 1 frame"));
}

}  // namespace
}  // namespace rasterloom
