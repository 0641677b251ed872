// SPDX-License-Identifier: MIT
#include "machine/host/polygon_setup.hpp"

#include "machine/host/polygon_renderer.hpp"
#include "machine/host/polygon_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom::host {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// Looks along +x from the origin: at distance 1 the picture is 2 wide.
const Camera kStraight{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 90, 0.01};

// (left, up) at a distance from the eye, so that it is seen at those coordinates of a picture from
// -1 to 1.
glm::dvec3 seen_at(double right, double up, double distance) {
    return {distance, -right * distance, up * distance};
}

StagePolygon stage_polygon(std::vector<glm::dvec3> places, double grey = 100) {
    StagePolygon polygon;
    for (const auto& place : places)
        polygon.corners.push_back({place, grey});
    return polygon;
}

StagePolygon square(double half, double distance, double grey = 100) {
    return stage_polygon({seen_at(-half, -half, distance), seen_at(half, -half, distance),
                          seen_at(half, half, distance), seen_at(-half, half, distance)},
                         grey);
}

StagePolygon reversed(StagePolygon polygon) {
    std::reverse(polygon.corners.begin(), polygon.corners.end());
    return polygon;
}

std::vector<Polygon> setup(const std::vector<StagePolygon>& stage,
                           PolygonSetupStatistics* statistics = nullptr,
                           const Camera& camera = kStraight) {
    auto polygons = screen_polygons(stage, camera, 512, 512, statistics);
    check_polygons(polygons, 512, 512);
    return polygons;
}

TEST(PolygonSetup, FillsThePictureWithWhatFillsTheFieldOfView) {
    PolygonSetupStatistics statistics;
    const auto polygons = setup({square(1, 5)}, &statistics);
    ASSERT_EQ(polygons.size(), 1U);
    const std::int16_t shade = 100 * kShadeUnit + kShadeUnit / 2;
    EXPECT_EQ(polygons[0].vertices,
              (std::vector<PolygonVertex>{
                  {0, 0, 0, shade}, {511, 0, 0, shade}, {511, 511, 0, shade}, {0, 511, 0, shade}}));
    EXPECT_EQ(statistics.clipped, 0U);
}

TEST(PolygonSetup, PutsUpAndRightWhereTheyBelong) {
    // World +y is at the left of who looks along +x with +z up.
    const auto polygons = setup({stage_polygon({{4, -1, 1}, {4, -1, 2}, {4, -2, 2}})});
    EXPECT_TRUE(polygons.empty());  // clockwise from here
    const auto front = setup({stage_polygon({{4, -1, 1}, {4, -2, 2}, {4, -1, 2}})});
    ASSERT_EQ(front.size(), 1U);
    for (const auto& v : front[0].vertices) {
        EXPECT_GE(v.x, 256 + 63);
        EXPECT_GE(v.y, 256 + 63);
    }
}

TEST(PolygonSetup, DropsBacksAndEdges) {
    PolygonSetupStatistics statistics;
    const auto edge_on = stage_polygon({{2, 0, 0}, {3, 0, 0}, {3, 0, 0.5}});
    EXPECT_TRUE(setup({reversed(square(0.5, 2)), edge_on, reversed(edge_on)}, &statistics).empty());
    EXPECT_EQ(statistics.back_faces, 3U);
}

TEST(PolygonSetup, UsesAllDepthsAndKeepsPlanesPlane) {
    // A floor: 1/distance is linear in y, and so is the depth.
    const auto polygons =
        setup({stage_polygon({{1, 0.5, -1}, {1, -0.5, -1}, {9, -0.5, -1}, {9, 0.5, -1}})});
    ASSERT_EQ(polygons.size(), 1U);
    int least = kFarthest, greatest = 0;
    for (const auto& v : polygons[0].vertices) {
        least = std::min<int>(least, v.z);
        greatest = std::max<int>(greatest, v.z);
        const double distance = 1 / ((255.5 - v.y) / 256);
        EXPECT_NEAR(v.z, kFarthest * (1 - 1 / distance) / (1 - 1.0 / 9), 32766.0 / 256);
    }
    EXPECT_EQ(least, 0);
    EXPECT_EQ(greatest, kFarthest);
}

TEST(PolygonSetup, AddsThePolygonsOwnDepthOffsetWithinTheRange) {
    auto painted = square(0.25, 2);
    painted.depth_offset = -8;
    auto far = square(0.25, 4);
    far.depth_offset = 100;
    auto middle = square(0.25, 3);
    middle.depth_offset = -8;
    const auto polygons = setup({square(0.5, 2), painted, far, middle, square(0.5, 3)});
    EXPECT_EQ(polygons[1].vertices[0].z, 0);
    EXPECT_EQ(polygons[2].vertices[0].z, kFarthest);
    EXPECT_EQ(polygons[3].vertices[0].z, polygons[4].vertices[0].z - 8);
}

TEST(PolygonSetup, ClipsAtAllSidesAndAtTheNearPlane) {
    PolygonSetupStatistics statistics;
    // A diamond around the picture leaves an octagon.
    const auto diamond = stage_polygon(
        {seen_at(0, -1.5, 3), seen_at(1.5, 0, 3), seen_at(0, 1.5, 3), seen_at(-1.5, 0, 3)});
    const auto octagon = setup({diamond}, &statistics);
    ASSERT_EQ(octagon.size(), 1U);
    EXPECT_EQ(octagon[0].vertices.size(), 8U);
    EXPECT_EQ(statistics.clipped, 1U);
    // A floor that runs on behind the viewer fills the lower half.
    const auto floor = setup(
        {stage_polygon({{-100, 100, -1}, {-100, -100, -1}, {1e6, -1e6, -1}, {1e6, 1e6, -1}})});
    ASSERT_EQ(floor.size(), 1U);
    const auto drawn = render_polygons(floor, {});
    EXPECT_EQ(std::accumulate(drawn.drawn.begin(), drawn.drawn.end(), 0U), 512U * 256U);
}

TEST(PolygonSetup, InterpolatesGreyLevelsWhereItClips) {
    StagePolygon ramp = square(2, 4);
    ramp.corners[0].grey = ramp.corners[3].grey = 0;
    ramp.corners[1].grey = ramp.corners[2].grey = 200;
    const auto polygons = setup({ramp});
    ASSERT_EQ(polygons.size(), 1U);
    for (const auto& v : polygons[0].vertices)
        EXPECT_EQ(v.shade, (v.x == 0 ? 50 : 150) * kShadeUnit + kShadeUnit / 2);
}

TEST(PolygonSetup, DropsWhatIsBesideOrBehind) {
    PolygonSetupStatistics statistics;
    const auto beside =
        stage_polygon({seen_at(1.01, -0.5, 2), seen_at(3, -0.5, 2), seen_at(1.01, 0.5, 2)});
    const auto behind = stage_polygon({{-3, -1, -1}, {-3, 1, -1}, {-3, 0, 1}});
    EXPECT_TRUE(setup({beside, behind, reversed(behind)}, &statistics).empty());
    EXPECT_EQ(statistics.outside + statistics.back_faces, 3U);
    EXPECT_EQ(statistics.outside, 2U);
}

TEST(PolygonSetup, KeepsTheSmallestAsPointsAndLines) {
    PolygonSetupStatistics statistics;
    const auto dust =
        setup({square(1e-4, 2),
               stage_polygon({seen_at(0, 0, 2), seen_at(0.1, 0, 2), seen_at(0.1, 1e-5, 2)})},
              &statistics);
    ASSERT_EQ(dust.size(), 2U);
    EXPECT_LE(dust[0].vertices.size(), 4U);
    EXPECT_EQ(statistics.sent, 2U);
    const auto point = setup({stage_polygon({seen_at(0.001, 0.001, 2), seen_at(0.0011, 0.001, 2),
                                             seen_at(0.001, 0.0011, 2)})},
                             &statistics);
    ASSERT_EQ(point.size(), 1U);
    EXPECT_EQ(point[0].vertices.size(), 1U);
    EXPECT_EQ(statistics.points, 1U);
}

TEST(PolygonSetup, DividesPolygonsWithTooManyVerticesWithoutLosingAPixel) {
    StagePolygon disc;
    for (int k = 0; k < 40; ++k) {
        const double t = -1 + k / 10.0;  // rational points of the circle, twice half of it
        const double u = k < 20 ? t : t - 2;
        const double c = (1 - u * u) / (1 + u * u), s = 2 * u / (1 + u * u);
        disc.corners.push_back({seen_at(0.8 * (k < 20 ? c : -c), 0.8 * (k < 20 ? s : -s), 3), 120});
    }
    PolygonSetupStatistics statistics;
    const auto pieces = setup({disc}, &statistics);
    EXPECT_EQ(pieces.size(), 5U);  // 40 corners, and each piece but the first shares two
    EXPECT_EQ(statistics.additional, 4U);
    const auto drawn = render_polygons(pieces, {});
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x) {
            const double radius = glm::length(glm::dvec2{x - 255.5, y - 255.5});
            const auto count =
                drawn.drawn[static_cast<std::size_t>(511 - y) * 512U + static_cast<std::size_t>(x)];
            if (radius < 0.79 * 256) {
                EXPECT_GE(count, 1U) << x << " " << y;
            }
            if (radius > 0.8 * 256 + 1.5) {
                EXPECT_EQ(count, 0U) << x << " " << y;
            }
        }
}

TEST(PolygonSetup, DividesWhatIsNotConvex) {
    // An arrow head, an L and a comb.
    const auto flat = [](std::vector<std::pair<double, double>> places) {
        StagePolygon polygon;
        for (const auto& [x, y] : places)
            polygon.corners.push_back({seen_at(x, y, 2), 100});
        return polygon;
    };
    const auto arrow = flat({{-0.5, -0.5}, {0, -0.2}, {0.5, -0.5}, {0, 0.5}});
    const auto comb = flat({{-0.6, -0.5},
                            {0.6, -0.5},
                            {0.6, 0.5},
                            {0.4, 0.5},
                            {0.4, -0.3},
                            {0.1, -0.3},
                            {0.1, 0.5},
                            {-0.1, 0.5},
                            {-0.1, -0.3},
                            {-0.4, -0.3},
                            {-0.4, 0.5},
                            {-0.6, 0.5}});
    PolygonSetupStatistics statistics;
    EXPECT_EQ(setup({arrow}).size(), 2U);
    const auto teeth = setup({comb}, &statistics);
    EXPECT_EQ(teeth.size(), 10U);
    EXPECT_EQ(statistics.additional, 9U);
    const auto drawn = render_polygons(teeth, {});
    const auto count_at = [&](double right, double up) {
        const auto x = static_cast<std::size_t>(256 + 256 * right);
        const auto y = static_cast<std::size_t>(256 - 256 * up);
        return drawn.drawn[y * 512 + x];
    };
    EXPECT_EQ(count_at(0.25, 0.2), 0U);
    EXPECT_EQ(count_at(-0.25, 0.2), 0U);
    for (const double tooth : {-0.5, 0.0, 0.5})
        EXPECT_GE(count_at(tooth, 0.2), 1U);
    EXPECT_GE(count_at(0.25, -0.4), 1U);
}

TEST(PolygonSetup, SendsNothingOfAnEmptyStage) {
    EXPECT_TRUE(setup({}).empty());
}

// ---- bad input

void expect_refusal(const StagePolygon& polygon, const char* what) {
    EXPECT_THAT(
        [&] {
            setup({square(0.5, 2), polygon});
        },
        ThrowsMessage<std::invalid_argument>(
            testing::AllOf(HasSubstr("stage polygon 1"), HasSubstr(what))));
}

TEST(PolygonSetup, RefusesWhatIsNotANumber) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), -1e61}) {
        auto polygon = square(0.5, 2);
        polygon.corners[2].position.y = bad;
        expect_refusal(polygon, "corner 2");
        polygon = square(0.5, 2);
        polygon.corners[1].grey = bad;
        expect_refusal(polygon, "corner 1");
    }
    expect_refusal(square(0.5, 2, 255.5), "expected 0 to 255");
}

TEST(PolygonSetup, RefusesPolygonsWithoutAnAreaAndForgivesRepeatedCorners) {
    expect_refusal({}, "0 different corners");
    expect_refusal(stage_polygon({{2, 0, 0}, {2, 1, 0}}), "2 different corners");
    expect_refusal(stage_polygon({{2, 0, 0}, {2, 1, 0}, {2, 1, 0}, {2, 0, 0}}), "2 different");
    expect_refusal(stage_polygon({{2, 0, 0}, {2, 1, 0}, {2, 2, 0}}), "no area");
    auto repeated = square(0.5, 2);
    repeated.corners.insert(repeated.corners.begin(), repeated.corners.front());
    repeated.corners.push_back(repeated.corners.front());
    EXPECT_EQ(setup({repeated}), setup({square(0.5, 2)}));
}

TEST(PolygonSetup, RefusesACameraThatMakesNoSense) {
    const auto refusal = [](Camera camera, const char* what) {
        EXPECT_THAT([&] { screen_polygons({}, camera, 512, 512); },
                    ThrowsMessage<std::invalid_argument>(HasSubstr(what)));
    };
    refusal({{1, 2, 3}, {1, 2, 3}}, "target");
    refusal({{0, 0, 0}, {0, 0, 5}}, "up lies along");
    refusal({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, "up lies along");
    refusal({{0, 0, std::nan("")}, {1, 0, 0}}, "finite");
    for (const double angle : {0.0, 180.0, -5.0, std::nan("")})
        refusal({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, angle}, "field of view");
    for (const double near : {0.0, -1.0, std::numeric_limits<double>::infinity()})
        refusal({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 60, near}, "near");
    EXPECT_THROW(screen_polygons({}, kStraight, 0, 512), std::invalid_argument);
    EXPECT_THROW(screen_polygons({}, kStraight, 512, 5000), std::invalid_argument);
}

// ---- properties

double random_unit() {
    return *rc::gen::inRange(-1000, 1001) / 1000.0;
}

// Corners about a circle in a random plane somewhere around the viewer.
StagePolygon random_polygon() {
    const glm::dvec3 middle{6 * random_unit(), 6 * random_unit(), 6 * random_unit()};
    const glm::dvec3 u{random_unit(), random_unit(), random_unit()};
    const glm::dvec3 v{random_unit(), random_unit(), random_unit()};
    StagePolygon polygon;
    const int count = *rc::gen::inRange(3, 16);
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * 3.14159265358979 * k / count;
        polygon.corners.push_back(
            {middle + std::cos(angle) * u + std::sin(angle) * v, 100 + 100 * random_unit()});
    }
    return polygon;
}

bool has_area(const StagePolygon& polygon) {
    const auto& c = polygon.corners;
    const auto area = glm::cross(c[1].position - c[0].position, c[2].position - c[0].position);
    return glm::dot(area, area) > 1e-6;
}

TEST(PolygonSetup, SendsOnlyValidPolygonsAndLosesNone) {
    EXPECT_TRUE(rc::check([] {
        std::vector<StagePolygon> stage;
        for (int k = *rc::gen::inRange(1, 20); k > 0; --k)
            if (auto polygon = random_polygon(); has_area(polygon))
                stage.push_back(polygon);
        PolygonSetupStatistics s;
        const auto polygons = screen_polygons(stage, kStraight, 320, 200, &s);
        check_polygons(polygons, 320, 200);
        RC_ASSERT(s.given == stage.size());
        RC_ASSERT(s.sent == polygons.size());
        RC_ASSERT(s.given + s.additional == s.back_faces + s.outside + s.sent);
        RC_ASSERT(polygons == screen_polygons(stage, kStraight, 320, 200));
    }));
}

// The ray through a pixel's centre meets the polygon well inside: then the pixel is drawn.
bool is_hit_well_inside(const StagePolygon& polygon, const glm::dvec3& ray, double pixel) {
    const auto& c = polygon.corners;
    const auto normal = glm::cross(c[1].position - c[0].position, c[2].position - c[0].position);
    const double towards = glm::dot(normal, ray);
    if (!(towards < 0))
        return false;
    const double t = glm::dot(normal, c[0].position) / towards;
    if (!(t > 0.02))
        return false;
    // Inside all planes through the eye and an edge, by more than the rounding of its ends.
    for (std::size_t k = 0; k < c.size(); ++k) {
        const auto side = glm::cross(c[k].position, c[(k + 1) % c.size()].position);
        const double length = glm::length(side);
        if (!(glm::dot(side, ray) > 2 * pixel * length))
            return false;
    }
    return true;
}

TEST(PolygonSetup, DrawsThePixelsWhoseRaysMeetThePolygon) {
    EXPECT_TRUE(rc::check([] {
        const auto polygon = random_polygon();
        RC_PRE(has_area(polygon));
        constexpr int kSize = 64;
        const std::vector<StagePolygon> stage{polygon};
        const auto drawn =
            render_polygons(screen_polygons(stage, kStraight, kSize, kSize), {kSize, kSize});
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x) {
                const glm::dvec3 ray{1, -(x - 31.5) / 32, (y - 31.5) / 32};
                const auto count =
                    drawn.drawn[static_cast<std::size_t>((kSize - 1 - y) * kSize + x)];
                RC_ASSERT(count >= 1U || !is_hit_well_inside(polygon, ray, 1.0 / 32));
            }
    }));
}

}  // namespace
}  // namespace rasterloom::host
