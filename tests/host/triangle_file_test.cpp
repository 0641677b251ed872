// SPDX-License-Identifier: MIT
#include "machine/host/triangle_file.hpp"

#include "tests/damage.hpp"
#include "tests/host/screen_triangles.hpp"
#include "topologies/text_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;
using topology::TextFileError;

std::vector<ScreenTriangle> read(const std::string& text) {
    std::istringstream in(text);
    return read_triangles(in, "t");
}

void expect_error(const std::string& text, const char* message) {
    EXPECT_THAT([&] { read(text); }, ThrowsMessage<TextFileError>(StartsWith(message))) << text;
}

TEST(TriangleFile, HasATriangleALine) {
    EXPECT_THAT(read("# x y z grey\n\n 1 2.5 3 4  5 -6.0625 7 8.5\t9 1e1 11 255 # one\r\n"),
                ElementsAre(ScreenTriangle{
                    {{{16, 40, 3, 512}, {80, -97, 7, 1088}, {144, 160, 11, 32640}}}}));
}

TEST(TriangleFile, RoundsToSixteenthsOfAPixelAnd128thsOfALevel) {
    const auto vertex = read("0.03 0.04 0 0.003  -0.03 -0.04 0 0.004  0 0 0 0")[0].vertices;
    EXPECT_EQ(vertex[0], (ScreenVertex{0, 1, 0, 0}));
    EXPECT_EQ(vertex[1], (ScreenVertex{0, -1, 0, 1}));
}

TEST(TriangleFile, KeepsBacksAndTrianglesWithoutArea) {
    EXPECT_EQ(read("0 0 0 0  9 0 0 0  0 9 0 0\n0 0 0 0  0 0 0 0  0 0 0 0\n").size(), 2U);
}

TEST(TriangleFile, ReadsBackAsItWasWritten) {
    EXPECT_TRUE(rc::check([] {
        std::vector<ScreenTriangle> triangles;
        for (int k = *rc::gen::inRange(1, 20); k > 0; --k)
            triangles.push_back(*rc::gen::arbitrary<bool>()
                                    ? any_triangle(-kFarthestVertex, kFarthestVertex)
                                    : any_textured_triangle(-kFarthestVertex, kFarthestVertex));
        RC_ASSERT(read(triangles_as_text(triangles)) == triangles);
    }));
    const auto path = std::filesystem::path(testing::TempDir()) / "round_trip.triangles";
    const std::vector triangles{triangle_of({{{1, 2}, {3, 4}, {-5, 6}}})};
    save_triangles(path, triangles);
    EXPECT_EQ(load_triangles(path), triangles);
    std::filesystem::remove(path);
}

TEST(TriangleFile, HasPlacesInATextureAfterTheVerticesOrNone) {
    const std::string place = "0 0 0 0  9 0 0 0  0 9 0 0";
    const auto vertex = read(place + "  0 1  0.5 0.25  0.00001 0.99999")[0].vertices;
    EXPECT_EQ(vertex[0], (ScreenVertex{0, 0, 0, 0, 0, 65535}));
    EXPECT_EQ(vertex[1], (ScreenVertex{144, 0, 0, 0, 32768, 16384}));
    EXPECT_EQ(vertex[2], (ScreenVertex{0, 144, 0, 0, 1, 65535}));
    EXPECT_EQ(triangles_as_text(read(place + " 0 0 0 0 0 0")), place + "\n");
}

TEST(TriangleFile, TellsAllPlacesInATextureApart) {
    std::vector<ScreenTriangle> triangles(kTextureUnits / 3 + 1);
    for (int k = 0; k < kTextureUnits; ++k)
        triangles[static_cast<std::size_t>(k / 3)].vertices[static_cast<std::size_t>(k % 3)].u = k;
    EXPECT_EQ(read(triangles_as_text(triangles)), triangles);
}

TEST(TriangleFile, SaysWhereWhatAndWhatWasExpected) {
    const std::string two = "0 0 0 0 1 0 0 0 ";
    expect_error("", "t: nothing in the file, expected lines of three vertices 'x y z grey'");
    expect_error("# nothing\n", "t: nothing in the file");
    expect_error("\n" + two + "0 1 0", "t:2:22: grey is the end of the line, expected a number");
    expect_error(two + "0 1 0 0 2", "t:1:25: u is '2', expected a number from 0 to 1");
    expect_error(two + "0 1 0 0 0.5", "t:1:28: v is the end of the line, expected a number");
    expect_error(two + "0 1 0 0 0 0 0 0 0 -1", "t:1:35: v is '-1', expected a number from 0 to 1");
    expect_error(two + "0 1 0 0 0 0 0 0 0 1 7",
                 "t:1:37: '7', expected nothing after the third vertex' u and v");
    expect_error(two + "x 1 0 0", "t:1:17: x is 'x', expected a number from -32767 to 32767");
    expect_error(two + "nan 1 0 0", "t:1:17: x is 'nan'");
    expect_error(two + "0 -32768 0 0", "t:1:19: y is '-32768', expected a number from -32767");
    expect_error(two + "0 1e99999 0 0", "t:1:19: y is '1e99999'");
    expect_error(two + "0 1 32767 0", "t:1:21: z is '32767', expected a number from 0 to 32766");
    expect_error(two + "0,1 0 0", "t:1:17: x is '0,1', expected a number");
    expect_error(two + "0 1 -1 0", "t:1:21: z is '-1'");
    expect_error(two + "0 1.5.5 0 0", "t:1:19: y is '1.5.5', expected a number");
    expect_error(two + "0 1 0 255.5", "t:1:23: grey is '255.5', expected a number from 0 to 255");
}

TEST(TriangleFile, ThatIsNotThereIsNamed) {
    EXPECT_THAT([] { load_triangles("no/such.triangles"); },
                ThrowsMessage<TextFileError>(StartsWith("no/such.triangles: no such file")));
    EXPECT_THAT([] { load_triangles(testing::TempDir()); },
                ThrowsMessage<TextFileError>(HasSubstr("expected triangles on the screen")));
}

TEST(DamagedTriangleFile, IsReadOrRefused) {
    const std::string whole =
        "0 0 5 10.5  0 9.25 6 20  -8 0 7 30\n1 2 3 4 5 6 7 8 9 10 11 12\n"
        "0 0 5 10.5  0 9.25 6 20  -8 0 7 30  0 0.5  1 0.25  0 1\n";
    const int rounds = std::getenv("RASTERLOOM_LONG_TESTS") != nullptr ? 200'000 : 3'000;
    std::mt19937 random(1);
    int refused = 0;
    for (int round = 0; round < rounds; ++round) {
        const std::string text = damaged(whole, random);
        try {
            for (const auto& triangle : read(text))
                for (const auto& vertex : triangle.vertices) {
                    ASSERT_LE(std::max(std::abs(vertex.x), std::abs(vertex.y)), kFarthestVertex);
                    ASSERT_TRUE(0 <= vertex.depth && vertex.depth <= kFarthest);
                    ASSERT_TRUE(0 <= vertex.shade && vertex.shade <= 255 * kShadeUnit);
                    ASSERT_TRUE(0 <= std::min(vertex.u, vertex.v) &&
                                std::max(vertex.u, vertex.v) < kTextureUnits);
                }
        } catch (const TextFileError& error) {
            ++refused;
            ASSERT_THAT(error.what(), StartsWith("t:")) << text;
        }
    }
    EXPECT_GT(refused, rounds / 20);
    EXPECT_LT(refused, rounds);
}

}  // namespace
}  // namespace rasterloom::host
