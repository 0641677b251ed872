// SPDX-License-Identifier: MIT
#include "machine/config/sweep.hpp"

#include "tests/config/machine_text.hpp"

#include <fstream>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::config {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

SweepDescription read(const std::string& text) {
    return read_sweep(text, "sweep.yaml", source_tree());
}

std::string complaint(const std::string& text) {
    try {
        read(text);
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "accepted";
}

std::vector<std::string> keys(const SweepDescription& sweep) {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < sweep.size(); ++i) {
        all.push_back(sweep.point(i).key);
    }
    return all;
}

TEST(Sweep, IsTheProductOfItsLists) {
    const SweepDescription sweep = read(
        "configs: [ring.yaml, edge-list.yaml]\n"
        "vary: { links.latency: [1us, 2us], links.input_queue: 3 }\n"
        "out: here\n");
    EXPECT_THAT(keys(sweep),
                ElementsAre("config=ring.yaml links.input_queue=3 links.latency=1us",
                            "config=ring.yaml links.input_queue=3 links.latency=2us",
                            "config=edge-list.yaml links.input_queue=3 links.latency=1us",
                            "config=edge-list.yaml links.input_queue=3 links.latency=2us"));
    EXPECT_EQ(sweep.out, "here");
    EXPECT_THAT(sweep.point(3).values, ElementsAre("3", "2us"));
}

TEST(Sweep, GivesAPointTheSameKeyInWhateverOrderListsStand) {
    const auto all = [](const std::string& text) {
        const std::vector<std::string> list = keys(read(text));
        return std::set<std::string>(list.begin(), list.end());
    };
    EXPECT_EQ(all("configs: [a.yaml, b.yaml]\n"
                  "scenes: [scenes/cube.yaml, scenes/teapot.yaml]\n"
                  "vary: { links.latency: [1us, 2us], run.max_time: [1s, 2s] }\n"),
              all("vary: { run.max_time: [2s, 1s], links.latency: [1us, 2us] }\n"
                  "scenes: [scenes/teapot.yaml, scenes/cube.yaml]\n"
                  "configs: [b.yaml, a.yaml]\n"));
}

TEST(Sweep, TellsPointsApartWhoseTextsLookAlike) {
    const std::vector<std::string> list = keys(read(
        "configs: ['a.yaml links.latency=1us', a.yaml]\n"
        "vary: { scene.light: [[1, 0, 0], [1, 0, 0.0]], machine: ['x', 'x y', '\"x y\"'] }\n"));
    EXPECT_EQ(std::set<std::string>(list.begin(), list.end()).size(), 12U);
}

TEST(Sweep, LoadsItsPointsAsOverridesDo) {
    const SweepDescription sweep = read(
        "configs: geodesic482.yaml\n"
        "scenes: [scenes/cube.yaml]\n"
        "frames: 3\n"
        "vary: { screen: [{ width: 32, height: 16 }], screen.height: [64], topology.b: [2],\n"
        "        scene.light: [[1, 0, -1]], nodes.cost.move: [7] }\n");
    const MachineDescription machine = load_point(sweep.point(0), source_tree());
    EXPECT_EQ(machine.screen.width, 32);
    EXPECT_EQ(machine.screen.height, 64);
    EXPECT_EQ(machine.topology.parameters.at("b"), "2");
    EXPECT_EQ(machine.nodes.cost.overrides.at("move"), 7);
    EXPECT_EQ(machine.scene.value().object, "cube");
    EXPECT_EQ(machine.scene.value().light, glm::dvec3(1, 0, -1));
    EXPECT_EQ(machine.run.frames, 3);
    EXPECT_EQ(machine.run.threads, 1) << "points run side by side";
}

TEST(Sweep, SaysWhereAKeyOrValueIsWrong) {
    EXPECT_THAT(complaint("configs: [ring.yaml]\nvary:\n  links.latancy: [1us]\n"),
                StartsWith("sweep.yaml:3:3: links.latancy: unknown key; expected one of "));
    EXPECT_THAT(complaint("configs: [ring.yaml]\nvary:\n  links.latancy: [1us]\n"),
                HasSubstr("did you mean 'latency'?"));
    EXPECT_EQ(
        complaint("configs: [ring.yaml]\nvary:\n  links.latency: [1us, 3]\n"),
        "sweep.yaml:3:24: links.latency: a number without a unit '3'; expected a duration such "
        "as 300ns or 5us");
    EXPECT_THAT(complaint("configs: [ring.yaml]\nvary: { machine.name: [x] }\n"),
                StartsWith("sweep.yaml:2:9: machine.name: 'name' is not inside a mapping"));
    EXPECT_THAT(complaint("configs: [ring.yaml]\nvary: { links..latency: [1us] }\n"),
                StartsWith("sweep.yaml:2:9: an empty name in the key"));
    EXPECT_THAT(complaint("configs: [ring.yaml]\nscenes: [scenes/cub.yaml]\n"),
                StartsWith("sweep.yaml:2:10: scene: no such file"));
    EXPECT_THAT(complaint("config: [ring.yaml]\n"), HasSubstr("did you mean 'configs'?"));
}

TEST(Sweep, IsRefusedWithoutPoints) {
    EXPECT_EQ(
        complaint("vary: { links.latency: [1us] }\n"),
        "sweep.yaml:1:1: configs: missing: the sweep has no points; expected configs: [FILE, ...]");
    EXPECT_THAT(complaint("configs: []\n"),
                StartsWith("sweep.yaml:1:10: configs: an empty list: the sweep has no points"));
    EXPECT_THAT(complaint("configs: [ring.yaml]\nvary: { links.latency: [] }\n"),
                StartsWith("sweep.yaml:2:24: links.latency: an empty list"));
    EXPECT_THAT(complaint("configs: [ring.yaml]\nscenes: []\n"),
                StartsWith("sweep.yaml:2:9: scenes: an empty list"));
}

TEST(Sweep, RefusesWhatItCannotTellApart) {
    EXPECT_THAT(complaint("configs: [ring.yaml, ring.yaml]\n"),
                StartsWith("sweep.yaml:1:22: configs: written twice 'ring.yaml'"));
    EXPECT_THAT(complaint("configs: [ring.yaml]\nvary: { links.latency: [1us, 2us, 1us] }\n"),
                StartsWith("sweep.yaml:2:35: links.latency: written twice '1us'"));
}

TEST(Sweep, HasOneWayToSayAThing) {
    for (const char* key : {"scene: [scenes/cube.yaml]", "run.frames: [1]", "run.threads: [1]"}) {
        EXPECT_THAT(complaint(std::string("configs: [ring.yaml]\nvary: { ") + key + " }\n"),
                    HasSubstr("cannot be varied"))
            << key;
    }
}

TEST(Sweep, RefusesMorePointsThanAnybodyCanMean) {
    std::string text = "configs: [ring.yaml]\nvary:\n";
    for (const char* key : {"scene.seed", "host.seed", "links.input_queue", "links.output_queue"}) {
        text += std::string("  ") + key + ": [1";
        for (int i = 2; i <= 100; ++i) {
            text += ", " + std::to_string(i);
        }
        text += "]\n";
    }
    EXPECT_THAT(complaint(text), HasSubstr("too many points"));
}

TEST(Sweep, LeavesAMissingConfigurationToThePoint) {
    const SweepDescription sweep = read("configs:\n  - nowhere.yaml\n");
    try {
        load_point(sweep.point(0), source_tree());
        FAIL() << "it was found";
    } catch (const ConfigError& error) {
        EXPECT_THAT(error.what(), StartsWith("sweep.yaml:2:5: configs: no such file"));
    }
}

}  // namespace
}  // namespace rasterloom::config
