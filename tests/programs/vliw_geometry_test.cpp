// SPDX-License-Identifier: MIT
// The geometry stage in VLIW assembly (programs/vliw/geometry.s) against double precision.
#include "programs/vliw_geometry_expected.hpp"
#include "programs/vliw_geometry_run.hpp"
#include "programs/vliw_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

struct Tally {
    int visible = 0;
    int hidden = 0;
    int doubtful = 0;
    Tally& operator+=(const Tally& other) {
        visible += other.visible;
        hidden += other.hidden;
        doubtful += other.doubtful;
        return *this;
    }
};

// Every descriptor of the run is that of a polygon of the lane, in order, and none is missing.
Tally check(const VliwGeometryRun& run, const VliwView& view, const VliwLights& lights,
            const std::vector<VliwDatabase>& lanes, bool textured = true) {
    Tally tally;
    EXPECT_TRUE(run.reached_communication());
    for (int lane = 0; const VliwDatabase& polygons : lanes) {
        EXPECT_EQ(run.error(lane), 0);
        EXPECT_TRUE(run.kept_its_place(lane));
        const auto descriptors = run.descriptors(lane);
        auto next = descriptors.begin();
        for (std::size_t i = 0; i < polygons.size(); ++i) {
            const ExpectedPolygon expected(view, lights, polygons[i]);
            const Fate fate = expected.fate();
            std::string complaint = "it is hidden";
            if (fate != Fate::hidden && next != descriptors.end()) {
                complaint = expected.complaint(*next, textured);
            }
            if (complaint.empty()) {
                ++next;
            } else if (fate == Fate::visible) {
                ADD_FAILURE() << "lane " << lane << ", polygon " << i << ": " << complaint;
                return tally;
            }
            ++(fate == Fate::visible  ? tally.visible
               : fate == Fate::hidden ? tally.hidden
                                      : tally.doubtful);
        }
        EXPECT_EQ(next, descriptors.end()) << "lane " << lane;
        ++lane;
    }
    return tally;
}

VliwVertex vertex(int x, int y, int z) {
    VliwVertex result;
    result.place = {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y),
                    static_cast<std::int16_t>(z)};
    result.normal = {0, 0, -16384};
    return result;
}

// Facing the viewer without a turn, in the middle of the screen.
VliwPolygon front(int z = 10000, int size = 1000) {
    VliwPolygon result;
    result.vertices = {vertex(-size, -size, z), vertex(size, -size, z), vertex(0, size, z)};
    result.colour = {0x1234, 0x5678, 0x9abc};
    return result;
}

VliwPolygon back() {
    VliwPolygon result = front();
    std::swap(result.vertices[0], result.vertices[1]);
    return result;
}

TEST(VliwGeometry, DescribesTheVisiblePolygonsOfAnObject) {
    Tally sum;
    for (unsigned seed = 0; seed < 24; ++seed) {
        VliwScenes scenes(seed);
        const auto view = scenes.view(scenes.whole(9000, 27000));
        const auto lights = scenes.lights();
        const auto lanes = scenes.databases(3000, 1 << scenes.whole(7, 11));
        sum += check(VliwGeometryRun(view, lights, lanes), view, lights, lanes);
        ASSERT_FALSE(HasFailure()) << "seed " << seed;
    }
    EXPECT_GT(sum.visible, 1000);
    EXPECT_GT(sum.hidden, 1000);
    EXPECT_LT(sum.doubtful, sum.visible / 10);
}

TEST(VliwGeometry, DescribesPolygonsNextToTheViewerOrPartlyOffTheScreen) {
    Tally sum;
    for (unsigned seed = 100; seed < 116; ++seed) {
        VliwScenes scenes(seed);
        const auto view = scenes.view(scenes.whole(4000, 9000));
        const auto lights = scenes.lights();
        const auto lanes = scenes.databases(6000, 3000);
        sum += check(VliwGeometryRun(view, lights, lanes), view, lights, lanes);
        ASSERT_FALSE(HasFailure()) << "seed " << seed;
    }
    EXPECT_GT(sum.visible, 20);
    EXPECT_GT(sum.hidden, 1000);
}

// Of such polygons two vertices almost coincide, or all three lie almost on a line.
TEST(VliwGeometry, DescribesSlivers) {
    Tally sum;
    for (unsigned seed = 200; seed < 216; ++seed) {
        VliwScenes scenes(seed);
        const auto view = scenes.view(16000);
        const auto lights = scenes.lights();
        auto lanes = scenes.databases(3000, 2000);
        for (VliwDatabase& lane : lanes) {
            for (VliwPolygon& polygon : lane) {
                auto& [a, b, c] = polygon.vertices;
                const int share = scenes.whole(0, 2);  // from a to b
                for (std::size_t k = 0; k < 3; ++k) {
                    c.place[k] = static_cast<std::int16_t>(
                        a.place[k] + (b.place[k] - a.place[k]) * share / 2 + scenes.whole(-9, 9));
                }
            }
        }
        sum += check(VliwGeometryRun(view, lights, lanes), view, lights, lanes);
        ASSERT_FALSE(HasFailure()) << "seed " << seed;
    }
    EXPECT_GT(sum.visible + sum.doubtful, 500);
}

TEST(VliwGeometry, KeepsItsPlaceWhateverTheDatabaseHolds) {
    for (unsigned seed = 300; seed < 310; ++seed) {
        VliwScenes scenes(seed);
        const auto view = scenes.view(scenes.whole(-32768, 32767));
        auto lights = scenes.lights();
        lights.lamp = {scenes.word(-32768, 32767), scenes.word(-32768, 32767),
                       scenes.word(-32768, 32767)};
        auto lanes = scenes.databases(0, 0);
        for (VliwDatabase& lane : lanes) {
            std::ranges::generate(lane, [&] { return scenes.garbage(); });
        }
        const VliwGeometryRun run(view, lights, lanes);
        EXPECT_TRUE(run.reached_communication());
        for (int lane = 0; lane < 5; ++lane) {
            EXPECT_TRUE(run.kept_its_place(lane)) << "seed " << seed;
        }
    }
}

TEST(VliwGeometry, HidesWhatIsBehindTheViewerOffTheScreenOrHasNoArea) {
    VliwPolygon point = front();
    point.vertices[1] = point.vertices[0];
    VliwPolygon line = front();
    line.vertices[2] = vertex(0, -1000, 10000);
    VliwPolygon beside = front();
    VliwPolygon too_far = front();
    for (std::size_t i = 0; i < 3; ++i) {
        beside.vertices[i].place[0] = static_cast<std::int16_t>(beside.vertices[i].place[0] + 8200);
        too_far.vertices[i].place[2] = 30000;
    }
    VliwView view;
    view.matrix[11] = 3000;
    const std::vector<VliwDatabase> lanes{{point, line, back(), beside, too_far, front(-10000),
                                           front(1000), front(5000, 8001), front(8000)}};
    const VliwGeometryRun run(view, {}, lanes);
    const Tally tally = check(run, view, {}, lanes);
    EXPECT_EQ(tally.visible, 1);
    EXPECT_EQ(run.descriptors(0).size(), 1U);
}

// 45 degrees about x: z' is 72 254 or so, 6718 if it wrapped.
TEST(VliwGeometry, HidesWhatIsFartherThanAWordHolds) {
    VliwView view;
    view.matrix = {1 << 14, 0, 0, 0, 11585, -11585, 0, 11585, 11585, 0, 0, 27000};
    VliwPolygon far = front();
    for (VliwVertex& corner : far.vertices) {
        const int up = corner.place[1];
        corner = vertex(corner.place[0], 31000 + up, 31000 - up);
    }
    EXPECT_TRUE(VliwGeometryRun(view, {}, {{far}}).descriptors(0).empty());
    view.matrix[11] = -30000;
    EXPECT_EQ(VliwGeometryRun(view, {}, {{far}}).descriptors(0).size(), 1U);
}

// Between whole rows there is nothing to draw.
TEST(VliwGeometry, HidesWhatContainsNoSample) {
    VliwPolygon flat = front();
    flat.vertices = {vertex(-1000, 2, 11200), vertex(1000, 2, 11200), vertex(1000, 9, 11200)};
    VliwPolygon reaching = flat;
    reaching.vertices[0].place[1] = -4;
    const std::vector<VliwDatabase> lanes{{flat}, {reaching}};
    const VliwGeometryRun run({}, {}, lanes);
    EXPECT_EQ(run.descriptors(0).size(), 0U);
    ASSERT_EQ(run.descriptors(1).size(), 1U);
    EXPECT_EQ(run.descriptors(1)[0][2], 256);
    EXPECT_EQ(run.descriptors(1)[0][3], 256);
}

TEST(VliwGeometry, EndsLightAt255) {
    const VliwLights lights{.ambient = 200,
                            .sun = {0, 0, -16384},
                            .sun_diffuse = 255,
                            .sun_specular = 255,
                            .lamp = {0, 0, 0},
                            .lamp_diffuse = 255,
                            .lamp_specular = 255};
    const VliwGeometryRun run({}, lights, {{front()}});
    const VliwDescriptor descriptor = run.descriptors(0).at(0);
    EXPECT_EQ(descriptor[26], 0);
    EXPECT_EQ(descriptor[27], 0);
    EXPECT_EQ(descriptor[28], 0x8000);
    EXPECT_EQ(descriptor[29], 255);
}

// By normals and a sun for which words are enough, intensities are exact: k / 16.
TEST(VliwGeometry, RoundsTheSlopesOfIntensity) {
    VliwScenes scenes(600);
    for (int i = 0; i < 50; ++i) {
        VliwPolygon polygon = front(16000, scenes.whole(300, 4000));
        std::array<double, 3> intensity{};
        for (std::size_t k = 0; k < 3; ++k) {
            const int sixteenths = scenes.whole(0, 2000);
            intensity[k] = sixteenths / 16.0;
            polygon.vertices[k].normal = {0, 0, static_cast<std::int16_t>(-8 * sixteenths)};
        }
        const VliwGeometryRun run({}, {.sun = {0, 0, -16384}, .sun_diffuse = 128}, {{polygon}});
        const VliwDescriptor descriptor = run.descriptors(0).at(0);
        const auto number = [&](std::size_t at) {
            return static_cast<double>(static_cast<std::int16_t>(descriptor[at]));
        };
        const double area = number(8) * number(17) - number(9) * number(16);
        for (const std::size_t axis : {0U, 1U}) {
            const double sum = intensity[0] * number(12 + axis) + intensity[1] * number(16 + axis) +
                               intensity[2] * number(8 + axis);
            const double slope = 256 * 16 * sum / area;
            EXPECT_NEAR(number(26 + axis), slope, 0.5 + std::abs(slope) / 16384 + 1e-3);
        }
    }
}

// 1/8 pixel across at its foot, from u = 0 to 255 and from dark to light; the sample (384, 256) is
// half way up.
VliwPolygon sliver() {
    VliwPolygon result;
    result.vertices = {vertex(-2, -450, 16000), vertex(2, -450, 16000), vertex(0, 450, 16000)};
    result.vertices[0].u = 0;
    result.vertices[1].u = 255;
    result.vertices[2].u = 100;
    result.vertices[0].normal = {0, 0, 0};
    result.vertices[1].normal = {0, 0, -16384};
    result.vertices[2].normal = {0, 0, -8192};
    return result;
}

TEST(VliwGeometry, KeepsSlopesThatAreSteeperThanTheirWords) {
    const VliwGeometryRun run({}, {}, {{sliver()}});
    const VliwDescriptor words = run.descriptors(0).at(0);
    const auto number = [&](std::size_t at) {
        return words[at] | std::uint32_t{words[at + 1]} << 16;
    };
    constexpr double kDepth = 268435456.0 / 16000;
    const double slope = 8 * 255 * kDepth / 256;
    EXPECT_GT(slope, 32768);
    EXPECT_NEAR(number(30) / 65536.0, std::fmod(slope, 65536), slope / 16384);
    EXPECT_NEAR((number(34) + number(30) * 384 + number(32) * 256) / 65536.0,
                (255 / 2.0 + 100) / 2 * kDepth / 256, 1);
}

TEST(VliwGeometry, TakesTheMeanIntensityWhereItIsSteeperThanItsWords) {
    const VliwGeometryRun run({}, {.sun = {0, 0, -16384}, .sun_diffuse = 120}, {{sliver()}});
    const VliwDescriptor words = run.descriptors(0).at(0);
    EXPECT_EQ(words[26], 0);
    EXPECT_EQ(words[27], 0);
    EXPECT_NEAR((words[28] | words[29] << 16) / 65536.0, (0 + 120 + 60) / 3 + 0.5, 0.02);
}

TEST(VliwGeometry, GoesByTheMatrixThatItBeganWith) {
    VliwScenes scenes(700);
    const auto view = scenes.view(16000);
    const auto lights = scenes.lights();
    const auto lanes = scenes.databases(3000, 1000);
    const auto next = scenes.view(10000);
    const VliwGeometryRun undisturbed(view, lights, lanes);
    const VliwGeometryRun disturbed(view, lights, lanes, {.next_view = next});
    for (int lane = 0; lane < 5; ++lane) {
        EXPECT_EQ(undisturbed.descriptors(lane), disturbed.descriptors(lane));
    }
}

TEST(VliwGeometry, LightsNothingFromBehindOrWithoutANormal) {
    VliwLights lights{.ambient = 10,
                      .sun = {0, 0, 16384},
                      .sun_diffuse = 255,
                      .sun_specular = 255,
                      .lamp = {0, 0, 20000},
                      .lamp_diffuse = 255,
                      .lamp_specular = 255};
    EXPECT_EQ(VliwGeometryRun({}, lights, {{front()}}).descriptors(0).at(0)[29], 10);
    VliwPolygon dull = front();
    for (VliwVertex& corner : dull.vertices) {
        corner.normal = {0, 0, 0};
    }
    EXPECT_EQ(VliwGeometryRun({}, lights, {{dull}}).descriptors(0).at(0)[29], 10);
    lights.sun[2] = -16384;
    lights.lamp[2] = 0;
    EXPECT_EQ(VliwGeometryRun({}, lights, {{dull}}).descriptors(0).at(0)[29], 10);
}

TEST(VliwGeometry, HasNothingToSendWithoutPolygons) {
    const VliwGeometryRun run({}, {}, {{}, {}});
    EXPECT_TRUE(run.reached_communication());
    EXPECT_TRUE(run.descriptors(0).empty());
    EXPECT_TRUE(run.descriptors(1).empty());
}

TEST(VliwGeometry, FillsItsArrayToTheLastPlace) {
    const std::vector<VliwDatabase> lanes{{front(), front(), back()}, {back(), front(), front()}};
    const VliwGeometryRun run({}, {}, lanes, {.room = 2});
    check(run, {}, {}, lanes);
}

TEST(VliwGeometry, HaltsWithAnErrorWhereTheArrayIsFull) {
    const std::vector<VliwDatabase> lanes{{front(), back()}, {front(), front(), front()}, {}};
    for (const int room : {0, 1, 2}) {
        const VliwGeometryRun run({}, {}, lanes, {.room = room});
        EXPECT_FALSE(run.reached_communication());
        EXPECT_EQ(run.error(0), room == 0 ? 1 : 0);
        EXPECT_EQ(run.error(1), 1);
        EXPECT_EQ(run.error(2), 0);
        for (int lane = 0; lane < 3; ++lane) {
            EXPECT_TRUE(run.kept_its_place(lane));
        }
    }
}

TEST(VliwGeometry, ComputesTheSamePackedAndUnpacked) {
    for (unsigned seed = 400; seed < 404; ++seed) {
        VliwScenes scenes(seed);
        const auto view = scenes.view(scenes.whole(6000, 20000));
        const auto lights = scenes.lights();
        const auto lanes = scenes.databases(3000, 1000);
        const VliwGeometryRun packed(view, lights, lanes);
        const VliwGeometryRun unpacked(view, lights, lanes, {.packed = false});
        for (int lane = 0; lane < 5; ++lane) {
            EXPECT_EQ(packed.descriptors(lane), unpacked.descriptors(lane)) << "seed " << seed;
        }
    }
}

TEST(VliwGeometry, LeavesTextureCoordinatesOutWhereNobodyWantsThem) {
    VliwScenes scenes(500);
    const auto view = scenes.view(16000);
    const auto lights = scenes.lights();
    const auto lanes = scenes.databases(3000, 1000);
    const VliwGeometryRun textured(view, lights, lanes);
    const VliwGeometryRun shaded(view, lights, lanes, {.textured = false});
    check(shaded, view, lights, lanes, false);
    for (int lane = 0; lane < 5; ++lane) {
        auto with = textured.descriptors(lane);
        auto without = shaded.descriptors(lane);
        for (auto* descriptors : {&with, &without}) {
            for (VliwDescriptor& descriptor : *descriptors) {
                descriptor.resize(30);
            }
        }
        EXPECT_EQ(with, without);
    }
}

}  // namespace
}  // namespace rasterloom::test
