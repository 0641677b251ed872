// SPDX-License-Identifier: MIT
#include "tests/config/machine_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::config {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Override, ReplacesAndAddsValues) {
    const MachineDescription machine = load_text(
        kSmallMachine,
        {"links.latency=3ns", "links.input_queue=9", "screen.width=64", "topology.nodes=7"});
    EXPECT_EQ(machine.links.latency, Duration::nanoseconds(3));
    EXPECT_EQ(machine.links.input_queue, 9);
    EXPECT_EQ(machine.screen.width, 64);
    EXPECT_EQ(machine.topology.parameters.at("nodes"), "7");
}

TEST(Override, LetsTheLastOneWin) {
    EXPECT_EQ(load_text(kSmallMachine, {"links.latency=3ns", "links.latency=4ns"}).links.latency,
              Duration::nanoseconds(4));
}

TEST(Override, TakesYamlValues) {
    const auto machine = load_text(kSmallMachine, {"scene.light=[1, 0, -1]", "scene.object=cube"});
    ASSERT_TRUE(machine.scene.has_value());
    EXPECT_EQ(machine.scene->light, glm::dvec3(1, 0, -1));
    EXPECT_EQ(machine.scene->object, "cube");
}

TEST(Override, ReachesIntoASceneFile) {
    const auto machine =
        load_text(kSmallMachine, {"scene=scenes/cube.yaml", "scene.rotate.degrees=6"});
    ASSERT_TRUE(machine.scene.has_value());
    EXPECT_EQ(machine.scene->object, "cube");
    EXPECT_EQ(machine.scene->rotate.degrees, 6);
}

TEST(Override, BearsItsNameInMessages) {
    EXPECT_EQ(refusal(kSmallMachine, {"links.time_per_byte=fast"}),
              "--set links.time_per_byte: links.time_per_byte: not a number with a unit 'fast'; "
              "expected a "
              "duration such as 300ns or 5us");
    EXPECT_THAT(refusal(kSmallMachine, {"links.tim_per_byte=1us"}),
                HasSubstr("did you mean 'time_per_byte'?"));
}

TEST(Override, IsRefusedWithoutKeyOrValue) {
    for (const char* text : {"links.latency", "=3", "links.latency=", "links..latency=3ns", ""}) {
        EXPECT_THAT(refusal(kSmallMachine, {text}), StartsWith("--set ")) << text;
    }
    EXPECT_THAT(refusal(kSmallMachine, {"machine.name=x"}),
                HasSubstr("'name' is not inside a mapping"));
    EXPECT_THAT(refusal(kSmallMachine, {"links.latency=[1"}), HasSubstr("not valid YAML"));
}

}  // namespace
}  // namespace rasterloom::config
