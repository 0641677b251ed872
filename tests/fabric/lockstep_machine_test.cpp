// SPDX-License-Identifier: MIT
// The time of a lock-step machine: scanlines, the host's integers, video, phases, what goes wrong.
#include "machine/fabric/lockstep_machine.hpp"

#include "machine/fabric/lockstep_error.hpp"
#include "machine/kernel/simulation.hpp"
#include "tests/isa/vliw_assembling.hpp"

#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom {
namespace {

using isa::vliw::testing::image_of;
using testing::ElementsAre;
using testing::HasSubstr;

// A machine of few lanes and lines, and what it has told.
class Machine : public SupervisorListener, public NodeListener, public PartListener {
  public:
    explicit Machine(const std::string& source, LockstepMachine::Settings settings = {}) {
        settings.image = std::make_shared<const isa::Image>(image_of(source));
        settings.program = std::make_shared<const isa::vliw::Program>(*settings.image);
        machine = &simulation.add<LockstepMachine>("sequencer", settings);
        simulation.seal();
        machine->probe().attach(*this);
        machine->lane_probe().attach(*this);
        machine->part_probe().attach(*this);
    }

    RunResult run(Time limit = Time::never()) {
        RunResult result = simulation.run(limit);
        while (result.end == RunEnd::paused) {
            ++pauses;
            result = simulation.run(limit);
        }
        return result;
    }
    std::string failure() {
        const RunResult result = run();
        EXPECT_EQ(result.end, RunEnd::failed);
        return result.failure != nullptr ? result.failure->message() : std::string();
    }

    void phase_ended(const PhaseRecord& phase) override { phases.push_back(phase); }
    void frame_ended(int frame, Time at) override { frames.emplace_back(frame, at); }
    void interval_ended(const StateInterval& interval) override { intervals.push_back(interval); }
    void part_interval_ended(const PartInterval& interval) override {
        EXPECT_EQ(interval.part, machine->id());
        sequencer.emplace_back(interval.state, interval.from, interval.to);
    }

    Simulation simulation;
    LockstepMachine* machine = nullptr;
    std::vector<PhaseRecord> phases;
    std::vector<std::pair<int, Time>> frames;
    std::vector<StateInterval> intervals;
    std::vector<std::tuple<PartState, Time, Time>> sequencer;
    int pauses = 0;
};

// 4 lanes; pictures of 5 scanlines of 10 cycles, 3 of them visible.
LockstepMachine::Settings small() {
    LockstepMachine::Settings settings;
    settings.line = 10;
    settings.lines = 5;
    settings.visible_lines = 3;
    settings.array.lanes = 4;
    return settings;
}

Time at(const Clock& clock, std::int64_t cycle) {
    return clock.edge(Cycles(cycle));
}

std::string nops(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += " nop\n";
    }
    return text;
}

constexpr std::uint32_t kCount = 5;  // word that the programs count in

TEST(LockstepMachine, BeginsAScanlineEvery910CyclesWithoutDrift) {
    LockstepMachine::Settings settings;
    settings.array.lanes = 2;
    Machine m("count = 5\n ld r1, count\n add r1, r1, #1\n st r1, count\n line\n", settings);
    const std::int64_t lines = 10'000;
    const Time end = at(settings.clock, 910 * lines);
    m.run(end);
    EXPECT_EQ(m.machine->statistics().scanlines, lines);
    EXPECT_EQ(m.machine->statistics().idle_cycles, lines * (910 - 4));
    m.run(end + Duration::tick());
    EXPECT_EQ(m.simulation.now(), end);
    EXPECT_EQ(m.machine->array().read(1, kCount), lines + 1);
    // 14 MHz: 9 100 000 cycles are 650 ms to the picosecond, though a cycle is no whole number.
    EXPECT_EQ(end, Time::zero() + Duration::milliseconds(650));
}

TEST(LockstepMachine, TellsWhenTheSequencerExecutesAndWhenItWaitsForTheNextScanline) {
    const auto edge = [](std::int64_t cycle) { return at(small().clock, cycle); };
    Machine m(
        " callp\n"
        "begin: setp draw\n"
        " line\n"
        "draw: frame\n"
        " setp rest\n"
        "rest: line\n"
        " .end begin\n",
        small());
    m.run(edge(200));
    // Up to the only frame's end; from then on nothing counts.
    EXPECT_THAT(m.sequencer, ElementsAre(std::tuple(PartState::busy, edge(0), edge(2)),
                                         std::tuple(PartState::blocked, edge(2), edge(10)),
                                         std::tuple(PartState::busy, edge(10), edge(12))));
    EXPECT_EQ(m.machine->statistics().busy, edge(2).since_start() + (edge(12) - edge(10)));
    EXPECT_EQ(m.machine->statistics().blocked, edge(10) - edge(2));
}

TEST(LockstepMachine, LetsAProgramUseTheWholeScanlineAndNoCycleMore) {
    Machine fits(nops(9) + " line\n", small());
    EXPECT_EQ(fits.run(at(small().clock, 1000)).end, RunEnd::limit);
    EXPECT_EQ(fits.machine->statistics().idle_cycles, 0);
    Machine over(nops(10) + " line\n", small());
    EXPECT_THAT(over.failure(), HasSubstr("takes 11 cycles, 1 more than a scanline has"));
    Machine slow("lds r1, 0, 0\n" + nops(8) + " lds r1, 0, 0 | line\n", small());
    EXPECT_THAT(slow.failure(), HasSubstr("takes 12 cycles, 2 more"));
}

TEST(LockstepMachine, ReportsAnOverrunWithItsProcedureAndLine) {
    Machine m(
        "; the program\n"
        " callp\n"
        "begin: setp draw\n"
        " line\n"
        "draw: nop\n"
        "draw_loop:\n" +
            nops(20) +
            " line\n"
            " .end begin\n",
        small());
    const std::string text = m.failure();
    EXPECT_THAT(text, HasSubstr("guest error at 1.428571 us: sequencer, cycle 20, scanline 1"));
    EXPECT_THAT(text, HasSubstr("overrun: with procedure draw the program takes 23 cycles, 13 "
                                "more than a scanline has"));
    EXPECT_THAT(text, HasSubstr("at 0x0003, t.s:5"));
}

TEST(LockstepMachine, SaysThatAnOverrunDoesNotEnd) {
    Machine m("loop: jump loop\n", small());
    EXPECT_THAT(m.failure(), HasSubstr("procedure loop the program has not come to `line` after "
                                       "10000 cycles; a scanline has 10"));
}

// Stores what arrives in words 100 to 109.
constexpr const char* kListen =
    "at = 6\n aux r1\n ld r2, at\n st r1, 100(r2)\n add r2, r2, #1\n st r2, at\n line\n";

TEST(LockstepMachine, GivesTheHostsIntegersOneAScanlineFromScanline0OfEachPicture) {
    Machine m(kListen, small());
    m.machine->send({7, 8, 9});
    m.run(at(small().clock, 10 * 10));
    std::vector<std::uint16_t> arrived(10);
    m.machine->array().read(3, 100, arrived);
    // It starts in the last scanline before the first picture.
    EXPECT_THAT(arrived, ElementsAre(0, 7, 8, 9, 0, 0, 7, 8, 9, 0));
}

// Each picture shows 100 times the scanline plus the lane's word 1, and is complete in its last.
constexpr const char* kPaint =
    "lane = 1\n"
    "row = 2\n"
    " ld r1, row\n"
    " ld r2, lane\n"
    " mul r3, r1, #100\n"
    " add r3, r3, r2\n"
    " vout r3\n"
    " add r1, r1, #1\n"
    " tlt r1, #5\n"
    " tget r4\n"
    " mul r1, r1, r4\n"
    " st r1, row\n"
    " teq r1, #0\n"
    " bf rest\n"
    " frame\n"
    "rest: line\n"
    "start: line\n"
    " .end start\n";

void number_lanes(LockstepArray& array) {
    for (std::int64_t lane = 0; lane < array.lanes(); ++lane) {
        array.write(lane, 1, std::array{static_cast<std::uint16_t>(lane)});
    }
}

TEST(LockstepMachine, ShowsThePictureOfAFrameWithTheNextPicture) {
    LockstepMachine::Settings settings = small();
    settings.line = 30;
    settings.frames = 2;
    Machine m(kPaint, settings);
    number_lanes(m.machine->array());
    const RunResult result = m.run();
    EXPECT_EQ(result.end, RunEnd::finished);
    // A scanline to start in; two pictures; the visible scanlines of the third.
    EXPECT_EQ(result.time, at(settings.clock, (1 + 2 * 5 + 3) * 30));
    EXPECT_EQ(m.machine->pictures_shown(), 2);
    EXPECT_EQ(m.pauses, 3) << "at the end of two frames, and when the first had been shown";
    EXPECT_THAT(m.machine->video_line(0), ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(m.machine->video_line(2), ElementsAre(200, 201, 202, 203));
    ASSERT_EQ(m.frames.size(), 2U);
    // `frame` is the 13th bundle of the scanline.
    EXPECT_EQ(m.frames[0].second, at(settings.clock, (1 + 4) * 30 + 13));
    EXPECT_EQ(m.frames[1].second, at(settings.clock, (1 + 9) * 30 + 13));
}

TEST(LockstepMachine, RefusesAPictureBeforeTheOneBeforeHasBeenShown) {
    LockstepMachine::Settings settings = small();
    settings.frames = 3;
    Machine m(" frame\n line\n", settings);
    EXPECT_THAT(m.failure(), HasSubstr("picture 1 is complete, but the video has not shown all of "
                                       "picture 0 yet"));
}

TEST(LockstepMachine, AsksItsInspectorWhenPhasesChangeUpToTheLastFrame) {
    Machine m(
        " callp\n"
        "begin: setp draw\n"
        " line\n"
        "draw: phase 1\n"
        " frame\n"
        " setp rest\n"
        "rest: phase 2\n"
        " phase 1\n"
        " line\n"
        " .end begin\n",
        small());
    std::vector<std::pair<int, int>> asked;
    m.machine->inspect([&asked](const PhaseRecord& ending, int next) {
        asked.emplace_back(ending.phase, next);
        return std::string();
    });
    EXPECT_EQ(m.run().end, RunEnd::finished);
    EXPECT_EQ(m.machine->pictures_shown(), 1);
    EXPECT_THAT(asked, ElementsAre(std::pair(0, 1)));
}

// Phase 1 lasts 7 cycles, of which lanes 2 and 3 are awake in the first and the last.
constexpr const char* kPhases =
    " ld r1, 1\n"
    " tlt r1, #2\n"
    " phase 1\n"
    " slf\n"
    " nop\n nop\n nop\n nop\n nop\n"
    " wake | phase 0\n"
    " phase 0\n"
    " frame\n"
    " halt\n";

LockstepMachine::Settings unlocked() {
    LockstepMachine::Settings settings = small();
    settings.line_locked = false;
    return settings;
}

TEST(LockstepMachine, TellsOfPhasesAndOfEachLanesTimeAwake) {
    Machine m(kPhases, unlocked());
    number_lanes(m.machine->array());
    EXPECT_EQ(m.run().time, at(small().clock, 12));
    ASSERT_EQ(m.phases.size(), 3U);
    EXPECT_EQ(m.phases[1].phase, 1);
    EXPECT_EQ(m.phases[1].began, at(small().clock, 3));
    EXPECT_EQ(m.phases[1].ended, at(small().clock, 10));
    EXPECT_EQ(m.phases[2].number, 2);
    EXPECT_EQ(m.frames.size(), 1U);
    const LockstepStatistics& counted = m.machine->statistics();
    ASSERT_EQ(counted.phases.size(), 2U);
    EXPECT_EQ(counted.phases[0].cycles, 3 + 2);
    EXPECT_EQ(counted.phases[1].cycles, 7);
    EXPECT_EQ(counted.phases[1].lane_cycles, 2 * 7 + 2 * 2);
    EXPECT_EQ(m.machine->lane_statistics(0).cycles, 12);
    EXPECT_EQ(m.machine->lane_statistics(3).cycles, 7);
    EXPECT_EQ(counted.frames.at(0).at(4), 1);
}

TEST(LockstepMachine, GivesEachLaneATimeLineWithoutGaps) {
    Machine m(kPhases, unlocked());
    number_lanes(m.machine->array());
    const Time end = m.run().time;
    std::vector<Time> reached(4);
    std::vector<Duration> busy(4);
    for (const StateInterval& interval : m.intervals) {
        EXPECT_EQ(interval.from, reached[interval.node]);
        EXPECT_LT(interval.from, interval.to);
        reached[interval.node] = interval.to;
        busy[interval.node] +=
            interval.state == NodeState::busy ? interval.to - interval.from : Duration();
    }
    EXPECT_EQ(reached, std::vector<Time>(4, end));
    EXPECT_EQ(busy[0], end.since_start());
    EXPECT_EQ(busy[3], m.machine->lane_statistics(3).in_state(NodeState::busy));
    EXPECT_LT(busy[3], busy[0]);
}

TEST(LockstepMachine, GoesOnAtOnceAfterALineWhenItIsNotLocked) {
    Machine m(
        "count = 5\n ld r1, count\n add r1, r1, #1\n st r1, count\n teq r1, #100\n bt end\n line\n"
        "end: halt\n",
        unlocked());
    EXPECT_EQ(m.run().time, at(small().clock, 99 * 6 + 5 + 1));
    EXPECT_EQ(m.machine->statistics().scanlines, 100);
    EXPECT_EQ(m.frames.size(), 1U) << "a program that halts without a frame has drawn one";
}

TEST(LockstepMachine, NamesTheFirstLaneWithAnErrorAndWhatItMeans) {
    Machine m(
        "error = 9\nerror_name_receive_array_full = 2\n"
        " ld r1, 1\n tge r1, #2\n tget r2\n add r2, r2, r2\n st r2, error\n halt\n",
        unlocked());
    number_lanes(m.machine->array());
    const std::string text = m.failure();
    EXPECT_THAT(text, HasSubstr("the program has halted: lane 2: receive array full"));
    EXPECT_THAT(text, HasSubstr("t.s:8"));
}

TEST(LockstepMachine, ReportsATrapWhereItHappens) {
    Machine m(" nop\n ret\n", unlocked());
    const std::string text = m.failure();
    EXPECT_THAT(text, HasSubstr("cycle 1"));
    EXPECT_THAT(text, HasSubstr("0x0001, t.s:2"));
}

TEST(LockstepMachine, DoesTheSameOnAnyNumberOfThreads) {
    const auto told = [](int threads) {
        LockstepMachine::Settings settings = small();
        settings.line = 30;
        settings.array.lanes = 5000;
        settings.array.threads = threads;
        settings.frames = 2;
        Machine m(kPaint, settings);
        number_lanes(m.machine->array());
        const Time end = m.run().time;
        std::vector<std::uint16_t> video(m.machine->video_line(2).begin(),
                                         m.machine->video_line(2).end());
        std::vector<std::pair<Time, Time>> intervals;
        for (const StateInterval& interval : m.intervals) {
            intervals.emplace_back(interval.from, interval.to);
        }
        return std::tuple(end, video, intervals);
    };
    const auto expected = told(1);
    EXPECT_TRUE(told(2) == expected);
    EXPECT_TRUE(told(3) == expected);
}

TEST(LockstepMachine, RefusesSettingsOutOfRange) {
    const auto with = [](auto change) {
        LockstepMachine::Settings settings = small();
        change(settings);
        Machine m(" halt\n", settings);
    };
    EXPECT_THROW(with([](auto& s) { s.line = 0; }), std::invalid_argument);
    EXPECT_THROW(with([](auto& s) { s.visible_lines = 6; }), std::invalid_argument);
    EXPECT_THROW(with([](auto& s) { s.frames = 0; }), std::invalid_argument);
}

}  // namespace
}  // namespace rasterloom
