// SPDX-License-Identifier: MIT
#include "machine/config/export.hpp"

#include "tests/config/machine_text.hpp"

#include <fstream>
#include <iterator>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::config {
namespace {

TEST(Export, LoadsAgainToTheSameMachine) {
    const auto machine = load_text(
        kSmallMachine, {"scene=scenes/cube.yaml", "scene.translate=[0.125, -1e-3, 0]",
                        "nodes.cost.model=parks", "nodes.cost.multiply=12", "nodes.clock=14MHz",
                        "nodes.entry=0o2000", "links.send=each_port",
                        "machine='a name: with # odd \"characters\"'", "nodes.phases_per_frame=3"});
    const std::string text = export_machine(machine);
    const auto again = read_machine(text, "exported.yaml", {}, source_tree());
    EXPECT_EQ(export_machine(again), text);
    EXPECT_EQ(again.machine, machine.machine);
    EXPECT_EQ(again.nodes.program.path, machine.nodes.program.path);
    EXPECT_EQ(again.nodes.clock, machine.nodes.clock);
    EXPECT_EQ(again.nodes.cost.overrides, machine.nodes.cost.overrides);
    EXPECT_EQ(again.scene->translate, machine.scene->translate);
    EXPECT_EQ(again.links.send, SendPolicy::each_port);
}

TEST(Export, WritesDefaultsToo) {
    EXPECT_THAT(export_machine(load_text(kSmallMachine)),
                testing::HasSubstr("  output_queue: 2\n"));
}

TEST(Documentation, HoldsTheTableOfAllKeys) {
    std::ifstream file(RASTERLOOM_SOURCE_DIR "/docs/configuration.md");
    const std::string page{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    EXPECT_NE(page.find(keys_as_markdown()), std::string::npos)
        << "docs/configuration.md should hold this table:\n"
        << keys_as_markdown();
}

}  // namespace
}  // namespace rasterloom::config
