// SPDX-License-Identifier: MIT
// sort_first.s from the database to the picture, over several frames: held against sort_middle.s;
// Eldridge's three checks (A.3) for the copies, and as many homes as polygons.
#include "isa/vliw/vliw.hpp"
#include "programs/vliw_chain.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>

namespace rasterloom::test {
namespace {

constexpr int kFrames = 6;
constexpr double kDegrees = 1.5;  // a frame: up to a third of the screen
constexpr std::uint32_t kDatabaseAt = 0x4000;

using Scene = std::vector<ScenePolygon>;

struct Case {
    int lanes = 48;
    Defines options;
    Form form = Form::packed;
    int room = 0;  // homes of a lane; 0: as many as there is room for
};

void PrintTo(const Case& test, std::ostream* stream) {
    *stream << name_of(test.lanes, test.options);
    if (test.form == Form::as_written) {
        *stream << ", as written";
    }
    if (test.room != 0) {
        *stream << ", " << test.room << " homes";
    }
}

VliwRenderer sort_first(const Scene& scene, const Case& test) {
    VliwRenderer renderer = chain_of("sort_first.s", scene, test.options, test.lanes, test.form);
    if (test.room != 0) {
        for (int lane = 0; lane < test.lanes; ++lane) {
            renderer.write(
                lane, "homes_end",
                static_cast<int>(kDatabaseAt) + renderer.symbol("kHome") * (test.room + 1));
        }
    }
    return renderer;
}

// A polygon somewhere on the ring, and the columns that it covers by the lane's own account.
struct Placed {
    ScenePolygon words{};
    int lane = 0;
    int left = 0;
    int right = 0;
    auto operator<=>(const Placed&) const = default;
    bool visible() const { return left <= right; }
};

// What a list of slow bank 0 names.
std::vector<Placed> listed(const VliwRenderer& renderer, int lane, std::string_view begin,
                           std::string_view end) {
    std::vector<Placed> all;
    for (std::uint32_t at = renderer.symbol(begin); at != renderer.read(lane, end); ++at) {
        const std::uint32_t home = renderer.read(lane, isa::vliw::slow_address(0, 0) + at);
        Placed& placed = all.emplace_back();
        for (std::uint32_t i = 0; i < placed.words.size(); ++i) {
            placed.words.at(i) = renderer.read(lane, home + i);
        }
        placed.lane = lane;
        placed.left =
            static_cast<std::int16_t>(renderer.read(lane, home + renderer.symbol("h_left")));
        placed.right =
            static_cast<std::int16_t>(renderer.read(lane, home + renderer.symbol("h_right")));
    }
    return all;
}

// Of all lanes, sorted.
std::vector<Placed> listed(const VliwRenderer& renderer, std::string_view begin,
                           std::string_view end) {
    std::vector<Placed> all;
    for (int lane = 0; lane < renderer.lanes(); ++lane) {
        const std::vector<Placed> here = listed(renderer, lane, begin, end);
        all.insert(all.end(), here.begin(), here.end());
    }
    std::ranges::sort(all);
    return all;
}

std::vector<Placed> homes_of(const VliwRenderer& renderer) {
    return listed(renderer, "homes", "home_end");
}

// Every polygon on every lane that needs it, none on one that does not, none twice.
void expect_all_where_wanted(const VliwRenderer& renderer) {
    std::vector<Placed> wanted;
    for (Placed placed : homes_of(renderer)) {
        for (placed.lane = std::max(placed.left, 0); placed.lane <= placed.right; ++placed.lane) {
            wanted.push_back(placed);
        }
    }
    std::ranges::sort(wanted);
    EXPECT_EQ(listed(renderer, "wanted", "wanted_end"), wanted);
}

void expect_one_home_each(const VliwRenderer& renderer, Scene scene) {
    Scene found;
    for (const Placed& home : homes_of(renderer)) {
        found.push_back(home.words);
    }
    std::ranges::sort(scene);
    EXPECT_EQ(found, scene);
}

class VliwSortFirst : public ::testing::TestWithParam<Case> {};

TEST_P(VliwSortFirst, DrawsWhatSortMiddleDrawsFrameAfterFrame) {
    for (const int size : {12, 70}) {
        const Scene scene = random_scene(72, size, static_cast<std::uint32_t>(size));
        VliwRenderer renderer = sort_first(scene, GetParam());
        VliwRenderer middle =
            chain_of("sort_middle.s", scene, {{"textured", renderer.symbol("textured")}}, 48);
        for (int frame = 0; frame < kFrames; ++frame) {
            turn_scene(renderer, frame * kDegrees);
            turn_scene(middle, frame * kDegrees);
            ASSERT_FALSE(renderer.run()) << "error " << renderer.read(0, "error");
            ASSERT_FALSE(middle.run());
            EXPECT_EQ(differences(shown_picture(renderer), shown_picture(middle)), 0)
                << "frame " << frame;
            expect_all_where_wanted(renderer);
            expect_one_home_each(renderer, scene);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Cases, VliwSortFirst,
                         ::testing::Values(Case{}, Case{48, {{"migrate", 0}}}, Case{60, {}},
                                           Case{60, {{"migrate", 0}}},
                                           Case{48, {}, Form::as_written},
                                           Case{48, {{"textured", 1}}},
                                           Case{48, {{"migrate", 2}, {"line_locked", 1}}},
                                           Case{48, {{"line_locked", 1}}},
                                           Case{48, {{"line_locked", 1}, {"migrate", 0}}},
                                           Case{48, {{"line_locked", 1}, {"textured", 1}}}));

// 72 polygons on 48 lanes, or on 36: every place is taken.
INSTANTIATE_TEST_SUITE_P(FullHomes, VliwSortFirst,
                         ::testing::Values(Case{48, {}, Form::packed, 2},
                                           Case{48, {{"migrate", 2}}, Form::packed, 2},
                                           Case{48, {{"line_locked", 1}}, Form::packed, 2},
                                           Case{72, {}, Form::packed, 1},
                                           Case{48, {}, Form::packed, 5}));

TEST(VliwSortFirstHomes, MoveToTheLeftColumnIfTheyAreVisibleAndStayOtherwise) {
    VliwRenderer renderer = sort_first(random_scene(200, 12, 3), {});
    std::vector<Placed> before;
    for (int frame = 0; frame < kFrames; ++frame) {
        turn_scene(renderer, frame * kDegrees);
        ASSERT_FALSE(renderer.run());
        const std::vector<Placed> after = homes_of(renderer);
        int stayed = 0;
        for (std::size_t i = 0; i < after.size(); ++i) {
            if (after[i].visible()) {
                EXPECT_EQ(after[i].lane, after[i].left);
            } else if (frame != 0) {
                EXPECT_EQ(after[i].lane, before.at(i).lane);
                ++stayed;
            }
        }
        EXPECT_TRUE(frame == 0 || stayed > 0);
        before = after;
    }
}

TEST(VliwSortFirstHomes, MoveAllWithWhatTheyWouldCoverIfHiddenOnesAreToo) {
    VliwRenderer renderer = sort_first(random_scene(200, 12, 3), {48, {{"migrate", 2}}});
    for (int frame = 0; frame < kFrames; ++frame) {
        turn_scene(renderer, frame * kDegrees);
        ASSERT_FALSE(renderer.run());
        for (const Placed& home : homes_of(renderer)) {
            EXPECT_EQ(home.lane, std::min(home.left, 47));
        }
    }
}

TEST(VliwSortFirstHomes, AreCountedAndTheMostOfThemIsKept) {
    VliwRenderer renderer = sort_first(random_scene(200, 12, 4), {});
    std::vector<int> most(48);
    for (int frame = 0; frame < kFrames; ++frame) {
        turn_scene(renderer, frame * kDegrees);
        ASSERT_FALSE(renderer.run());
        for (int lane = 0; lane < 48; ++lane) {
            const auto held = static_cast<int>(listed(renderer, lane, "homes", "home_end").size());
            int& known = most.at(static_cast<std::size_t>(lane));
            known = std::max(known, held);
            EXPECT_EQ(renderer.read(lane, "polygons"), held);
        }
    }
    // At first every lane has 4 or 5, as they are dealt out.
    for (int lane = 0; lane < 48; ++lane) {
        EXPECT_EQ(
            renderer.read(lane, "most_homes"),
            std::max(most.at(static_cast<std::size_t>(lane)), 200 / 48 + (lane * 7 % 48 < 8)));
    }
}

TEST(VliwSortFirstPasses, AreTheWidthsOnlyWhereNothingMoves) {
    const Scene scene = random_scene(200, 12, 5);
    VliwRenderer renderer = sort_first(scene, {});
    VliwRenderer without = sort_first(scene, {48, {{"migrate", 0}}});
    renderer.run();
    without.run();
    EXPECT_GT(renderer.passes("migration_passes"), 0);
    const int first = without.passes("near_passes");
    renderer.run();
    without.run();
    EXPECT_EQ(renderer.passes("migration_passes"), 0);
    EXPECT_EQ(without.passes("near_passes"), first);
    EXPECT_LT(2 * renderer.passes("near_passes"), first);
}

TEST(VliwSortFirstPasses, AreNoneWhereNothingIsVisible) {
    VliwRenderer renderer = sort_first(random_scene(100, 30, 8), {});
    for (int lane = 0; lane < 48; ++lane) {
        renderer.write(lane, "near", 0x7fff);
    }
    ASSERT_FALSE(renderer.run());
    EXPECT_EQ(renderer.passes("near_passes"), 0);
    EXPECT_EQ(renderer.passes("migration_passes"), 0);
}

TEST(VliwSortFirstPasses, BringAHomeTheShorterWay) {
    VliwRenderer renderer = sort_first(random_scene(1, 12, 11), {});
    ASSERT_FALSE(renderer.run());
    const auto home = [&] { return homes_of(renderer).at(0); };
    for (const double degrees : {0.2, -0.2, 0.2}) {
        const int before = home().lane;
        turn_scene(renderer, degrees);
        ASSERT_FALSE(renderer.run());
        EXPECT_NE(home().lane, before);
        EXPECT_EQ(renderer.passes("migration_passes"), std::abs(home().lane - before));
        EXPECT_EQ(renderer.passes("near_passes"), home().right - home().left);
    }
}

TEST(VliwSortFirstPasses, AreTheSamePackedAndAsWritten) {
    const Scene scene = random_scene(100, 30, 6);
    VliwRenderer packed = sort_first(scene, {});
    VliwRenderer written = sort_first(scene, {48, {}, Form::as_written});
    for (int frame = 0; frame < 3; ++frame) {
        for (VliwRenderer* renderer : {&packed, &written}) {
            turn_scene(*renderer, frame * kDegrees);
            ASSERT_FALSE(renderer->run());
        }
        for (const std::string_view counter : {"near_passes", "migration_passes"}) {
            EXPECT_EQ(packed.passes(counter), written.passes(counter)) << counter;
        }
        EXPECT_EQ(homes_of(packed), homes_of(written));
        EXPECT_LT(packed.bundles(6), written.bundles(6));
    }
}

// Eldridge 1995, table 4.2: 3 x 24 + 30.
TEST(VliwSortFirstPasses, CostNoMoreThanEldridges) {
    const VliwRenderer renderer = sort_first({}, {});
    for (const std::string name : {"pass_copies", "move_right", "move_left"}) {
        EXPECT_LE(renderer.cost(name + "_loop", name + "_done").cycles, 102) << name;
    }
}

int error_of(VliwRenderer& renderer) {
    EXPECT_TRUE(renderer.run());
    int error = 0;
    for (int lane = 0; lane < renderer.lanes(); ++lane) {
        error = std::max(error, int{renderer.read(lane, "error")});
    }
    return error;
}

TEST(VliwSortFirstErrors, TellWhatIsFull) {
    const Scene scene = random_scene(96, 70, 7);
    const auto shortened = [&](std::string_view end, std::string_view begin, int words) {
        VliwRenderer renderer = sort_first(scene, {});
        renderer.write(20, end, renderer.read(20, begin) + words);
        return error_of(renderer);
    };
    EXPECT_EQ(shortened("source_end", "source_at", 3 * 42), 1);
    EXPECT_EQ(shortened("receive_end", "receive_at", 3 * 27), 2);
    EXPECT_EQ(shortened("homes_end", "polygons_at", 2 * 27), 5);
}

TEST(VliwSortFirstErrors, NameOptionsThatCannotBe) {
    const auto complaint = [](const Defines& options) -> std::string {
        try {
            sort_first({}, {1, options});
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "";
    };
    const std::string knows = "sort-first knows neither duplication nor strides";
    EXPECT_THAT(complaint({{"duplication", 2}}), ::testing::HasSubstr(knows));
    EXPECT_THAT(complaint({{"stride", 8}}), ::testing::HasSubstr(knows));
    EXPECT_THAT(complaint({{"migrate", 3}}), ::testing::HasSubstr("migrate must be 0, 1 or 2"));
}

TEST(VliwSortFirstErrors, LeaveAnEmptyRingAlone) {
    VliwRenderer renderer = sort_first({}, {});
    EXPECT_FALSE(renderer.run());
    EXPECT_EQ(renderer.passes("near_passes"), 0);
    EXPECT_EQ(shown_picture(renderer), ScreenPicture(48 * 64));
}

}  // namespace
}  // namespace rasterloom::test
