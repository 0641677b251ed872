// SPDX-License-Identifier: MIT
// The parts of the polygon fabric one by one: exact times, and who waited for whom.
#include "tests/fabric/polygon_machine.hpp"
#include "tests/node/script_program.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Verb = ScriptCore::Verb;

Duration us(std::int64_t microseconds) {
    return Duration::microseconds(microseconds);
}
Time at_ns(std::int64_t nanoseconds) {
    return Time::zero() + Duration::nanoseconds(nanoseconds);
}

// FIFOs of one message, all times 0 but the wires' microsecond, a clock of 1 MHz.
PolygonMachineSettings narrow_machine(const topology::Tiling& tiling) {
    PolygonMachineSettings settings;
    settings.tiling = tiling;
    settings.clock = Clock::with_period(us(1));
    PolygonFabricSettings& fabric = settings.fabric;
    fabric.host_time_per_polygon = fabric.host_time_per_vertex = Duration();
    fabric.splitter_time_per_vertex = fabric.bus_time_per_word = Duration();
    fabric.splitter_input_fifo = fabric.splitter_output_fifo = 1;
    fabric.bus_input_fifo = fabric.processor_fifo = 1;
    return settings;
}

const Polygon kLowPoint{{{1, 2, 3, 4}}};
const Polygon kLowTriangle{{{0, 0, 0, 0}, {9, 0, 0, 0}, {9, 9, 0, 0}}};

TEST(PolygonSource, SendsAtItsPaceAndTheSplitterWorksForEachVertex) {
    PolygonMachineSettings settings = narrow_machine({2, 1, 1, 1});
    settings.fabric.host_time_per_polygon = us(10);
    settings.fabric.host_time_per_vertex = us(2);
    settings.fabric.splitter_time_per_vertex = Duration::nanoseconds(600);
    PolygonMachine machine(settings, {{kLowTriangle, kLowPoint}});
    EXPECT_EQ(machine.run(), "no failure");
    ASSERT_EQ(machine.messages.size(), 4U);
    const MessageRecord& triangle = machine.messages[0];
    EXPECT_EQ(triangle.queued, at_ns(16000 + 1000 + 3 * 600));
    EXPECT_EQ(triangle.started, at_ns(16000 + 1000 + 3 * 600));
    EXPECT_EQ(triangle.delivered, at_ns(16000 + 1000 + 3 * 600 + 1000));
    const MessageRecord& point = machine.messages[1];
    EXPECT_EQ(point.queued, at_ns(28000 + 1000 + 600));
    EXPECT_EQ(point.delivered, at_ns(28000 + 1000 + 600 + 1000));
    // The end of the frame is ready when the point has left, waits until the point's place in the
    // splitter is free and known to be, and takes no work; the low side's processor frees the
    // point's place at 31 us.
    const bool low_first = machine.messages[2].destination == 0;
    const MessageRecord& low = machine.messages[low_first ? 2 : 3];
    const MessageRecord& high = machine.messages[low_first ? 3 : 2];
    EXPECT_EQ(low.queued, at_ns(28000 + 1000 + 600 + 1000 + 1000));
    EXPECT_EQ(low.delivered, at_ns(31000 + 1000 + 1000));
    EXPECT_EQ(high.delivered, at_ns(28000 + 1000 + 600 + 1000 + 1000 + 1000));
    const PolygonSourceStatistics& source = machine.network.source->statistics();
    EXPECT_EQ(source.busy, us(28));
    EXPECT_EQ(source.blocked, Duration::nanoseconds(2600));
    EXPECT_EQ(source.vertices, 4);
    const SplitterStatistics splitter = machine.network.splitters[0]->statistics();
    EXPECT_EQ(splitter.busy, Duration::nanoseconds(4 * 600));
    EXPECT_EQ(splitter.low.vertices, 4);
    EXPECT_EQ(splitter.high.polygons, 0);
    EXPECT_EQ(splitter.cut, 0);
}

TEST(PolygonSplitter, IsBlockedByAFullOutputAndKnowsWhich) {
    PolygonMachineSettings settings = narrow_machine({2, 1, 1, 1});
    settings.cycles_per_vertex = [](NodeIndex node) { return node == 0 ? 100 : 0; };
    PolygonMachine machine(settings, {{5, kLowPoint}});
    EXPECT_EQ(machine.run(), "no failure");
    // Processor 0 takes a point at 2, 103, 204, 305 and 406 us. Point 3 comes to the splitter at 7,
    // when 2 stands in the output FIFO, and goes on at 104; 4 waits from 106 to 205, the end of the
    // frame from 207 to 306.
    const SplitterStatistics splitter = machine.network.splitters[0]->statistics();
    EXPECT_EQ(splitter.blocked, us(97 + 99 + 99));
    EXPECT_EQ(splitter.low.blocked, splitter.blocked);
    EXPECT_EQ(splitter.high.blocked, Duration());
    EXPECT_EQ(splitter.low.fifo.peak, 1);
    EXPECT_EQ(splitter.high.fifo.peak, 0);
    EXPECT_EQ(splitter.input_fifo.full, splitter.blocked);
    // Full from 5 on but for no time at all, until the end of the frame leaves at 407.
    EXPECT_EQ(splitter.low.fifo.full, us(407 - 5));
    EXPECT_DOUBLE_EQ(splitter.low.fifo.mean(us(804)), 0.5);
    EXPECT_EQ(machine.network.source->statistics().blocked, us(206));
}

TEST(PolygonBus, ReachesAllListenersWhenItsTransferEnds) {
    PolygonMachineSettings settings = narrow_machine({1, 1, 2, 1});
    settings.fabric.bus_time_per_word = Duration::nanoseconds(300);
    PolygonMachine machine(settings, {{kLowTriangle}});
    EXPECT_EQ(machine.run(), "no failure");
    ASSERT_EQ(machine.messages.size(), 4U);
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(machine.messages[static_cast<std::size_t>(i)].started, at_ns(1000));
        EXPECT_EQ(machine.messages[static_cast<std::size_t>(i)].delivered,
                  at_ns(1000 + 14 * 300 + 1000));
        EXPECT_EQ(machine.messages[static_cast<std::size_t>(i)].hops, 1);
    }
    const PolygonBusStatistics bus = machine.network.buses[0]->statistics();
    EXPECT_EQ(bus.messages, 2);
    EXPECT_EQ(bus.words, 14 + 2);
    EXPECT_EQ(bus.busy, Duration::nanoseconds(16 * 300));
}

TEST(PolygonBus, IsHeldByItsSlowestListener) {
    PolygonMachineSettings settings = narrow_machine({1, 1, 2, 2});
    settings.cycles_per_vertex = [](NodeIndex node) { return node == 2 ? 100 : 0; };
    PolygonMachine machine(settings, {{3, kLowPoint}});
    EXPECT_EQ(machine.run(), "no failure");
    // Processor 2 takes points at 2, 103 and 204 us. Point 2 comes to the bus at 5 and goes at 104,
    // the end of the frame waits from 106 to 205.
    const PolygonBusStatistics bus = machine.network.buses[0]->statistics();
    EXPECT_EQ(bus.held, us(99 + 99));
    EXPECT_THAT(bus.held_by, ElementsAre(Duration(), Duration(), us(198), Duration()));
    EXPECT_EQ(bus.busy, Duration());
}

// Two image words written over the bus.
Script two_words() {
    Script s;
    return s.write(kFbRow, 0).write(kBusImageWindow, 5).write(kBusImageWindow + 2, 6).halt();
}

// Processors that run this program, all of them at the same time.
struct WritersMachine {
    explicit WritersMachine(Duration time_per_pixel, int processors,
                            const Script& program = two_words(), bool run_ahead = true) {
        bus = &simulation.add<FrameBufferBus>("frame_buffer_bus", time_per_pixel, processors);
        for (int i = 0; i < processors; ++i) {
            Processor::Settings settings;
            settings.node = static_cast<NodeIndex>(i);
            settings.clock = Clock::with_period(Duration::nanoseconds(100));
            settings.supervised = false;
            settings.run_ahead = run_ahead;
            settings.frame_buffer = FrameBuffer::Settings{1, 2, true};
            writers.push_back(&simulation.add<Processor>(
                fmt::format("node/{}", processors - i),  // the order of names is not the ports'
                std::make_unique<ScriptCore>(program.program(), 1, 0160000), settings));
            bus->connect(simulation, i, *writers.back());
        }
        simulation.seal();
    }
    Simulation simulation;
    FrameBufferBus* bus;
    std::vector<Processor*> writers;
};

TEST(FrameBufferBus, TakesAWordInItsTimeWhenNobodyElseAsks) {
    // Asked at 300 ns: done at 550, and at the clock's next edge the write stands and takes its
    // cycle. Then asked again at 800.
    for (const auto& [time, end] : {std::pair{250, 1300}, {300, 1300}, {301, 1500}, {0, 900}}) {
        WritersMachine machine(Duration::nanoseconds(time), 1);
        EXPECT_EQ(machine.simulation.run().end, RunEnd::finished);
        EXPECT_EQ(machine.writers[0]->reached(), at_ns(end)) << time;
        EXPECT_EQ(machine.writers[0]->frame_buffer()->image(0, 0), 5);
        EXPECT_EQ(machine.writers[0]->frame_buffer()->image(0, 1), 6);
        EXPECT_EQ(machine.bus->statistics().waiting, Duration());
        EXPECT_EQ(machine.bus->statistics().busy, Duration::nanoseconds(2 * time));
    }
}

TEST(FrameBufferBus, ServesThoseThatAskInTurnHoweverTheyAreExecuted) {
    for (const bool run_ahead : {true, false}) {
        WritersMachine machine(Duration::nanoseconds(300), 3, two_words(), run_ahead);
        EXPECT_EQ(machine.simulation.run().end, RunEnd::finished);
        // All ask at 300 ns and have their words written at 600, 900 and 1200; they ask again at
        // 800, 1100 and 1400, and from 1200 on the bus is never idle.
        EXPECT_EQ(machine.writers[0]->reached(), at_ns(1500 + 200));
        EXPECT_EQ(machine.writers[1]->reached(), at_ns(1800 + 200));
        EXPECT_EQ(machine.writers[2]->reached(), at_ns(2100 + 200));
        const FrameBufferBusStatistics& bus = machine.bus->statistics();
        EXPECT_EQ(bus.pixels, 6);
        EXPECT_EQ(bus.peak_waiting, 3);
        EXPECT_THAT(bus.waiting_of,
                    ElementsAre(Duration::nanoseconds(400), Duration::nanoseconds(300 + 400),
                                Duration::nanoseconds(600 + 400)));
        EXPECT_EQ(bus.waiting, Duration::nanoseconds(2100));
        for (Processor* writer : machine.writers) {
            writer->close_books(at_ns(2300));
        }
        EXPECT_EQ(machine.writers[2]->statistics().in_state(NodeState::waiting_output),
                  Duration::nanoseconds(900 + 700));
    }
}

TEST(FrameBufferBus, LeadsToTheImageWindowOnly) {
    const auto failure = [](const Script& program) {
        WritersMachine machine(Duration::nanoseconds(300), 1, program);
        const RunResult result = machine.simulation.run();
        return result.failure == nullptr ? "no failure" : result.failure->message();
    };
    EXPECT_THAT(failure(Script().write(kFbRow, 0).write(kBusImageWindow + 4, 0)),
                HasSubstr("bus error 170004"));
    EXPECT_THAT(failure(Script().load(0, kBusImageWindow)), HasSubstr("bus error 170000"));
    EXPECT_THAT(failure(Script().write(kBusImageWindow, 0)),
                HasSubstr("before FBROW has selected a row"));
    // Two accesses to the I/O page in one instruction, of which the second would have to wait.
    EXPECT_THAT(failure(Script().write(kFbRow, 0).op(Verb::move, 0, kBusImageWindow,
                                                     node_register(NodeRegister::node))),
                HasSubstr("stalls at the second"));
}

TEST(PolygonFabric, RefusesSettingsOutOfRange) {
    const Duration negative = Duration() - Duration::tick();
    EXPECT_THROW(PolygonSplitter("s", {.time_per_vertex = negative}), std::invalid_argument);
    EXPECT_THROW(PolygonSplitter("s", {.input_fifo = 0}), std::invalid_argument);
    EXPECT_THROW(PolygonSplitter("s", {.output_fifo = 0}), std::invalid_argument);
    EXPECT_THROW(PolygonBus("b", {.time_per_word = negative}), std::invalid_argument);
    EXPECT_THROW(PolygonBus("b", {.input_fifo = 0}), std::invalid_argument);
    EXPECT_THROW(PolygonBus("b", {.listeners = 0}), std::invalid_argument);
    EXPECT_THROW(TurnBus("t", {.time_per_word = negative}), std::invalid_argument);
    EXPECT_THROW(TurnBus("t", {.processors = 0}), std::invalid_argument);
    EXPECT_THROW(TurnBus("t", {.receiver_places = 0}), std::invalid_argument);
    EXPECT_THROW(FrameBufferBus("f", negative, 1), std::invalid_argument);
    EXPECT_THROW(FrameBufferBus("f", Duration(), 0), std::invalid_argument);
    PolygonSourceSettings settings;
    settings.phases_per_frame = 0;
    EXPECT_THROW(PolygonSource("h", settings), std::invalid_argument);
    settings = {};
    settings.time_per_polygon = negative;
    EXPECT_THROW(PolygonSource("h", settings), std::invalid_argument);
    PolygonSource source("h", {});
    EXPECT_THROW(source.load({{Polygon{}}}), std::invalid_argument);
    EXPECT_THROW(source.load({{Polygon{std::vector<PolygonVertex>(11)}}}), std::invalid_argument);
}

}  // namespace
}  // namespace rasterloom
