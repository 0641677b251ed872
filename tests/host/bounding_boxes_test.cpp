// SPDX-License-Identifier: MIT
#include "machine/host/bounding_boxes.hpp"

#include "tests/damage.hpp"
#include "topologies/text_line.hpp"

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom::host {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;
using topology::TextFileError;

std::vector<BoundingBox> read(const std::string& text) {
    std::istringstream in(text);
    return read_bounding_boxes(in, "b");
}

void expect_error(const std::string& text, const char* message) {
    EXPECT_THAT([&] { read(text); }, ThrowsMessage<TextFileError>(StartsWith(message))) << text;
}

BoundingBox any_box() {
    const auto whole = [](int least) {
        return *rc::gen::inRange(least, static_cast<int>(topology::kFarthestPixel) + 1);
    };
    BoundingBox any{*rc::gen::arbitrary<bool>(), {whole(0), whole(0), 0, 0}};
    any.box.x1 = whole(any.box.x0);
    any.box.y1 = whole(any.box.y0);
    return any;
}

TEST(BoundingBoxes, ReadTheThesisSample) {
    EXPECT_THAT(read("NumPolygons=3\n0 (406,163) (407,164)\n1 (406,182) (415,185)\n"
                     "1 (364,219) (370,223)\n"),
                ElementsAre(BoundingBox{false, {406, 163, 407, 164}},
                            BoundingBox{true, {406, 182, 415, 185}},
                            BoundingBox{true, {364, 219, 370, 223}}));
}

TEST(BoundingBoxes, ReadBlanksCommentsAndForeignLineEnds) {
    EXPECT_THAT(read("# two\r\n\r\n NumPolygons = 2 \r\n1\t( 0 , 1 )(2,3) # one\r\n0(4,5)(4,5)"),
                ElementsAre(BoundingBox{true, {0, 1, 2, 3}}, BoundingBox{false, {4, 5, 4, 5}}));
}

TEST(BoundingBoxes, ReadBackAsTheyWereWritten) {
    EXPECT_TRUE(rc::check([] {
        std::vector<BoundingBox> boxes;
        for (int k = *rc::gen::inRange(1, 30); k > 0; --k)
            boxes.push_back(any_box());
        RC_ASSERT(read(bounding_boxes_as_text(boxes)) == boxes);
    }));
    const auto path = std::filesystem::path(testing::TempDir()) / "round_trip.boxes";
    const std::vector<BoundingBox> boxes{{true, {1, 2, 3, 4}}};
    save_bounding_boxes(path, boxes);
    EXPECT_EQ(load_bounding_boxes(path), boxes);
    std::filesystem::remove(path);
}

TEST(BoundingBoxes, SayWhereWhatAndWhatWasExpected) {
    expect_error("", "b: nothing in the file, expected 'NumPolygons=' and a number");
    expect_error("\n# boxes\n", "b: nothing in the file");
    expect_error("1 (1,2) (3,4)\n", "b:1:1: '1', expected 'NumPolygons'");
    expect_error("NumPolygons 1\n", "b:1:13: '1', expected '='");
    expect_error("NumPolygons=\n", "b:1:13: NumPolygons is the end of the line, expected");
    expect_error("NumPolygons=0\n",
                 "b:1:13: NumPolygons is '0', expected a whole number from 1 to 16777216");
    expect_error("NumPolygons=16777217\n", "b:1:13: NumPolygons is '16777217'");
    expect_error("NumPolygons=99999999999999999999\n", "b:1:13: NumPolygons is '9999");
    expect_error("NumPolygons=1 2\n", "b:1:15: '2', expected nothing after the number");
    const std::string two = "NumPolygons=2\n";
    expect_error(two + "1 (1,2) (3,4)\n\n",
                 "b:4:1: the end of the file after 1 polygons, expected 2 (NumPolygons=2)");
    expect_error(two + "1 (1,2) (3,4)\n1 (1,2) (3,4)\n\n1 (1,2) (3,4)\n",
                 "b:5:1: '1', expected the end of the file after 2 polygons (NumPolygons=2)");
    expect_error(two + " 2 (1,2) (3,4)\n",
                 "b:2:2: the visible flag is '2', expected a whole number from 0 to 1");
    expect_error(two + "-1 (1,2) (3,4)\n", "b:2:1: the visible flag is '-1'");
    expect_error(two + "yes (1,2) (3,4)\n", "b:2:1: the visible flag is 'yes'");
    expect_error(two + "1 1,2 3,4\n", "b:2:3: '1,2', expected '('");
    expect_error(two + "1 (-1,2) (3,4)\n",
                 "b:2:4: x is '-1,2)', expected a whole number from 0 to 32767");
    expect_error(two + "1 (1,32768) (3,4)\n", "b:2:6: y is '32768)'");
    expect_error(two + "1 (1.5,2) (3,4)\n", "b:2:5: '.5,2)', expected ','");
    expect_error(two + "1 (3,2) (1,4)\n",
                 "b:2:10: the second corner's x is '1,4)', expected a whole number from 3 to");
    expect_error(two + "1 (1,4) (3,2)\n", "b:2:12: the second corner's y is '2)'");
    expect_error(two + "1 (1,2) (3,4\n", "b:2:13: the end of the line, expected ')'");
    expect_error(two + "1 (1,2) (3,4) 5\n", "b:2:15: '5', expected nothing after the second");
    expect_error(two + std::string("1 (1,2\0) (3,4)\n", 16), "b:2:7: '\\x00)', expected ')'");
}

TEST(BoundingBoxes, OfAFileThatIsNotThereNameIt) {
    EXPECT_THAT([] { load_bounding_boxes("no/such.boxes"); },
                ThrowsMessage<TextFileError>(StartsWith("no/such.boxes: no such file")));
    EXPECT_THAT([] { load_bounding_boxes(testing::TempDir()); },
                ThrowsMessage<TextFileError>(HasSubstr("expected bounding boxes")));
}

TEST(DamagedBoundingBoxes, AreReadOrRefused) {
    const std::string whole =
        "NumPolygons=3\n0 (6,13) (7,14)\n1 (406,182) (415,185)\n1 (3,2) (3,2)";
    const int rounds = std::getenv("RASTERLOOM_LONG_TESTS") != nullptr ? 200'000 : 3'000;
    std::mt19937 random(1);
    int refused = 0;
    for (int round = 0; round < rounds; ++round) {
        const std::string text = damaged(whole, random);
        try {
            for (const auto& [is_visible, box] : read(text)) {
                ASSERT_TRUE(0 <= box.x0 && box.x0 <= box.x1 && box.x1 <= topology::kFarthestPixel);
                ASSERT_TRUE(0 <= box.y0 && box.y0 <= box.y1 && box.y1 <= topology::kFarthestPixel);
            }
        } catch (const TextFileError& error) {
            ++refused;
            ASSERT_THAT(error.what(), StartsWith("b:")) << text;
        }
    }
    EXPECT_GT(refused, rounds / 20);
    EXPECT_LT(refused, rounds);
}

}  // namespace
}  // namespace rasterloom::host
