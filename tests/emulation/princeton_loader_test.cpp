// SPDX-License-Identifier: MIT
#include "machine/emulation/princeton_loader.hpp"

#include "machine/host/triangle_tables.hpp"
#include "tests/emulation/princeton_lanes.hpp"

#include <map>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// Polygons that know their numbers.
host::TriangleScene numbered(int polygons) {
    host::TriangleScene scene;
    for (int b = 0; b < polygons; ++b) {
        host::SceneTriangle triangle;
        triangle.vertices[0].place[0] = static_cast<std::int16_t>(b);
        triangle.vertices[2].normal[2] = static_cast<std::int16_t>(-b);
        scene.triangles.push_back(triangle);
    }
    return scene;
}

std::vector<int> polygons_on(PrincetonLanes& lanes, std::int64_t lane) {
    std::vector<int> numbers;
    std::uint32_t address = lanes.word(lane, "polygons_at");
    for (int k = 0; k < lanes.word(lane, "polygons"); ++k) {
        std::array<std::uint16_t, host::kTriangleWords> words{};
        lanes.array().read(lane, address, words);
        numbers.push_back(host::from_words(words).vertices[0].place[0]);
        address += lanes.at("kPolygon");
    }
    return numbers;
}

TEST(PrincetonLoader, DealsPolygonsRoundRobin) {
    PrincetonLanes lanes(8);
    lanes.load(numbered(19));
    EXPECT_THAT(polygons_on(lanes, 0), ElementsAre(0, 8, 16));
    EXPECT_THAT(polygons_on(lanes, 2), ElementsAre(2, 10, 18));
    EXPECT_THAT(polygons_on(lanes, 3), ElementsAre(3, 11));
    EXPECT_EQ(lanes.word(7, "most"), 3);
    EXPECT_EQ(lanes.word(7, "lane"), 7);
    EXPECT_EQ(lanes.word(7, "lanes"), 8);
}

RC_GTEST_PROP(PrincetonLoader, PutsEveryCopyOfAPolygonOnALaneOfItsResidue, ()) {
    const int copies = 1 << *rc::gen::inRange(0, 4);
    const int groups = *rc::gen::inRange(1, 20);
    const int polygons = *rc::gen::inRange(1, 200);
    PrincetonLanes lanes(copies * groups, fmt::format("duplication = {}\n{}", copies, kNothing));
    lanes.load(numbered(polygons));
    std::map<int, int> found;
    for (std::int64_t lane = 0; lane < lanes.array().lanes(); ++lane) {
        RC_ASSERT(lanes.word(lane, "polygons") <= lanes.word(lane, "most"));
        for (const int b : polygons_on(lanes, lane)) {
            RC_ASSERT(b % groups == lane % groups);
            ++found[b];
        }
    }
    RC_ASSERT(static_cast<int>(found.size()) == polygons);
    for (const auto& [b, times] : found)
        RC_ASSERT(times == copies);
}

constexpr const char* kSortFirst =
    "sort_first = 1\n        .include \"memory.s\"\n        .include \"wanted.s\"\n"
    "start:  halt\n        .end start\n";

// Of a lane, by the program's symbols.
struct Room {
    explicit Room(PrincetonLanes& lanes)
        : polygons_at(lanes.word(1, "polygons_at")),
          most(lanes.word(1, "most")),
          source_at(lanes.word(1, "source_at")),
          source_end(lanes.word(1, "source_end")),
          receive_at(lanes.word(1, "receive_at")),
          receive_end(lanes.word(1, "receive_end")),
          descriptor(static_cast<int>(lanes.at("kDescriptor"))) {}

    int polygons_at, most, source_at, source_end, receive_at, receive_end, descriptor;
};

RC_GTEST_PROP(PrincetonLoader, GivesTheRestOfTheRoomToBothQueuesButForOneToBeReceived, ()) {
    const int stride = 1 << *rc::gen::inRange(0, 3);
    PrincetonLanes lanes(2, fmt::format("stride = {}\n{}", stride, kNothing));
    lanes.load(numbered(*rc::gen::inRange(1, 2 * 1191)));
    const Room room(lanes);
    RC_ASSERT(room.polygons_at == static_cast<int>(lanes.at("scratch_end")));
    RC_ASSERT(room.source_at == room.polygons_at + 24 * room.most);
    RC_ASSERT(room.source_end > room.source_at);
    RC_ASSERT(room.receive_end - room.source_end == room.descriptor);
    RC_ASSERT(room.receive_end <= 0x8000);
    RC_ASSERT(room.receive_end > 0x8000 - room.descriptor);
}

RC_GTEST_PROP(PrincetonLoader, HasRoomForTwiceThePolygonsThenForAsManyCopiesAsDescriptors, ()) {
    constexpr int kHome = 27;
    PrincetonLanes lanes(2, kSortFirst);
    lanes.load(numbered(*rc::gen::inRange(1, 2 * 500)));
    const Room room(lanes);
    RC_ASSERT(lanes.word(1, "homes_end") == room.polygons_at + kHome * (2 * room.most + 1));
    RC_ASSERT(room.receive_at == lanes.word(1, "homes_end"));
    RC_ASSERT(room.source_at == room.receive_end);
    const int copies = (room.receive_end - room.receive_at) / kHome;
    RC_ASSERT(copies >= 2);
    RC_ASSERT((room.source_end - room.source_at) / room.descriptor == copies);
    RC_ASSERT(room.source_end <= 0x8000);
    RC_ASSERT(room.source_end > 0x8000 - room.descriptor - kHome);
}

TEST(PrincetonLoader, LeavesRoomBetweenPolygonsThatMigrate) {
    PrincetonLanes lanes(2, kSortFirst);
    lanes.load(numbered(6));
    const std::uint32_t second = lanes.word(1, "polygons_at") + 27U;
    EXPECT_EQ(lanes.array().read(1, second), 3);
}

TEST(PrincetonLoader, GivesTheTablesToEveryLane) {
    PrincetonLanes lanes(3);
    lanes.load(numbered(1));
    const auto reciprocals = host::reciprocal_table();
    const auto roots = host::root_table();
    for (std::int64_t lane = 0; lane < 3; ++lane) {
        for (std::uint32_t z : {0U, 4097U, 20000U, 32767U})
            EXPECT_EQ(lanes.word(lane, "reciprocals", z), reciprocals[z]);
        for (std::uint32_t m : {0U, 200U, 383U})
            EXPECT_EQ(lanes.word(lane, "roots", m), roots[m]);
    }
}

TEST(PrincetonLoader, GivesViewAndLightsToEveryLane) {
    PrincetonLanes lanes(2);
    host::TriangleView view;
    for (std::size_t k = 0; k < 12; ++k)
        view.matrix[k] = static_cast<std::int16_t>(-static_cast<int>(k));
    view.focal = 9000;
    view.near = 5000;
    host::TriangleLights lights;
    lights.ambient = 1;
    lights.sun = {2, -3, 4};
    lights.sun_diffuse = 5;
    lights.sun_specular = 6;
    lights.lamp = {-7, 8, 9};
    lights.lamp_diffuse = 10;
    lights.lamp_specular = 11;
    lights.shininess = 3;
    lanes.load(numbered(1), view, lights);
    EXPECT_EQ(lanes.word(1, "matrix", 0), 0);
    EXPECT_EQ(lanes.word(1, "matrix", 11), 0x10000 - 11);
    EXPECT_EQ(lanes.word(1, "focal"), 9000);
    EXPECT_EQ(lanes.word(1, "near"), 5000);
    EXPECT_EQ(lanes.word(1, "ambient"), 1);
    EXPECT_EQ(lanes.word(1, "sun", 1), 0x10000 - 3);
    EXPECT_EQ(lanes.word(1, "sun_diffuse"), 5);
    EXPECT_EQ(lanes.word(1, "sun_specular"), 6);
    EXPECT_EQ(lanes.word(1, "lamp", 2), 9);
    EXPECT_EQ(lanes.word(1, "lamp_diffuse"), 10);
    EXPECT_EQ(lanes.word(1, "lamp_specular"), 11);
    EXPECT_EQ(lanes.word(1, "shininess"), 3);
    view.matrix[11] = 20000;
    load_matrix(lanes.array(), lanes.image(), view.matrix);
    EXPECT_EQ(lanes.word(0, "matrix", 11), 20000);
}

TEST(PrincetonLoader, RepeatsTheTextureBehindItsLastColumnAndRow) {
    PrincetonLanes lanes(2);
    host::TriangleScene scene = numbered(1);
    scene.textures.emplace_back();
    for (int i = 0; i < 128 * 128; ++i)
        scene.textures[0].texels.push_back(static_cast<std::uint16_t>(i));
    lanes.load(scene);
    const auto texel = [&](int column, int row) {
        return lanes.array().read(1, slow_word(0, static_cast<std::uint16_t>(256 * row + column)));
    };
    EXPECT_EQ(texel(5, 3), 3 * 128 + 5);
    EXPECT_EQ(texel(127, 127), 128 * 128 - 1);
    EXPECT_EQ(texel(128, 3), 3 * 128);
    EXPECT_EQ(texel(5, 128), 5);
    EXPECT_EQ(texel(128, 128), 0);
}

TEST(PrincetonLoader, NumbersLanesInWordsWithoutASign) {
    PrincetonLanes lanes(65536);
    lanes.load(numbered(1));
    EXPECT_EQ(lanes.word(65535, "lane"), 65535);
    EXPECT_EQ(lanes.word(65535, "lanes"), 0) << "modulo 65536";
    PrincetonLanes fewer(65535);
    fewer.load(numbered(1));
    EXPECT_EQ(fewer.word(0, "lanes"), 65535);
}

TEST(PrincetonLoader, GivesColumnsToTheFirstLanes) {
    PrincetonLanes lanes(800);
    lanes.load(numbered(1));
    EXPECT_EQ(lanes.word(767, "column"), 767);
    EXPECT_EQ(lanes.word(768, "column"), 0x7fff);
    PrincetonLanes few(64);
    few.load(numbered(1));
    EXPECT_EQ(few.word(63, "column"), 63);
}

class PrincetonLoaderErrors : public ::testing::Test {
  protected:
    // What is said about `polygons` on `lanes`.
    static void expect(std::int64_t lanes, const std::string& options, int polygons,
                       const ::testing::Matcher<std::string>& message) {
        PrincetonLanes array(lanes, options + kNothing);
        EXPECT_THAT([&] { array.load(numbered(polygons)); },
                    ThrowsMessage<std::invalid_argument>(message));
    }

    static void expect_map(const ColumnMap& columns, const std::string& message) {
        PrincetonLanes lanes(4);
        EXPECT_THAT(
            [&] { load_princeton(lanes.array(), lanes.image(), numbered(1), {}, {}, columns); },
            ThrowsMessage<std::invalid_argument>(HasSubstr(message)));
    }
};

TEST_F(PrincetonLoaderErrors, SayHowManyPolygonsFitAndWhatLanesWouldDo) {
    PrincetonLanes(4).load(numbered(4 * 1191));
    expect(4, "", 4 * 1191 + 1,
           AllOf(HasSubstr("4765 polygons on 4 lanes: 1192 on a lane, expected 1191 at most, which "
                           "is 4764 in all"),
                 HasSubstr("; 5 lanes would do")));
    PrincetonLanes(5).load(numbered(4 * 1191 + 1));
    expect(4, "duplication = 2\n", 2 * 1191 + 1,
           AllOf(HasSubstr("2 copies of each: 1192 on a lane"), HasSubstr("2382 in all"),
                 HasSubstr("; 6 lanes would do")));
    PrincetonLanes(6, std::string("duplication = 2\n") + kNothing).load(numbered(2 * 1191 + 1));
}

TEST_F(PrincetonLoaderErrors, SayHowManyPolygonsFitWhereTheyMigrate) {
    PrincetonLanes(2, kSortFirst).load(numbered(2 * 527));
    PrincetonLanes lanes(2, kSortFirst);
    EXPECT_THAT(
        [&] { lanes.load(numbered(2 * 527 + 1)); },
        ThrowsMessage<std::invalid_argument>(HasSubstr("528 on a lane, expected 527 at most")));
}

TEST_F(PrincetonLoaderErrors, WantLanesThatAreAMultipleOfTheCopies) {
    expect(6, "duplication = 4\n", 1,
           HasSubstr("6 lanes for 4 copies of the polygons, expected a multiple"));
}

TEST_F(PrincetonLoaderErrors, NameTheColumnsThatAMapLeavesOutOrHasTwice) {
    expect_map({0, 1, 2}, "a screen map of 3 lanes, expected 4");
    expect_map({0, 1, std::nullopt, 3}, "column 2 to 0 lanes, expected one");
    expect_map({0, 1, 1, 2}, "column 1 to 2 lanes, expected one");
    expect_map({0, 1, 2, 4}, "column 4 to lane 3, expected 0 to 3");
}

TEST_F(PrincetonLoaderErrors, WantOneTextureAtMostAndTheWholeScreen) {
    PrincetonLanes lanes(1);
    host::TriangleScene scene = numbered(1);
    scene.textures.resize(2);
    EXPECT_THAT([&] { lanes.load(scene); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("2 textures, expected one")));
    host::TriangleView view;
    view.width = 640;
    EXPECT_THAT(
        [&] { lanes.load(numbered(1), view); },
        ThrowsMessage<std::invalid_argument>(HasSubstr("640 x 512 pixels, expected 768 x 512")));
}

TEST_F(PrincetonLoaderErrors, NameValuesThatAreNoWords) {
    PrincetonLanes lanes(1);
    host::TriangleView view;
    view.focal = 70000;
    EXPECT_THAT(
        [&] { lanes.load(numbered(1), view); },
        ThrowsMessage<std::invalid_argument>(HasSubstr("focal is 70000, expected a value")));
}

TEST_F(PrincetonLoaderErrors, NameSymbolsThatTheProgramLacks) {
    PrincetonLanes lanes(1);
    isa::Image image = lanes.image();
    image.symbols.erase("lamp");
    EXPECT_THAT(
        [&] { load_princeton(lanes.array(), image, numbered(1), {}, {}, {0}); },
        ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("lanes.s"), HasSubstr("'lamp'"))));
}

}  // namespace
}  // namespace rasterloom
