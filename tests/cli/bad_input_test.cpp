// SPDX-License-Identifier: MIT
// Every kind of bad input ends with one clear message, its exit status, and no output.
#include "tests/cli/command_line.hpp"

#include <fstream>
#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::cli {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

struct BadInput {
    const char* name;
    std::vector<std::string> arguments;
    int status;
    std::vector<std::string> said;
};

void PrintTo(const BadInput& input, std::ostream* out) {
    *out << input.name;
}

const std::string kRing = "ring.yaml";

std::vector<std::string> run_ring(const std::string& program_name,
                                  std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{"run", kRing, "--set",
                                       "nodes.program=" + program(program_name)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

const std::vector<BadInput> kBadInputs{
    {"Usage", {}, 2, {"a subcommand is missing", "one of run, describe"}},
    {"Subcommand", {"rnu"}, 2, {"no such subcommand 'rnu'", "did you mean 'run'?"}},
    {"Option", {"run", kRing, "--fast"}, 2, {"rasterloom: command line:", "--fast"}},
    {"Data", {"--data", "nowhere", "list", "scenes"}, 2, {"--data", "nowhere"}},
    {"NoKind", {"list"}, 2, {"a subcommand is missing", "isas, topologies"}},
    {"NoBoxes", {"communicate", "nowhere.boxes"}, 2, {"rasterloom: nowhere.boxes: no such file"}},
    {"NoScene",
     {"boxes", "--out", "x.boxes"},
     2,
     {"Exactly 1 option from [--mesh,--object,--random,--machine]"}},
    {"TwoScenes",
     {"boxes", "--out", "x.boxes", "--random", "9", "--object", "cube"},
     2,
     {"command line", "2 were given"}},
    {"UnknownObjectForBoxes",
     {"boxes", "--out", "x.boxes", "--object", "cup"},
     2,
     {"no scene object 'cup'", "teapot"}},
    {"TooManyRandomBoxes",
     {"boxes", "--out", "x.boxes", "--random", "16777217"},
     2,
     {"--random", "16777217"}},
    {"MissingConfiguration", {"run", "nowhere.yaml"}, 2, {"nowhere.yaml", "cannot be read"}},
    {"Key",
     {"run", kRing, "--set", "links.time_per_byt=1us"},
     2,
     {"unknown key", "did you mean 'time_per_byte'?"}},
    {"Type",
     {"run", kRing, "--set", "links.input_queue=many"},
     2,
     {"--set links.input_queue", "not a whole number 'many'"}},
    {"Unit",
     {"run", kRing, "--set", "links.latency=3"},
     2,
     {"a number without a unit '3'", "300ns"}},
    {"Value", {"run", kRing, "--set", "links.input_queue=0"}, 2, {"out of range '0'", "from 1 to"}},
    {"ProgramFile", {"run", kRing, "--set", "nodes.program=x.s"}, 2, {"no such file", "'x.s'"}},
    {"Topology",
     {"run", kRing, "--set", "topology.kind=rink"},
     2,
     {"no topology 'rink'", "did you mean 'ring'?"}},
    {"TopologyParameter", {"run", kRing, "--set", "topology.nodes=1"}, 2, {"topology"}},
    {"InstructionSet", {"run", kRing, "--set", "nodes.isa=pdp12"}, 2, {"'pdp12'", "pdp11"}},
    {"CostParameter",
     {"run", kRing, "--set", "nodes.cost.multply=3"},
     2,
     {"'multply'", "did you mean 'multiply'?"}},
    {"Memory", {"run", kRing, "--set", "nodes.memory=300B"}, 2, {"does not fit", "at least"}},
    {"TooMuchMemory",
     {"run", kRing, "--set", "nodes.memory=64KiB"},
     2,
     {"too large '65536'", "57344"}},
    {"SceneOnARing",
     {"run", kRing, "--set", "scene.object=cube"},
     2,
     {"topology.kind", "geodesic"}},
    {"ScreenThatCannotBeDealtOut",
     {"describe", "splitter4.yaml", "--set", "topology.columns=3"},
     2,
     {"--set topology.columns: ", "3 columns of processors", "512 pixels evenly", "256, 512 can"}},
    {"KeyWithoutEffect",
     {"run", "splitter4.yaml", "--set", "links.latency=3us"},
     2,
     {"--set links.latency: ", "has no effect here '3us'", "the default"}},
    {"SymbolThatNobodyAsksFor",
     {"run", "interlace4.yaml", "--set", "nodes.symbols.skip_delta=1"},
     2,
     {"nodes.symbols.skip_delta", "does not ask for this symbol"}},
    {"SymbolOfARawProgram",
     {"run", "bare-pdp11.yaml", "--set", "nodes.symbols.x=1", "--set",
      "nodes.program=" RASTERLOOM_SOURCE_DIR "/tests/cli/programs/flat.obj"},
     2,
     {"nodes.symbols", "is not assembled"}},
    {"PolygonSceneOnASphere",
     {"run", "geodesic482.yaml", "--set", "scene.object=random_polygons"},
     2,
     {"scene.object", "is made of screen polygons 'random_polygons'"}},
    {"ModelOfASceneWithoutOne",
     {"run", "uniprocessor.yaml", "--set", "scene=scenes/random.yaml", "--set",
      "scene.model=" RASTERLOOM_SOURCE_DIR "/tests/cli/programs/flat.obj"},
     2,
     {"--set scene.model: ", "has no effect here"}},
    {"PolygonOffTheScreen",
     {"run", "uniprocessor.yaml", "--set", "screen={width: 16, height: 16}", "--set",
      "scene={object: " RASTERLOOM_SOURCE_DIR "/tests/cli/programs/wide.polygons}"},
     2,
     {"scene.object", "wide.polygons:4"}},
    {"HalfDigestedAlone",
     {"run", "splitter4.yaml", "--set", "fabric.half_digested=true"},
     2,
     {"--set fabric.half_digested: ", "nobody shares the set-up", "interlace or hybrid"}},
    {"TooLittleTimeForAPicture",
     {"run", "splitter4.yaml", "--set", "scene=scenes/random.yaml", "--max-time", "1ms"},
     3,
     {"has not finished after 1ms", "node/P0 runs at", "tiler",
      "host waits for a place for polygon", "splitter/0 waits for", "supervisor waits for"}},
    {"NoMeshAtAll",
     {"run", "uniprocessor.yaml", "--set", "scene={}", "--mesh", program("short.s")},
     2,
     {"--mesh: scene.object: ", "short.s"}},
    {"MeshWithoutPolygons",
     {"run", "splitter4.yaml", "--set", "scene={}", "--mesh", program("no_faces.obj")},
     2,
     {"--mesh: scene.object: ", "no_faces.obj"}},
    {"MeshWithNaN",
     {"run", "splitter4.yaml", "--set", "scene={}", "--mesh", program("not_a_number.obj")},
     2,
     {"--mesh: scene.object: ", "vertex 1 stands at (nan, 0, 1), expected finite coordinates"}},
    {"ModelWithNaN",
     {"run", "splitter4.yaml", "--set", "scene.object=airport", "--mesh",
      program("not_a_number.obj")},
     2,
     {"--mesh: scene.model: ", "vertex 1 stands at (nan, 0, 1)"}},
    {"FileWithoutPolygons",
     {"run", "splitter4.yaml", "--set", "scene={}", "--mesh", program("none.polygons")},
     2,
     {"--mesh: scene.object: ", "none.polygons: no polygons, expected"}},
    {"TooManyColumnsForAFrameBuffer",
     {"run", "uniprocessor.yaml", "--set", "screen={width: 2048, height: 16}", "--set",
      "scene=scenes/random.yaml"},
     2,
     {"1024"}},
    {"FlatMesh",
     {"run", "geodesic482.yaml", "--mesh", RASTERLOOM_SOURCE_DIR "/tests/cli/programs/flat.obj"},
     2,
     {"--mesh: scene.object: ", "flat.obj: the surface is flat"}},
    {"ProgramThatDrawsNothing",
     {"run", "geodesic482.yaml", "--set", "nodes.program=pdp11/token.s"},
     2,
     {"--set nodes.program: nodes.program: ", "no symbol", "such as pdp11/strothotte.s"}},
    {"AppendixCWithoutTiler",
     {"run", kRing, "--appendix-c"},
     2,
     {"--appendix-c", "needs the label tap_idle", "a machine that draws polygons"}},
    {"AppendixCOfNobody",
     {"run", kRing, "--appendix-c=P99"},
     2,
     {"--appendix-c", "P99", "no such processor"}},
    {"ComparisonWithoutScene", {"run", kRing, "--compare"}, 2, {"--compare", "without a scene"}},
    {"CheckOfCommunicationWithoutLanes",
     {"run", "geodesic482.yaml", "--check-communication"},
     2,
     {"--check-communication: no polygons go from lane to lane", "nodes.isa vliw"}},
    {"CheckOfCommunicationWithoutScene",
     {"run", kRing, "--check-communication"},
     2,
     {"--check-communication: no polygons go from lane to lane", "with a scene"}},
    {"MissingMesh",
     {"run", "geodesic482.yaml", "--mesh", "none.obj"},
     2,
     {"--mesh", "no such file", "none.obj"}},
    {"UnknownObject",
     {"run", "geodesic482.yaml", "--set", "scene.object=teapod"},
     2,
     {"no such object or scene 'teapod'", "random_polygons", "did you mean 'teapot'?"}},
    {"BrokenMesh",
     {"run", "geodesic482.yaml", "--mesh", program("short.s")},
     2,
     {"--mesh", "short.s"}},
    {"FramesWithoutScene",
     {"run", kRing, "--frames", "2"},
     2,
     {"more than one frame without a scene"}},
    {"Source", run_ring("wrong.s"), 2, {"wrong.s:2:", "wrong.s:3:9: 'bogus' is no instruction"}},
    {"EndlessLoop",
     run_ring("endless.s", {"--max-time", "1ms"}),
     3,
     {"has not finished after 1ms", "--max-time", "node/R0 runs at 00100",
      "endless.s:", "supervisor waits for the end of phase 0"}},
    {"EndlessBareLoop",
     {"run", "bare-pdp11.yaml", "--max-time", "1ms", "--set",
      "nodes.program=" + program("endless.s")},
     3,
     {"has not finished after 1ms"}},
    {"RunsOffItsMemory",
     run_ring("runaway.s"),
     3,
     {"guest error", "node/R0", "cycle 5", "ran off its memory", "pc=160000"}},
    {"PortThatIsNotThere",
     run_ring("no_port.s"),
     3,
     {"port 15, which has no link", "at 001010", "no_port.s:5", "r3=001000"}},
    {"OddAddress", run_ring("odd_address.s"), 3, {"odd address 001001", "odd_address.s:4"}},
    {"Fault", run_ring("fault.s"), 3, {"FAULT 000042", "fault.s:3"}},
    {"Count",
     run_ring("overdraw.s"),
     3,
     {"guest error", "(node 0), cycle 2: CREDIT -17 takes away more", "at 001004, ",
      "overdraw.s:4"}},
    {"GraphFile",
     {"describe", "edge-list.yaml", "--set", "topology.file=no.txt"},
     2,
     {"topology.file: no such file", "'no.txt'"}},
    {"Entry",
     {"run", kRing, "--set", "nodes.entry=0o1001"},
     2,
     {"--set nodes.entry: nodes.entry: ", "the entry 001001"}},
    {"Deadlock",
     run_ring("deadlock.s"),
     3,
     {"deadlock", "node/R15 waits for WAITFOR", "supervisor waits for", "16 of work outstanding"}},
    {"LongDeadlock",
     run_ring("deadlock.s", {"--set", "topology.nodes=100"}),
     3,
     {"101 components wait", "  and 78 more\n"}},
    {"AssembledFile", {"assemble", "nowhere.s"}, 2, {"nowhere.s"}},
    {"AssemblyErrors",
     {"assemble", program("wrong.s"), "-o", "x.bin"},
     2,
     {"undefined symbol 'r9'", "'bogus'"}},
    {"CrowdedBundles",
     {"assemble", program("crowded.s"), "--isa", "vliw"},
     2,
     {"crowded.s:2:34: sub: the bundle's ALU slot is in use already",
      "crowded.s:3:50: st: the bundle reads 5 registers; the register file has 4 read ports"}},
    {"PackingWithoutBundles",
     {"assemble", program("short.s"), "--pack"},
     2,
     {"--pack", "pdp11", "its instructions cannot be packed"}},
    {"Listing",
     {"assemble", program("short.s"), "--listing", "--cost", "parsk"},
     2,
     {"--cost", "parsk"}},
    {"NodeName",
     {"describe", "geodesic482.yaml", "--node", "P31-124"},
     2,
     {"no such node 'P31-124'", "did you mean"}},
    {"VariedKey",
     {"whatif", "geodesic482.yaml", "--vary", "links.time_per_bite=x2"},
     2,
     {"--vary", "unknown key 'links.time_per_bite'", "did you mean 'links.time_per_byte'?"}},
    {"VariedValue",
     {"whatif", "geodesic482.yaml", "--vary", "links.latency=5parsec"},
     2,
     {"--vary links.latency=5parsec", "wrong unit", "a duration such as 300ns"}},
    {"VariedWithoutScene",
     {"whatif", "bare-pdp11.yaml", "--vary", "nodes.clock=x2"},
     2,
     {"no frames"}},
    {"KindOfTrace",
     {"run", "geodesic482.yaml", "--trace", "out.json"},
     2,
     {"--trace", "'out.json'", "a name that ends in .perfetto-trace"}},
    {"PlaceOfTrace",
     {"run", "splitter4.yaml", "--no-files", "--trace", "no/such/folder/t.perfetto-trace"},
     2,
     {"no/such/folder/t.perfetto-trace: cannot be written"}},
    {"BottlenecksOfABareProcessor",
     {"run", "bare-pdp11.yaml", "--bottlenecks"},
     2,
     {"--bottlenecks", "no frames"}},
    {"ReportWithoutFiles",
     {"run", "ring.yaml", "--report", "--no-files"},
     2,
     {"--report", "the report is a file", "a run without --no-files"}},
    {"Kind", {"list", "scene"}, 2, {"no such subcommand 'scene'", "did you mean 'scenes'?"}},
};

class BadInputs : public CommandLine, public testing::WithParamInterface<BadInput> {};

TEST_P(BadInputs, EndWithOneMessageTheirStatusAndNoOutput) {
    const Finished finished = rasterloom(GetParam().arguments);
    EXPECT_EQ(finished.status, GetParam().status) << finished.err;
    for (const std::string& part : GetParam().said) {
        EXPECT_THAT(finished.err, HasSubstr(part));
    }
    EXPECT_THAT(finished.out, IsEmpty());
    EXPECT_THAT(files(), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Cases, BadInputs, testing::ValuesIn(kBadInputs),
                         [](const auto& info) { return info.param.name; });

class FailedRun : public CommandLine {};

TEST_F(FailedRun, KeepsWhatAnEarlierOneWrote) {
    ASSERT_EQ(rasterloom({"run", kRing, "--out", "here"}).status, 0);
    const auto before = files();
    const std::string statistics = read_text(folder_ / "work/here/statistics.json");
    EXPECT_EQ(
        rasterloom({"run", kRing, "--out", "here", "--set", "nodes.program=" + program("fault.s")})
            .status,
        3);
    EXPECT_EQ(files(), before);
    EXPECT_EQ(read_text(folder_ / "work/here/statistics.json"), statistics);
}

TEST_F(FailedRun, DoesNotTakeAFileForAFolder) {
    std::ofstream(folder_ / "work/out.txt") << "mine";
    const Finished finished = rasterloom({"run", kRing, "--out", "out.txt"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("is a file; expected a folder"));
    EXPECT_EQ(read_text(folder_ / "work/out.txt"), "mine");
}

}  // namespace
}  // namespace rasterloom::cli
