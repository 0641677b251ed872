// SPDX-License-Identifier: MIT
#include "machine/config/load.hpp"

#include "tests/config/machine_text.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::config {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string with(const std::string& lines) {
    return kSmallMachine + lines;
}

TEST(Load, FillsInWhatTheFileDoesNotSay) {
    const MachineDescription machine = load_text(kSmallMachine);
    EXPECT_EQ(machine.machine, "small");
    EXPECT_EQ(machine.topology.kind, "ring");
    EXPECT_EQ(machine.topology.parameters.at("nodes"), "4");
    EXPECT_EQ(machine.nodes.program.text, "pdp11/token.s");
    EXPECT_EQ(machine.links.latency, Duration::microseconds(1));
    EXPECT_EQ(machine.links.input_queue, 4);
    EXPECT_FALSE(machine.scene.has_value());
}

TEST(Load, NamesTheNearestKeyForOneItDoesNotKnow) {
    EXPECT_THAT(refusal(with("  time_per_byt: 2us\n")),
                AllOf(StartsWith("small.yaml:7:3: links.time_per_byt: unknown key"),
                      HasSubstr("time_per_message"), HasSubstr("did you mean 'time_per_byte'?")));
    EXPECT_THAT(refusal(with("linkx: {}\n")),
                AllOf(StartsWith("small.yaml:7:1: linkx: unknown key"),
                      HasSubstr("did you mean 'links'?")));
}

TEST(Load, SaysWhatItExpectedOfAWrongUnit) {
    EXPECT_EQ(
        refusal(with("  time_per_byte: 2 parsecs\n")),
        "small.yaml:7:18: links.time_per_byte: wrong unit '2 parsecs'; expected a duration such as "
        "300ns or 5us");
    EXPECT_THAT(refusal(with("  time_per_byte: 2\n")), HasSubstr("a number without a unit '2'"));
}

TEST(Load, RefusesWrongTypes) {
    EXPECT_THAT(refusal(with("  input_queue: many\n")),
                AllOf(StartsWith("small.yaml:7:16: links.input_queue: not a whole number 'many'"),
                      HasSubstr("expected a whole number from 1 to 65535")));
    EXPECT_THAT(refusal(with("  input_queue: [1]\n")), HasSubstr("a list where a value belongs"));
    EXPECT_THAT(refusal(with("  input_queue: { n: 1 }\n")),
                HasSubstr("a mapping where a value belongs"));
    EXPECT_THAT(refusal(with("  input_queue:\n")), HasSubstr("nothing where a value belongs"));
    EXPECT_THAT(refusal(with("screen: 256\n")),
                AllOf(StartsWith("small.yaml:7:9: screen: a value where a mapping belongs"),
                      HasSubstr("width, height")));
}

TEST(Load, RefusesValuesOutOfRange) {
    EXPECT_THAT(refusal(with("  input_queue: 0\n")), HasSubstr("out of range '0'"));
    EXPECT_THAT(refusal(with("screen: { width: 5000 }\n")),
                HasSubstr("out of range '5000'; expected a whole number from 1 to 4096"));
    EXPECT_THAT(refusal(with("scene: { ambient: 1.5 }\n")), HasSubstr("out of range '1.5'"));
    EXPECT_THAT(refusal(with("scene: { light: [0, 0, 0] }\n")), HasSubstr("no direction"));
    EXPECT_THAT(refusal(with("scene: { ambient: nan }\n")), HasSubstr("not a number 'nan'"));
    EXPECT_THAT(refusal(kSmallMachine, {"links.latency=0ns"}),
                HasSubstr("links.latency: too short '0ps'; expected at least 2ps"));
}

TEST(Load, RefusesChoicesThatDoNotExist) {
    EXPECT_THAT(refusal(with("  send: one_at_time\n")),
                AllOf(HasSubstr("no such choice 'one_at_time'"),
                      HasSubstr("did you mean 'one_at_a_time'?")));
}

TEST(Load, SaysWhereItLookedForAFileThatIsMissing) {
    EXPECT_THAT(refusal(kSmallMachine, {"nodes.program=nowhere.s"}),
                AllOf(StartsWith("--set nodes.program: nodes.program: no such file (looked in "),
                      HasSubstr("programs"), HasSubstr("'nowhere.s'")));
    EXPECT_THAT(refusal(with("scene: scenes/nothing.yaml\n")),
                AllOf(StartsWith("small.yaml:7:8: scene: no such file (looked in "),
                      HasSubstr("'scenes/nothing.yaml'")));
    EXPECT_THAT(refusal(with("scene: { object: missing.obj }\n")),
                HasSubstr("no such file (looked in"));
}

TEST(Load, SaysWhichKeyIsMissing) {
    EXPECT_THAT(refusal("machine: x\n"),
                AllOf(StartsWith("small.yaml:1:1: topology: missing"), HasSubstr("geodesic")));
    EXPECT_THAT(refusal("topology: { kind: single }\n"), HasSubstr("nodes.program: missing"));
    EXPECT_THAT(refusal("topology: { b: 1 }\n"), HasSubstr("no kind"));
}

TEST(Load, PointsAtBrokenYaml) {
    EXPECT_THAT(refusal("machine: [1, 2\nlinks: 3\n"),
                AllOf(StartsWith("small.yaml:"), HasSubstr("not valid YAML")));
    EXPECT_THAT(refusal(""), HasSubstr("the file is empty"));
    EXPECT_THAT(refusal("just words"), HasSubstr("a value where a mapping belongs"));
    EXPECT_THAT(refusal(kSmallMachine + "machine: again\n"),
                HasSubstr("small.yaml:7:1: machine: written twice"));
    EXPECT_THAT(refusal("machine: &a x\nnodes: *a\n"), HasSubstr("anchors and aliases"));
    EXPECT_THAT(refusal("machine: a\n---\nmachine: b\n"), HasSubstr("a second document"));
    EXPECT_THAT(refusal(std::string(200, '[')), HasSubstr("nested too deeply"));
}

TEST(Load, ShowsControlCharactersAsEscapesOnOneLine) {
    const std::string message = refusal(with("  send: \"a\\nb\"\n"));
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_THAT(message, HasSubstr("'a\\x0ab'"));
}

TEST(Load, ReportsAFileThatIsNotThere) {
    try {
        load_machine("no-such-machine.yaml", {}, source_tree());
        FAIL();
    } catch (const ConfigError& error) {
        EXPECT_THAT(error.what(), HasSubstr("no-such-machine.yaml: cannot be read"));
    }
}

TEST(Load, RemembersWhereEachValueWasWritten) {
    const MachineDescription machine = load_text(kSmallMachine, {"nodes.cost.model=parks"});
    EXPECT_EQ(machine.written.at("links.latency"), (Position{"small.yaml", 6, 12}));
    EXPECT_EQ(machine.written.at("topology.nodes"), (Position{"small.yaml", 2, 32}));
    EXPECT_EQ(machine.written.at("nodes.cost.model").to_string(), "--set nodes.cost.model");
    EXPECT_FALSE(machine.written.contains("links.time_per_byte"));
}

}  // namespace
}  // namespace rasterloom::config
