// SPDX-License-Identifier: MIT
#include "tests/fabric/tile_machine.hpp"

#include <deque>
#include <numeric>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom {
namespace {

std::vector<std::uint32_t> pixels_of(const TileFrame& frame) {
    std::vector<std::uint32_t> pixels;
    for (const TileWork& pair : frame.pairs) {
        pixels.push_back(pair.pixels);
    }
    return pixels;
}

// Each of them a triangle in a single tile.
TileFrame frame_of(const std::vector<std::uint32_t>& pixels) {
    TileFrame frame;
    for (const std::uint32_t p : pixels) {
        frame.pairs.push_back({0, frame.triangles++, p});
    }
    return frame;
}

TileMachine one_rasterizer(const RasterizerSettings& rasterizer, const TileFrame& frame) {
    TileMachineSettings settings;
    settings.rasterizer = rasterizer;
    return TileMachine(settings, {frame});
}

// Grants a tile, and never another one.
class Forgetful final : public Component {
  public:
    explicit Forgetful(std::string name) : Component(std::move(name)) { add_port("rasterizer"); }
    void start() override {
        send(PortIndex{0}, static_cast<EventKind>(TileEvent::grant),
             reinterpret_cast<std::uintptr_t>(&grant_), now());
    }
    void handle(const Event&) override {}

  private:
    TileWork pair_{0, 0, 9};
    TileGrant grant_{&pair_, 1};
};

std::int64_t cycles(const RasterizerSettings& rasterizer, const TileFrame& frame) {
    const TileMachine machine = one_rasterizer(rasterizer, frame);
    return machine.cycle_of(machine.rasterizers[0]->reached());
}

// Two units and a queue, stepped cycle by cycle; a triangle takes at least 1 cycle.
std::int64_t step_by_step(const RasterizerSettings& settings,
                          const std::vector<std::uint32_t>& pixels) {
    const std::size_t places = settings.fifo.value_or(pixels.size());
    std::deque<std::int64_t> fifo;  // cycles left of each; the pixel unit works on the first
    bool keeps = false;             // the triangle unit has a triangle that is set up
    std::int64_t kept = 0;          // its pixel unit's cycles left
    std::int64_t setting_up = 0;    // cycles left
    std::size_t next = 0;
    for (std::int64_t cycle = 0;; ++cycle) {
        // Between cycles: what is drawn goes, what is set up moves on, what is next begins.
        for (bool moves = true; moves;) {
            moves = false;
            if (!fifo.empty() && fifo.front() == 0) {
                fifo.pop_front();
                moves = true;
            }
            if (keeps && (fifo.size() < places || (places == 0 && kept == 0))) {
                if (places > 0) {
                    fifo.push_back(kept);
                }
                keeps = false;
                moves = true;
            }
            if (setting_up == 0 && !keeps && next < pixels.size()) {
                setting_up = settings.cycles_per_triangle;
                moves = true;
            }
        }
        if (fifo.empty() && !keeps && setting_up == 0) {
            return cycle;
        }
        if (!fifo.empty()) {
            --fifo.front();
        } else if (places == 0 && keeps) {
            --kept;
        }
        if (setting_up > 0 && --setting_up == 0) {
            keeps = true;
            kept = pixels[next++] * settings.cycles_per_pixel;
        }
    }
}

TEST(Rasterizer, HasTheTimesOfTheRecurrenceForAnyFifo) {
    EXPECT_TRUE(rc::check([] {
        const RasterizerSettings settings = random_rasterizer(0);
        const TileFrame frame = random_frame(1);
        const TileMachine machine = one_rasterizer(settings, frame);
        const auto& pairs = machine.heard[0].pairs;
        RC_ASSERT(pairs.size() == frame.pairs.size());
        std::vector<std::int64_t> drawn;
        std::int64_t free = 0;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const std::int64_t set_up = free + settings.cycles_per_triangle;
            const std::int64_t drawing = std::max(set_up, i > 0 ? drawn[i - 1] : 0);
            drawn.push_back(drawing + frame.pairs[i].pixels * settings.cycles_per_pixel);
            free = settings.fifo && i >= *settings.fifo
                       ? std::max(set_up, drawn[i - *settings.fifo])
                       : set_up;
            RC_ASSERT(pairs[i].work == frame.pairs[i]);
            RC_ASSERT(pairs[i].set_up.count() == set_up);
            RC_ASSERT(pairs[i].handed_over.count() == free);
            RC_ASSERT(pairs[i].drawing.count() == drawing);
            RC_ASSERT(pairs[i].drawn.count() == drawn[i]);
        }
        const Time end = settings.clock.edge(Cycles(drawn.empty() ? 0 : drawn.back()));
        RC_ASSERT(machine.rasterizers[0]->reached() == end);
        RC_ASSERT(settings.cycles_per_triangle == 0 || machine.sorter->frames().at(0).ended == end);
    }));
}

TEST(Rasterizer, FinishesWhenTwoUnitsAndAQueueSteppedCycleByCycleDo) {
    EXPECT_TRUE(rc::check([] {
        const RasterizerSettings settings = random_rasterizer(1);
        const TileFrame frame = random_frame(1);
        RC_ASSERT(cycles(settings, frame) == step_by_step(settings, pixels_of(frame)));
    }));
}

TEST(Rasterizer, TakesTheGreaterOfBothUnitsForEachPairWithOnePlace) {
    EXPECT_TRUE(rc::check([] {
        RasterizerSettings settings = random_rasterizer(0);
        settings.fifo = 1;
        settings.cycles_per_pixel = 1;
        const TileFrame frame = random_frame(1);
        RC_PRE(!frame.pairs.empty());
        const std::int64_t k = settings.cycles_per_triangle;
        std::int64_t paper = 0;  // Chen and others, 4.3
        for (const std::uint32_t pixels : pixels_of(frame)) {
            paper += std::max<std::int64_t>(k, pixels);
        }
        const std::int64_t fill = std::min<std::int64_t>(k, frame.pairs.back().pixels);
        RC_ASSERT(cycles(settings, frame) == paper + fill);
    }));
}

TEST(Rasterizer, DoesOneThingAfterTheOtherWithoutPlaces) {
    EXPECT_TRUE(rc::check([] {
        RasterizerSettings settings = random_rasterizer(0);
        settings.fifo = 0;
        const TileFrame frame = random_frame(1);
        std::int64_t sum = 0;
        for (const std::uint32_t pixels : pixels_of(frame)) {
            sum += settings.cycles_per_triangle + pixels * settings.cycles_per_pixel;
        }
        RC_ASSERT(cycles(settings, frame) == sum);
    }));
}

// Johnson 1954: the longest way through the two machines, which changes over at one of the jobs.
TEST(Rasterizer, IsAFlowShopOfTwoMachinesWithAnUnlimitedFifo) {
    EXPECT_TRUE(rc::check([] {
        RasterizerSettings settings = random_rasterizer(0);
        settings.fifo.reset();
        const TileFrame frame = random_frame(1);
        const std::vector<std::uint32_t> pixels = pixels_of(frame);
        std::int64_t longest = 0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const auto first = pixels.begin() + static_cast<std::ptrdiff_t>(i);
            const std::int64_t rest = std::accumulate(first, pixels.end(), std::int64_t{0});
            longest =
                std::max(longest, static_cast<std::int64_t>(i + 1) * settings.cycles_per_triangle +
                                      rest * settings.cycles_per_pixel);
        }
        RC_ASSERT(cycles(settings, frame) == longest);
    }));
}

TEST(Rasterizer, IsNotSlowerWithAPlaceMoreInTheFifo) {
    EXPECT_TRUE(rc::check([] {
        RasterizerSettings settings = random_rasterizer(0);
        const TileFrame frame = random_frame(1);
        settings.fifo.reset();
        const std::int64_t unlimited = cycles(settings, frame);
        settings.fifo = *rc::gen::inRange<std::size_t>(0, 70);
        const std::int64_t fewer = cycles(settings, frame);
        ++*settings.fifo;
        const std::int64_t more = cycles(settings, frame);
        RC_ASSERT(fewer >= more);
        RC_ASSERT(more >= unlimited);
        RC_ASSERT((*settings.fifo < frame.pairs.size() || more == unlimited));
    }));
}

TEST(Rasterizer, PaysForATriangleWithoutPixelsInTheTile) {
    RasterizerSettings settings;
    EXPECT_EQ(cycles(settings, frame_of({0, 0, 0})), 75);
    EXPECT_EQ(cycles(settings, frame_of({100, 0, 0, 0})), 125 + 50);
    const TileMachine machine = one_rasterizer(settings, frame_of({7, 0, 3}));
    EXPECT_EQ(machine.rasterizers[0]->statistics().pairs_without_pixels, 1);
}

TEST(Rasterizer, HasATriangleInTheFifoUntilItIsDrawn) {
    const auto peak = [](const std::vector<std::uint32_t>& pixels) {
        RasterizerSettings settings;
        settings.cycles_per_triangle = 10;
        settings.fifo.reset();
        return one_rasterizer(settings, frame_of(pixels)).rasterizers[0]->statistics().fifo_peak;
    };
    EXPECT_EQ(peak({0, 0}), 0U);
    EXPECT_EQ(peak({10, 10, 10}), 1U);
    EXPECT_EQ(peak({11, 10, 10}), 2U);
    EXPECT_EQ(peak({100, 0, 0, 0}), 4U);
}

// A machine whose rasterizer begins late, and asks for every tile.
TileMachineSettings tile_by_tile(const RasterizerSettings& rasterizer) {
    TileMachineSettings settings;
    settings.rasterizer = rasterizer;
    settings.sorter.time_per_triangle = Duration::nanoseconds(1);
    settings.sorter.queues.assignment = TileAssignment::next_free;
    settings.sorter.queues.columns = 7;
    return settings;
}

TEST(Rasterizer, DoesNotCountTheTimeBetweenFrames) {
    EXPECT_TRUE(rc::check([] {
        const TileMachineSettings settings = tile_by_tile(random_rasterizer(1));
        const TileFrame frame = random_frame(7);
        const auto counted = [&](const std::vector<TileFrame>& frames) {
            const TileMachine machine(settings, frames);
            const RasterizerStatistics s = machine.rasterizers[0]->statistics();
            return std::vector{s.triangle_busy.count(),    s.triangle_blocked.count(),
                               s.triangle_starved.count(), s.pixel_busy.count(),
                               s.pixel_starved.count(),    s.tiles};
        };
        std::vector<std::int64_t> twice = counted({frame});
        for (std::int64_t& count : twice) {
            count *= 2;
        }
        RC_ASSERT(counted({frame, frame}) == twice);
    }));
}

TEST(Rasterizer, CountsEveryCycleOfBothUnits) {
    EXPECT_TRUE(rc::check([] {
        const TileMachine machine(tile_by_tile(random_rasterizer(0)), {random_frame(7)});
        const RasterizerStatistics s = machine.rasterizers[0]->statistics();
        const auto& pairs = machine.heard[0].pairs;
        RC_ASSERT(s.pairs == static_cast<std::int64_t>(pairs.size()));
        RC_PRE(!pairs.empty());
        const Cycles begun = pairs.front().begun;
        RC_ASSERT(s.triangle_busy + s.triangle_blocked + s.triangle_starved ==
                  pairs.back().handed_over - begun);
        RC_ASSERT(s.pixel_busy + s.pixel_starved == pairs.back().drawn - begun);
        Cycles busy;
        Cycles blocked;
        std::size_t peak = 0;
        for (const DrawnPair& pair : pairs) {
            busy += pair.drawn - pair.drawing;
            blocked += pair.handed_over - pair.set_up;
            const auto in_fifo = std::count_if(pairs.begin(), pairs.end(), [&](const DrawnPair& p) {
                return p.handed_over <= pair.handed_over && pair.handed_over < p.drawn;
            });
            peak = std::max(peak, static_cast<std::size_t>(in_fifo));
        }
        RC_ASSERT(s.pixel_busy == busy);
        RC_ASSERT(s.triangle_blocked == blocked);
        RC_ASSERT(s.fifo_peak == peak);
    }));
}

TEST(Rasterizer, TellsWhatItsUnitsAreAt) {
    RasterizerSettings settings;
    settings.clock = Clock::with_period(Duration::nanoseconds(1));
    settings.cycles_per_triangle = 10;
    const TileMachine machine = one_rasterizer(settings, frame_of({30, 4, 5, 0, 3}));
    const auto told = [](const TileMachine::Intervals& unit) {
        std::vector<std::string> all;
        for (const PartInterval& interval : unit.all) {
            all.push_back(
                fmt::format("{} {}-{}", interval.state == PartState::busy ? "busy" : "blocked",
                            interval.from.picoseconds() / 1000, interval.to.picoseconds() / 1000));
        }
        return all;
    };
    EXPECT_THAT(told(machine.triangle_units[0]),
                testing::ElementsAre("busy 0-20", "blocked 20-40", "busy 40-70"));
    EXPECT_THAT(told(machine.pixel_units[0]),
                testing::ElementsAre("busy 10-44", "busy 50-55", "busy 70-73"));
}

TEST(Rasterizer, TellsTheStatesThatItCounts) {
    EXPECT_TRUE(rc::check([] {
        RasterizerSettings settings = random_rasterizer(0);
        settings.cycles_per_triangle = *rc::gen::inRange(0, 4);
        settings.clock = Clock::with_period(Duration::nanoseconds(1));
        const TileFrame frame = random_frame(7);
        const TileMachine machine(tile_by_tile(settings), {frame, frame});
        const RasterizerStatistics s = machine.rasterizers[0]->statistics();
        const auto as_cycles = [](Duration d) { return Cycles(d.picoseconds() / 1000); };
        const auto& triangle_unit = machine.triangle_units[0];
        RC_ASSERT(as_cycles(triangle_unit.sum(PartState::busy)) == s.triangle_busy);
        RC_ASSERT(as_cycles(triangle_unit.sum(PartState::blocked)) == s.triangle_blocked);
        RC_ASSERT(as_cycles(machine.pixel_units[0].sum(PartState::busy)) == s.pixel_busy);
        RC_ASSERT(machine.pixel_units[0].sum(PartState::blocked) == Duration());
    }));
}

TEST(Rasterizer, RefusesSettingsThatMeanNothing) {
    const auto refusal = [](auto change) {
        RasterizerSettings settings;
        change(settings);
        try {
            Rasterizer("R", settings);
        } catch (const std::invalid_argument& error) {
            return std::string(error.what());
        }
        return std::string("none");
    };
    EXPECT_EQ(refusal([](auto& s) { s.cycles_per_triangle = -1; }),
              "R: a triangle's and a pixel's cycles are not negative");
    EXPECT_EQ(refusal([](auto& s) { s.cycles_per_pixel = -1; }),
              "R: a triangle's and a pixel's cycles are not negative");
    EXPECT_EQ(refusal([](auto& s) { s.clock = Clock::with_period(Duration::tick()); }),
              "R: a rasterizer's cycle lasts at least 2 ps");
    EXPECT_EQ(refusal([](auto& s) { s.cycles_per_triangle = 0; }), "none");
}

TEST(Rasterizer, TellsThatItWaitsForASorterThatNeverAnswers) {
    Simulation simulation;
    auto& sorter = simulation.add<Forgetful>("sorter");
    auto& rasterizer = simulation.add<Rasterizer>("rasterizer", RasterizerSettings());
    simulation.connect(sorter, PortIndex{0}, rasterizer, Rasterizer::kSorter, Duration::tick());
    simulation.seal();
    const RunResult result = simulation.run();
    ASSERT_NE(result.failure, nullptr);
    EXPECT_THAT(result.failure->message(),
                testing::HasSubstr(
                    "rasterizer waits for the next tile, or the end of the frame (granted: 1)"));
}

}  // namespace
}  // namespace rasterloom
