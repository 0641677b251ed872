// SPDX-License-Identifier: MIT
#include "machine/observe/bucket_report.hpp"

#include "machine/observe/bucket_json.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::observe {
namespace {

using testing::HasSubstr;
using testing::Not;

BucketReport two_rasterizers() {
    BucketReport report;
    report.tile_width = 16;
    report.tile_height = 8;
    report.tiles = 24;
    report.frames = {{7, 4, 10, 300, 6, 50, 900}, {}};
    report.rasterizers = {{"R0", 4, 7, 1, 200, 70, 20, 10, 200, 100, 2},
                          {"R1, say", 2, 3, 0, 100, 30, 0, 70, 100, 0, 1}};
    return report;
}

BucketReport programs() {
    BucketReport report = two_rasterizers();
    report.hardware = false;
    for (BucketReport::Rasterizer& each : report.rasterizers) {
        each = {each.name, each.tiles, each.pairs};
    }
    return report;
}

TEST(BucketReport, CountsOverlapByTrianglesThatMeetATile) {
    EXPECT_DOUBLE_EQ(two_rasterizers().frames[0].overlap(), 2.5);
    EXPECT_EQ(two_rasterizers().frames[1].overlap(), 0);
}

TEST(BucketReport, WritesARowARasterizer) {
    EXPECT_EQ(rasterizers_csv(two_rasterizers()),
              "name,tiles,pairs,pairs_without_pixels,pixels,triangle_busy_u,triangle_blocked_u,"
              "triangle_starved_u,pixel_busy_u,pixel_starved_u,fifo_peak\n"
              "R0,4,7,1,200,70,20,10,200,100,2\n"
              "\"R1, say\",2,3,0,100,30,0,70,100,0,1\n");
}

TEST(BucketReport, SumsUpTheUnitsOfAllRasterizers) {
    EXPECT_EQ(bucket_summary(two_rasterizers()),
              "Tiles           24 of 16 x 8 pixels\n"
              "Frame 0         7 triangles, 4 in 6 tiles: 10 pairs, overlap 2.500, 300 pixels; 50 "
              "cycles to sort, 900 to draw\n"
              "Frame 1         0 triangles, 0 in 0 tiles: 0 pairs, overlap 0.000, 0 pixels; 0 "
              "cycles to sort, 0 to draw\n"
              "Triangle units  200 cycles: 50.0% busy, 10.0% the FIFO was full\n"
              "Pixel units     400 cycles: 75.0% busy, 25.0% the FIFO was empty\n");
}

TEST(BucketReport, SaysNothingOfUnitsThatProgramsDoNotHave) {
    EXPECT_THAT(bucket_summary(programs()), Not(HasSubstr("unit")));
    const auto row = bucket_json(programs())["rasterizers"][0];
    EXPECT_EQ(row.dump(), R"({"name":"R0","tiles":4,"pairs":7})");
}

TEST(BucketReport, SaysNothingIsNothingWhereNothingWasDrawn) {
    BucketReport report;
    report.rasterizers.emplace_back();
    EXPECT_THAT(bucket_summary(report), HasSubstr("Triangle unit   0 cycles: 0.0% busy"));
}

TEST(BucketReport, IsWrittenAsJsonWithAllThatItHolds) {
    const auto json = bucket_json(two_rasterizers());
    EXPECT_EQ(json["tile_width"], 16);
    EXPECT_EQ(json["tile_height"], 8);
    EXPECT_EQ(json["tiles"], 24);
    EXPECT_EQ(json["rasterizer"], "hardware");
    EXPECT_EQ(json["frames"][0].dump(),
              R"({"triangles":7,"visible":4,"pairs":10,"overlap":2.5,"pixels":300,"tiles":6,)"
              R"("sort_u":50,"draw_u":900})");
    EXPECT_EQ(json["rasterizers"][0].dump(),
              R"({"name":"R0","tiles":4,"pairs":7,"pairs_without_pixels":1,"pixels":200,)"
              R"("triangle_unit":{"busy_u":70,"blocked_u":20,"starved_u":10},)"
              R"("pixel_unit":{"busy_u":200,"starved_u":100},"fifo_peak":2})");
}

}  // namespace
}  // namespace rasterloom::observe
