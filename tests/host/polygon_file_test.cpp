// SPDX-License-Identifier: MIT
#include "machine/host/polygon_file.hpp"

#include "machine/host/polygon_renderer.hpp"
#include "machine/host/polygon_shape.hpp"
#include "tests/host/polygon_generators.hpp"

#include <filesystem>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom::host {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

std::vector<Polygon> read(const std::string& text) {
    std::istringstream stream(text);
    auto polygons = read_polygons(stream, "scene.polygons", 512, 512);
    check_polygons(polygons, 512, 512);
    return polygons;
}

void expect_error(const std::string& text, const char* where, const char* what) {
    EXPECT_THAT([&] { read(text); }, ThrowsMessage<std::runtime_error>(
                                         testing::AllOf(StartsWith(where), HasSubstr(what))))
        << text;
}

std::uint32_t covered(const std::vector<Polygon>& polygons) {
    const auto drawn = render_polygons(polygons, {});
    return static_cast<std::uint32_t>(std::count_if(drawn.drawn.begin(), drawn.drawn.end(),
                                                    [](auto count) { return count > 0; }));
}

TEST(PolygonFile, ReadsPolygonsCommentsAndFractionsOfLevels) {
    const auto polygons = read(
        "# two\n\npolygon # first\n 0 0 1200 96\r\n511 0 1200 96.5 # end\n"
        "\t256 400 3000 0.0078125\npolygon\n7 8 32766 255");
    EXPECT_EQ(polygons,
              (std::vector<Polygon>{
                  {{{0, 0, 1200, 96 * 128}, {511, 0, 1200, 96 * 128 + 64}, {256, 400, 3000, 1}}},
                  {{{7, 8, kFarthest, 255 * kShadeUnit}}}}));
}

TEST(PolygonFile, ReadsBackWhatItWrote) {
    EXPECT_TRUE(rc::check([] {
        std::vector<Polygon> polygons;
        for (int k = *rc::gen::inRange(1, 20); k > 0; --k)
            polygons.push_back(random_convex_polygon(512, 512));
        RC_ASSERT(read(polygons_as_text(polygons)) == polygons);
    }));
    const auto path = std::filesystem::path(testing::TempDir()) / "round_trip.polygons";
    const std::vector<Polygon> polygons{{{{1, 2, 3, 4}}}};
    save_polygons(path, polygons);
    EXPECT_EQ(load_polygons(path, 512, 512), polygons);
    std::filesystem::remove(path);
}

TEST(PolygonFile, DropsRepeatedVertices) {
    EXPECT_EQ(read("polygon\n0 0 0 0\n0 0 9 9\n9 0 0 0\n0 9 0 0\n0 0 5 5\n"),
              read("polygon\n0 0 0 0\n9 0 0 0\n0 9 0 0\n"));
    EXPECT_EQ(read("polygon\n4 4 0 7\n4 4 1 8\n"), read("polygon\n4 4 0 7\n"));
}

TEST(PolygonFile, DividesPolygonsWithTooManyVerticesOrDents) {
    const auto twelve = read(
        "polygon\n10 0 0 0\n20 0 0 0\n27 3 0 0\n30 10 0 0\n30 20 0 0\n"
        "27 27 0 0\n20 30 0 0\n10 30 0 0\n3 27 0 0\n0 20 0 0\n0 10 0 0\n"
        "3 3 0 0\n");
    EXPECT_EQ(twelve.size(), 2U);
    const auto dent = read("polygon\n0 0 0 0\n100 0 0 0\n100 100 0 0\n50 1 0 0\n0 100 0 0\n");
    EXPECT_EQ(dent.size(), 3U);
    // A square of 101 x 101 pixels, less the triangle above the dent: 100 wide, 99 high.
    EXPECT_NEAR(covered(dent), 101 * 101 - 100 * 99 / 2, 60);
}

TEST(PolygonFile, MakesALineOfVerticesInALine) {
    EXPECT_EQ(read("polygon\n0 0 1 1\n8 8 2 2\n4 4 3 3\n6 6 4 4\n"),
              read("polygon\n0 0 1 1\n8 8 2 2\n"));
    EXPECT_EQ(read("polygon\n0 0 1 1\n4 4 2 2\n8 8 3 3\n")[0].vertices.size(), 3U);
}

TEST(PolygonFile, SaysWhereAndWhatIsWrong) {
    expect_error("", "scene.polygons: ", "no polygons");
    expect_error("# nothing\n", "scene.polygons: ", "no polygons");
    expect_error("1 2 3 4\n", "scene.polygons:1: ", "'1', expected 'polygon' before");
    expect_error("polygons\n", "scene.polygons:1: ", "'polygons', expected 'polygon'");
    expect_error("polygon 3\n", "scene.polygons:1: ", "'3' after 'polygon'");
    expect_error("polygon\npolygon\n1 1 1 1\n", "scene.polygons:1: ", "without vertices");
    expect_error("polygon\n1 1 1 1\n\npolygon", "scene.polygons:4: ", "without vertices");
    expect_error("polygon\n1 2 3\n", "scene.polygons:2: ", "3 words from '1' on");
    expect_error("polygon\n1 2 3 4 5\n", "scene.polygons:2: ", "5 words");
    expect_error("polygon\n1 2 3 \n", "scene.polygons:2: ", "3 words");
    expect_error("polygon\n512 2 3 4\n",
                 "scene.polygons:2: ", "x is '512', expected a whole number from 0 to 511");
    expect_error("polygon\n-1 2 3 4\n", "scene.polygons:2: ", "x is '-1'");
    expect_error("polygon\n1 2.5 3 4\n", "scene.polygons:2: ", "y is '2.5'");
    expect_error("polygon\n1 2 32767 4\n", "scene.polygons:2: ", "z is '32767'");
    expect_error("polygon\n1 99999999999999999999 3 4\n", "scene.polygons:2: ", "y is '99999");
    expect_error("polygon\n1 2 0x3 4\n", "scene.polygons:2: ", "z is '0x3'");
    for (const std::string bad : {"nan", "inf", "-0.1", "255.1", "1,5", "grey", "1e999"})
        expect_error("polygon\n1 2 3 " + bad + "\n",
                     "scene.polygons:2: ", ("the grey level is '" + bad + "'").c_str());
    expect_error("polygon\n0 0 0 0\n0 9 0 0\n9 0 0 0\n", "scene.polygons:1: ", "clockwise");
    expect_error("polygon\n0 0 0 0\n9 9 0 0\n9 0 0 0\n0 5 0 0\n", "scene.polygons:1: ", "crosses");
    expect_error(std::string("polygon\n1 2 \0 4\n", 16), "scene.polygons:2: ", "'\\x00'");
}

TEST(PolygonFile, RefusesOutlinesThatGoOnAndOn) {
    std::string text = "polygon\n";
    for (int k = 0; k < 501; ++k)
        text += std::to_string(k % 2) + " " + std::to_string(k) + " 0 0\n";
    expect_error(text, "scene.polygons:502: ", "more than 500 vertices");
}

TEST(PolygonFile, SaysWhenThereIsNoSuchFile) {
    for (const auto* path : {"/nowhere/at.polygons", "/"})
        EXPECT_THAT([&] { load_polygons(path, 512, 512); },
                    ThrowsMessage<std::runtime_error>(StartsWith(path)));
    EXPECT_THROW(save_polygons("/nowhere/at.polygons", {}), std::runtime_error);
}

TEST(PolygonFile, ReadsOrRefusesWhateverStandsInIt) {
    const std::vector<Polygon> base{{{{0, 0, 7, 1}, {40, 3, 8, 2}, {30, 50, 9, 3}}},
                                    {{{5, 5, 0, 0}}}};
    const auto text = polygons_as_text(base);
    EXPECT_TRUE(rc::check([&] {
        auto damaged = text;
        for (int k = *rc::gen::inRange(1, 8); k > 0; --k) {
            const auto at = *rc::gen::inRange<std::size_t>(0, damaged.size());
            const auto c =
                *rc::gen::oneOf(rc::gen::element<char>('0', '9', ' ', '\n', '-', '.', '#'),
                                rc::gen::arbitrary<char>());
            if (*rc::gen::arbitrary<bool>())
                damaged[at] = c;
            else if (*rc::gen::arbitrary<bool>())
                damaged.insert(at, 1, c);
            else
                damaged.erase(at, *rc::gen::inRange<std::size_t>(1, 12));
        }
        try {
            read(damaged);
        } catch (const std::runtime_error& error) {
            const std::string what = error.what();
            RC_ASSERT(what.starts_with("scene.polygons:"));
            RC_ASSERT(what.find('\n') == std::string::npos);
        }
    }));
}

// Any outline: valid polygons come out, or an error of one line.
TEST(PolygonFile, MakesValidPolygonsOfAnyOutlineItAccepts) {
    EXPECT_TRUE(rc::check([] {
        const int size = *rc::gen::element(4, 30, 512);
        const Polygon outline{random_vertices(*rc::gen::inRange(1, 14), size, size)};
        try {
            const auto polygons = read(polygons_as_text(std::vector{outline}));
            std::int64_t area = 0;
            for (const auto& polygon : polygons)
                area += doubled_area(polygon.vertices);
            RC_ASSERT(area == doubled_area(outline.vertices));
        } catch (const std::runtime_error&) {
        }
    }));
}

}  // namespace
}  // namespace rasterloom::host
