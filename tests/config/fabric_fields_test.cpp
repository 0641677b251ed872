// SPDX-License-Identifier: MIT
// The keys of machines that deal out the screen.
#include "machine/config/export.hpp"
#include "tests/config/machine_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::config {
namespace {

using testing::HasSubstr;

TEST(FabricKeys, HaveTheDefaultsOfAMachineThatCouldBeBuilt) {
    const MachineDescription machine = load_text(kSmallMachine);
    EXPECT_FALSE(machine.fabric.ideal);
    EXPECT_EQ(machine.fabric.splitter.time_per_vertex, Duration::nanoseconds(600));
    EXPECT_EQ(machine.fabric.bus.time_per_word, Duration::nanoseconds(300));
    EXPECT_EQ(machine.fabric.splitter.input_fifo, 4);
    EXPECT_EQ(machine.fabric.processor_fifo, 4);
    EXPECT_EQ(machine.fabric.frame_buffer, FrameBufferKind::local);
    EXPECT_EQ(machine.host.time_per_polygon, Duration::microseconds(10));
    EXPECT_EQ(machine.host.order, host::PolygonOrder::mesh);
}

TEST(FabricKeys, AreReadAndExported) {
    const MachineDescription machine = load_text(
        kSmallMachine,
        {"fabric={ideal: true, splitter: {time_per_vertex: 1us, input_fifo: 2, output_fifo: 3}, "
         "polygon_bus: {time_per_word: 100ns, input_fifo: 9}, processor_fifo: 5, frame_buffer: "
         "bus, "
         "frame_buffer_bus: {time_per_pixel: 150ns}, latency: 2us, half_digested: true, "
         "digest_fifo: 6}",
         "host={time_per_polygon: 0ns, time_per_vertex: 1us, order: shuffled, seed: 7}",
         "nodes.symbols={full: 0, limit: -3}",
         "scene={object: random_polygons, polygons: 12, seed: 3, background: 9}"});
    EXPECT_TRUE(machine.fabric.ideal);
    EXPECT_EQ(machine.fabric.splitter.output_fifo, 3);
    EXPECT_EQ(machine.fabric.bus.input_fifo, 9);
    EXPECT_EQ(machine.fabric.frame_buffer, FrameBufferKind::bus);
    EXPECT_EQ(machine.fabric.frame_buffer_time_per_pixel, Duration::nanoseconds(150));
    EXPECT_TRUE(machine.fabric.half_digested);
    EXPECT_EQ(machine.fabric.digest_fifo, 6);
    EXPECT_EQ(machine.host.order, host::PolygonOrder::shuffled);
    EXPECT_EQ(machine.host.seed, 7);
    EXPECT_EQ(machine.nodes.symbols.at("limit"), -3);
    EXPECT_EQ(machine.scene->polygons, 12);
    EXPECT_EQ(machine.scene->background, 9);
    const std::string text = export_machine(machine);
    EXPECT_EQ(export_machine(read_machine(text, "exported.yaml", {}, source_tree())), text);
    EXPECT_THAT(text, HasSubstr("symbols: { full: 0, limit: -3 }"));
}

struct Bad {
    const char* change;
    const char* complaint;
};

void PrintTo(const Bad& bad, std::ostream* stream) {
    *stream << bad.change;
}

class BadFabricKey : public testing::TestWithParam<Bad> {};

TEST_P(BadFabricKey, IsRefusedWithWhatWasExpected) {
    EXPECT_THAT(refusal(kSmallMachine, {GetParam().change}), HasSubstr(GetParam().complaint));
}

INSTANTIATE_TEST_SUITE_P(
    Keys, BadFabricKey,
    testing::Values(
        Bad{"fabric.idael=true", "fabric.idael: unknown key"},
        Bad{"fabric.ideal=maybe",
            "fabric.ideal: no such choice 'maybe'; expected one of true, false"},
        Bad{"fabric.splitter.time_per_vertex=2", "a number without a unit '2'"},
        Bad{"fabric.splitter.input_fifo=0", "out of range '0'"},
        Bad{"fabric.splitter.output_fifo=-1", "out of range '-1'"},
        Bad{"fabric.polygon_bus=3us", "a value where a mapping belongs"},
        Bad{"fabric.polygon_bus.time_per_word=-3us", "polygon_bus.time_per_word"},
        Bad{"fabric.polygon_bus.input_fifo=0", "out of range '0'"},
        Bad{"fabric.processor_fifo=65536", "out of range '65536'"},
        Bad{"fabric.frame_buffer=shared", "no such choice 'shared'; expected one of local, bus"},
        Bad{"fabric.frame_buffer_bus.time_per_pixel=x", "frame_buffer_bus.time_per_pixel"},
        Bad{"fabric.latency=1ps", "fabric.latency: too short '1ps'; expected at least 2ps"},
        Bad{"fabric.half_digested=2", "no such choice '2'"},
        Bad{"fabric.digest_fifo=0", "out of range '0'"},
        Bad{"host.time_per_polygon=10", "a number without a unit"},
        Bad{"host.time_per_vertex=fast", "host.time_per_vertex"},
        Bad{"host.order=sortd", "did you mean 'sorted'?"}, Bad{"host.seed=-1", "out of range '-1'"},
        Bad{"nodes.symbols=full", "a value where a mapping belongs"},
        Bad{"nodes.symbols={full: yes}", "not a whole number"},
        Bad{"nodes.symbols={full: 65536}", "out of range: full"},
        Bad{"nodes.symbols={1$: 1}", "not the name of a symbol: 1$"},
        Bad{"scene={polygons: 0}", "scene.polygons: out of range '0'"},
        Bad{"scene={seed: -1}", "scene.seed: out of range"},
        Bad{"scene={model: nowhere.obj}", "scene.model: no such file (looked in "},
        Bad{"scene={background: 256}", "scene.background: out of range '256'"}));

}  // namespace
}  // namespace rasterloom::config
