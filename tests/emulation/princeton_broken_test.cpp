// SPDX-License-Identifier: MIT
// Renderers whose communication is wrong fail by Eldridge's checks (1995, appendix A.3), wherever
// their pictures stay as they are.
#include "machine/emulation/run.hpp"
#include "tests/emulation/machines.hpp"
#include "tests/temporary_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::emulation {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

// A line of a file of programs/vliw, and what stands there instead.
struct Change {
    std::string program;
    std::string file;
    std::string line;
    std::string instead;
    std::string said;
};

void PrintTo(const Change& change, std::ostream* stream) {
    *stream << change.program << ": " << change.instead << " in " << change.file;
}

void change_file(const std::filesystem::path& path, const std::string& line,
                 const std::string& instead) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    std::string changed = text.str();
    const std::size_t at = changed.find(line);
    if (at == std::string::npos || changed.find(line, at + 1) != std::string::npos) {
        throw std::runtime_error(fmt::format("not once in {}: {}", path.string(), line));
    }
    changed.replace(at, line.size(), instead);
    std::ofstream(path) << changed;
}

config::MachineDescription with_program(const std::string& program, const std::string& file) {
    return shipped("princeton1024-" + program + ".yaml",
                   {"topology.nodes=128", "nodes.program=" + file,
                    "nodes.symbols={screen_columns: 96, screen_rows: 64, dense: 0}",
                    "screen={width: 96, height: 64}", "array.line_locked=false",
                    "scene={object: teapot, polygons: 800, rotate: {degrees: 25}}", "run.threads=1",
                    "run.frames=2"});
}

class BrokenCommunication : public testing::TestWithParam<Change> {};

TEST_P(BrokenCommunication, IsToldByFrameLaneAndPolygon) {
    const auto& [program, file, line, instead, said] = GetParam();
    const TemporaryFolder folder;
    std::filesystem::copy(RASTERLOOM_SOURCE_DIR "/programs/vliw", folder.path());
    std::string source = program;
    std::ranges::replace(source, '-', '_');
    const auto machine = with_program(program, (folder.path() / (source + ".s")).string());
    EXPECT_EQ(run_machine(machine, {}).failure, "");
    change_file(folder.path() / file, line, instead);
    EXPECT_THAT(run_machine(machine, {}).failure,
                AllOf(ContainsRegex("frame [01]: " + said), HasSubstr(" polygon "),
                      HasSubstr(" with the box (")));
    RunOptions unchecked;
    unchecked.check_communication = false;
    EXPECT_EQ(run_machine(machine, unchecked).failure, "");
}

INSTANTIATE_TEST_SUITE_P(
    All, BrokenCommunication,
    testing::Values(Change{"sort-middle", "pass.s",
                           "        .macro  wanted_near\n        tge     here, first\n",
                           "        .macro  wanted_near\n        tlt     first, here\n",
                           "communication: lane [0-9]+ lacks polygon "},
                    Change{"sort-middle", "pass.s",
                           "        .macro  wanted_near\n        tge     here, first\n",
                           "        .macro  wanted_near\n        tge     here, r0\n",
                           "communication: lane [0-9]+ has what it does not need: polygon "},
                    // Two turns round the ring.
                    Change{"sort-middle", "communicate.s",
                           "        mov     r16, room\n        .if ne dense\n        tge ",
                           "        add     r16, room, room\n        .if ne dense\n        tge ",
                           "communication: lane [0-9]+ has once too often polygon "},
                    Change{"sort-twice", "communicate_region.s", "        mov     r16, #group-1\n",
                           "        mov     r16, #group-2\n",
                           "communication: no lane of region [0-9]+ has "},
                    Change{"sort-first", "migrate.s",
                           "        sub     free, free, #1\n        sts     slot, 0, (free)\n",
                           "        sub     free, free, #1\n", "migration: "}));

}  // namespace
}  // namespace rasterloom::emulation
