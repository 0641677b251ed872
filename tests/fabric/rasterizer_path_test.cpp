// SPDX-License-Identifier: MIT
#include "machine/fabric/rasterizer_path.hpp"

#include "tests/fabric/tile_machine.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom {
namespace {

using ::testing::ElementsAre;

// One tile's pairs, and a rasterizer that draws them.
struct Drawn {
    Drawn(const RasterizerSettings& settings, const std::vector<std::uint32_t>& pixels)
        : machine(settings_for(settings), {frame_of(pixels)}),
          rasterizer(*machine.rasterizers.front()),
          pairs(machine.heard.front().pairs) {}

    static TileMachineSettings settings_for(const RasterizerSettings& rasterizer) {
        TileMachineSettings settings;
        settings.rasterizer = rasterizer;
        return settings;
    }
    static TileFrame frame_of(const std::vector<std::uint32_t>& pixels) {
        TileFrame frame;
        for (const std::uint32_t p : pixels) {
            frame.pairs.push_back({0, frame.triangles++, p});
        }
        return frame;
    }
    std::int64_t end() const { return pairs.back().drawn.count(); }

    TileMachine machine;
    const Rasterizer& rasterizer;
    const std::vector<DrawnPair>& pairs;
};

RasterizerSettings of(std::int64_t per_triangle, std::int64_t per_pixel,
                      std::optional<std::size_t> fifo) {
    RasterizerSettings settings;
    settings.cycles_per_triangle = per_triangle;
    settings.cycles_per_pixel = per_pixel;
    settings.fifo = fifo;
    return settings;
}

std::optional<std::size_t> any_fifo() {
    return *rc::gen::element<std::optional<std::size_t>>(0U, 1U, 2U, 3U, 7U, std::nullopt);
}

std::vector<std::uint32_t> any_pixels() {
    return *rc::gen::nonEmpty(rc::gen::container<std::vector<std::uint32_t>>(
        rc::gen::map(rc::gen::inRange(0, 60),
                     [](int p) { return static_cast<std::uint32_t>(p < 20 ? 0 : p); })));
}

TEST(RasterizerPath, IsSetUpWhereTheTriangleUnitIsTheSlowerOne) {
    const Drawn drawn(of(10, 1, 1), {3, 5, 2});
    EXPECT_THAT(limiting_units(drawn.pairs, 1, false),
                ElementsAre(LimitingUnit{false, Cycles(0), Cycles(30)}));
}

TEST(RasterizerPath, IsPixelsAfterTheFirstSetUpWhereThePixelUnitIs) {
    const Drawn drawn(of(10, 1, 1), {30, 40, 50});
    EXPECT_THAT(limiting_units(drawn.pairs, 1, false),
                ElementsAre(LimitingUnit{false, Cycles(0), Cycles(10)},
                            LimitingUnit{true, Cycles(10), Cycles(80)}));
}

TEST(RasterizerPath, ChangesWhereTheSetUpOfATriangleIsAwaited) {
    const Drawn drawn(of(10, 1, std::nullopt), {15, 1, 1, 40});
    EXPECT_THAT(limiting_units(drawn.pairs, std::nullopt, false),
                ElementsAre(LimitingUnit{false, Cycles(0), Cycles(40)}));
    const Drawn blocked(of(10, 1, 0), {15, 1});
    EXPECT_THAT(limiting_units(blocked.pairs, 0, false),
                ElementsAre(LimitingUnit{false, Cycles(0), Cycles(10)},
                            LimitingUnit{true, Cycles(10), Cycles(25)},
                            LimitingUnit{false, Cycles(25), Cycles(35)},
                            LimitingUnit{true, Cycles(35), Cycles(36)}));
}

TEST(RasterizerPath, LeavesOutWhatNobodyWaitsFor) {
    const Drawn drawn(of(10, 1, std::nullopt), {40, 1, 1});
    EXPECT_THAT(limiting_units(drawn.pairs, std::nullopt, true),
                ElementsAre(LimitingUnit{false, Cycles(0), Cycles(10)},
                            LimitingUnit{true, Cycles(10), Cycles(52)}));
    EXPECT_THAT(limiting_units(drawn.pairs, std::nullopt, false),
                ElementsAre(LimitingUnit{false, Cycles(0), Cycles(30)}));
}

TEST(RasterizerPath, LiesEndToEnd) {
    EXPECT_TRUE(rc::check([] {
        const auto fifo = any_fifo();
        const Drawn drawn(of(*rc::gen::inRange(0, 40), *rc::gen::inRange(0, 3), fifo),
                          any_pixels());
        Cycles at = drawn.pairs.front().begun;
        std::optional<bool> before;
        const bool until_drawn = *rc::gen::arbitrary<bool>();
        for (const LimitingUnit& unit : limiting_units(drawn.pairs, fifo, until_drawn)) {
            RC_ASSERT(unit.from == at);
            RC_ASSERT(unit.to > unit.from);
            RC_ASSERT(before != unit.is_pixel_unit);
            before = unit.is_pixel_unit;
            at = unit.to;
        }
        const DrawnPair& last = drawn.pairs.back();
        RC_ASSERT(at == (until_drawn ? last.drawn : last.handed_over));
    }));
}

// Of several longest ways one is told: a longer set-up makes the frame longer by no less than it
// has of it, a shorter one makes it shorter by no more.
TEST(RasterizerPath, HasAsManySetUpsAsALongerSetUpIsFeltTimes) {
    EXPECT_TRUE(rc::check([] {
        constexpr std::int64_t kMany = 1'000;  // cycles in place of one: more than there are pairs
        const auto fifo = any_fifo();
        const auto pixels = any_pixels();
        RC_PRE(pixels.size() < static_cast<std::size_t>(kMany));
        const std::int64_t k = *rc::gen::inRange(1, 40);
        const auto end = [&](std::int64_t per_triangle) {
            return Drawn(of(per_triangle, kMany, fifo), pixels).end();
        };
        const Drawn drawn(of(k * kMany, kMany, fifo), pixels);
        const std::int64_t set_ups =
            drawn.rasterizer.statistics().set_up_limits.count() / (k * kMany);
        RC_ASSERT(end(k * kMany + 1) - drawn.end() >= set_ups);
        RC_ASSERT(drawn.end() - end(k * kMany - 1) <= set_ups);
    }));
}

TEST(RasterizerPath, IsWhatTheRasterizerIsBusyWithAndCounts) {
    EXPECT_TRUE(rc::check([] {
        TileMachineSettings settings;
        settings.sorter.queues = random_queues();
        settings.rasterizer = of(*rc::gen::inRange(1, 40), *rc::gen::inRange(0, 3), any_fifo());
        const auto tiles =
            static_cast<TileIndex>(settings.sorter.queues.columns * settings.sorter.queues.rows);
        const TileMachine machine(settings, {random_frame(tiles), random_frame(tiles)});
        for (std::size_t i = 0; i < machine.rasterizers.size(); ++i) {
            std::array<Duration, 2> busy{};
            Time until;
            for (const StateInterval& interval : machine.states[i].all) {
                RC_ASSERT(interval.from >= until);
                until = interval.to;
                if (interval.state == NodeState::busy) {
                    busy.at(interval.activity) += interval.to - interval.from;
                }
            }
            Duration whole;
            for (const Rasterizer::BusyTime& time : machine.rasterizers[i]->busy_times()) {
                whole += time.drawn - time.began;
            }
            RC_ASSERT(busy[Rasterizer::kSetUp] + busy[Rasterizer::kPixels] == whole);
            RC_ASSERT(busy[Rasterizer::kSetUp] ==
                      machine.clock.edge(machine.rasterizers[i]->statistics().set_up_limits)
                          .since_start());
        }
    }));
}

}  // namespace
}  // namespace rasterloom
