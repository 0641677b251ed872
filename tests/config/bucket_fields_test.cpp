// SPDX-License-Identifier: MIT
// The keys of bucket tilers.
#include "machine/config/export.hpp"
#include "tests/config/machine_text.hpp"

#include <ostream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::config {
namespace {

using testing::HasSubstr;

const std::string kSmallTiler =
    "machine: small\n"
    "topology: { kind: bucket_tiles, tile: 16x8, rasterizers: 2 }\n"
    "scene: { object: cube }\n";

TEST(BucketKeys, HaveTheDefaultsOfThePaper) {
    const MachineDescription machine = load_text(kSmallTiler);
    EXPECT_TRUE(machine.is_bucket_tiler());
    EXPECT_EQ(machine.rasterizer.kind, RasterizerKind::hardware);
    EXPECT_EQ(machine.rasterizer.cycles_per_triangle, 25);
    EXPECT_EQ(machine.rasterizer.cycles_per_pixel, 1);
    EXPECT_EQ(machine.rasterizer.fifo, 1);
    EXPECT_EQ(machine.sorter.rule, host::OverlapRule::bounding_box);
    EXPECT_EQ(machine.sorter.assignment, TileAssignment::interleaved);
    EXPECT_EQ(machine.sorter.time_per_triangle, Duration());
    EXPECT_EQ(machine.sorter.time_per_pair, Duration());
    EXPECT_EQ(machine.sorter.time_per_word, Duration());
}

TEST(BucketKeys, AreReadAndExported) {
    const MachineDescription machine = load_text(
        kSmallTiler,
        {"sorter={rule: covered, assignment: largest_first, largest_by: work, time_per_triangle: "
         "1us, time_per_pair: 20ns, time_per_word: 3ns}",
         "rasterizer={kind: software, cycles_per_triangle: 0, cycles_per_pixel: 4, fifo: "
         "unlimited, input_fifo: 9}",
         "nodes.program=pdp11/bucket.s"});
    EXPECT_EQ(machine.sorter.rule, host::OverlapRule::covered);
    EXPECT_EQ(machine.sorter.assignment, TileAssignment::largest_first);
    EXPECT_EQ(machine.sorter.largest_by, TileMeasure::work);
    EXPECT_EQ(machine.sorter.time_per_triangle, Duration::microseconds(1));
    EXPECT_EQ(machine.sorter.time_per_pair, Duration::nanoseconds(20));
    EXPECT_EQ(machine.sorter.time_per_word, Duration::nanoseconds(3));
    EXPECT_EQ(machine.rasterizer.kind, RasterizerKind::software);
    EXPECT_EQ(machine.rasterizer.cycles_per_triangle, 0);
    EXPECT_EQ(machine.rasterizer.cycles_per_pixel, 4);
    EXPECT_FALSE(machine.rasterizer.fifo);
    EXPECT_EQ(machine.rasterizer.input_fifo, 9);
    const std::string text = export_machine(machine);
    EXPECT_EQ(export_machine(read_machine(text, "exported.yaml", {}, source_tree())), text);
    EXPECT_THAT(text, HasSubstr("  fifo: unlimited\n"));
    EXPECT_THAT(export_machine(load_text(kSmallTiler, {"rasterizer.fifo=0"})),
                HasSubstr("  fifo: 0\n"));
}

TEST(BucketKeys, NeedAProgramInSoftwareOnly) {
    EXPECT_FALSE(load_text(kSmallTiler).has_program());
    EXPECT_THAT(refusal(kSmallTiler, {"rasterizer.kind=software"}),
                HasSubstr("nodes.program: missing"));
}

struct Bad {
    const char* change;
    const char* complaint;
};

void PrintTo(const Bad& bad, std::ostream* stream) {
    *stream << bad.change;
}

class BadBucketKey : public testing::TestWithParam<Bad> {};

TEST_P(BadBucketKey, IsRefusedWithWhatWasExpected) {
    EXPECT_THAT(refusal(kSmallTiler, {GetParam().change}), HasSubstr(GetParam().complaint));
}

INSTANTIATE_TEST_SUITE_P(
    Keys, BadBucketKey,
    testing::Values(
        Bad{"sorter.rule=box",
            "sorter.rule: no such choice 'box'; expected one of bounding_box, exact, covered"},
        Bad{"sorter.assignment=random",
            "no such choice 'random'; expected one of interleaved, blocks, next_free, "
            "largest_first"},
        Bad{"sorter.largest_by=area", "expected one of triangles, pixels, work"},
        Bad{"sorter.time_per_pair=3", "sorter.time_per_pair: a number without a unit '3'"},
        Bad{"sorter.time_per_triangle=-3ns", "sorter.time_per_triangle: "},
        Bad{"rasterizer.kind=firmware", "expected one of hardware, software"},
        Bad{"rasterizer.fifo=-1",
            "out of range '-1'; expected unlimited or a whole number from 0 to 1000000000"},
        Bad{"rasterizer.fifo=1000000001", "out of range '1000000001'; expected unlimited or"},
        Bad{"rasterizer.fifo=endless", "not a whole number 'endless'; expected unlimited or"},
        Bad{"rasterizer.cycles_per_triangle=-1",
            "out of range '-1'; expected a whole number from 0 to 1000000"},
        Bad{"rasterizer.cycles_per_pixel=1000001", "out of range '1000001'"},
        Bad{"rasterizer.input_fifo=0", "out of range '0'; expected a whole number from 1 to 65535"},
        Bad{"rasterizer.fifos=2",
            "unknown key; expected one of kind, cycles_per_triangle, cycles_per_pixel, fifo, "
            "input_fifo; did you mean 'fifo'?"}));

}  // namespace
}  // namespace rasterloom::config
