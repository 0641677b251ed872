// SPDX-License-Identifier: MIT
// Whole machines between a host and processors that collect polygons: who gets what, in which
// order, and when.
#include "machine/fabric/polygon_cut.hpp"
#include "machine/fabric/polygon_part.hpp"
#include "tests/fabric/polygon_machine.hpp"
#include "tests/node/script_program.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom {
namespace {

using testing::HasSubstr;
using topology::Distribution;

PolygonVertex vertex_on(int size) {
    const auto coordinate = [&] { return static_cast<std::int16_t>(*rc::gen::inRange(0, size)); };
    return {coordinate(), coordinate(), coordinate(), coordinate()};
}

// Triangles: convex whatever their vertices; the direction is of no concern to the fabric.
std::vector<std::vector<Polygon>> any_frames(int frames, int size) {
    std::vector<std::vector<Polygon>> result(static_cast<std::size_t>(frames));
    for (auto& frame : result) {
        for (int i = *rc::gen::inRange(0, 12); i > 0; --i) {
            frame.push_back({{vertex_on(size), vertex_on(size), vertex_on(size)}});
        }
    }
    return result;
}

Duration any_time() {
    return Duration::nanoseconds(*rc::gen::inRange(0, 3) * *rc::gen::inRange(0, 2000));
}

PolygonMachineSettings any_machine() {
    PolygonMachineSettings machine;
    machine.size = 48;
    const auto part = [] { return *rc::gen::element(1, 2, 3, 4); };
    machine.tiling = {part(), part(), *rc::gen::element(1, 2), *rc::gen::element(1, 2)};
    PolygonFabricSettings& fabric = machine.fabric;
    fabric.ideal = *rc::gen::inRange(0, 5) == 0;
    fabric.whole_edges = *rc::gen::element(false, true);
    fabric.host_time_per_polygon = any_time();
    fabric.host_time_per_vertex = any_time();
    fabric.splitter_time_per_vertex = any_time();
    fabric.bus_time_per_word = any_time();
    const auto depth = [] { return *rc::gen::inRange(1, 4); };
    fabric.splitter_input_fifo = depth();
    fabric.splitter_output_fifo = depth();
    fabric.bus_input_fifo = depth();
    fabric.processor_fifo = depth();
    fabric.latency = Duration::tick() + any_time();
    machine.frames = *rc::gen::inRange(1, 4);
    const int slowness = *rc::gen::inRange(0, 40);
    machine.cycles_per_vertex = [slowness](NodeIndex node) {
        return static_cast<std::int64_t>(node) * slowness;
    };
    return machine;
}

// What each processor is to get, by the distribution alone.
void distribute(const Distribution& distribution, std::size_t element, const Polygon& polygon,
                bool whole_edges, std::vector<std::vector<Polygon>>& to) {
    const auto& what = distribution.elements[element].what;
    if (const auto* cut = std::get_if<Distribution::Cut>(&what)) {
        Polygon low;
        Polygon high;
        if (whole_edges) {
            part_polygon(polygon, cut->axis, cut->line, low, high);
        } else {
            cut_polygon(polygon.vertices, cut->axis, cut->line, low.vertices, high.vertices);
        }
        if (!low.vertices.empty()) {
            distribute(distribution, cut->low, low, whole_edges, to);
        }
        if (!high.vertices.empty()) {
            distribute(distribution, cut->high, high, whole_edges, to);
        }
    } else if (const auto* all = std::get_if<Distribution::Broadcast>(&what)) {
        for (const NodeIndex processor : all->processors) {
            to[processor].push_back(polygon);
        }
    } else {
        to[std::get<Distribution::Leaf>(what).processor].push_back(polygon);
    }
}

TEST(PolygonNetwork, GivesEveryProcessorItsPartOfEveryPolygonInTheirOrder) {
    EXPECT_TRUE(rc::check([] {
        const PolygonMachineSettings settings = any_machine();
        const auto frames = any_frames(settings.frames, settings.size);
        PolygonMachine machine(settings, frames);
        RC_ASSERT(machine.run() == "no failure");
        RC_ASSERT(machine.supervisor->over());
        for (std::size_t frame = 0; frame < frames.size(); ++frame) {
            std::vector<std::vector<Polygon>> expected(machine.cores.size());
            for (const Polygon& polygon : frames[frame]) {
                distribute(machine.distribution, 0, polygon, settings.fabric.whole_edges, expected);
            }
            for (std::size_t node = 0; node < expected.size(); ++node) {
                RC_ASSERT(machine.cores[node]->frames.size() == frames.size());
                RC_ASSERT(machine.cores[node]->frames[frame] == expected[node]);
            }
        }
    }));
}

// Adds up what the parts tell.
class PartScribe final : public PartListener {
  public:
    struct Part {
        Duration busy;
        Duration blocked;
        Time last;
        Time last_change;
        int waiting = 0;     // messages
        int in_outputs = 0;  // likewise
        int passed = 0;
        bool in_order = true;
    };

    void part_interval_ended(const PartInterval& interval) override {
        Part& part = parts[interval.part];
        part.in_order &= part.last <= interval.from && interval.from < interval.to;
        part.last = interval.to;
        (interval.state == PartState::busy ? part.busy : part.blocked) +=
            interval.to - interval.from;
    }
    void queue_changed(const QueueChange& change) override {
        Part& part = parts[change.component];
        part.in_order &= part.last_change <= change.time;
        part.last_change = change.time;
        (change.place == QueuePlace::input ? part.waiting : part.in_outputs) += change.change;
        part.in_order &= part.in_outputs >= 0;
    }
    void message_passed(ComponentId part, const MessageRecord& message) override {
        Part& told = parts[part];
        --told.waiting;
        ++told.passed;
        told.in_order &= message.started <= message.delivered &&
                         message.delivered <= message.consumed && message.delivery != kNoCause;
    }

    std::map<ComponentId, Part> parts;
};

TEST(PolygonNetwork, TellsListenersOfEachPartWhatItsStatisticsSay) {
    EXPECT_TRUE(rc::check([] {
        const PolygonMachineSettings settings = any_machine();
        PolygonMachine machine(settings, any_frames(settings.frames, settings.size));
        PartScribe scribe;
        machine.network.for_each_part([&](auto& part) { part.probe().attach(scribe); });
        RC_ASSERT(machine.run() == "no failure");
        for (const auto& [id, part] : scribe.parts) {
            RC_ASSERT(part.in_order);
            RC_ASSERT(part.waiting == 0);
            RC_ASSERT(part.in_outputs == 0);
        }
        const auto told = [&](const Component& part) { return scribe.parts[part.id()]; };
        const PolygonSourceStatistics& source = machine.network.source->statistics();
        RC_ASSERT(told(*machine.network.source).busy == source.busy);
        RC_ASSERT(told(*machine.network.source).blocked == source.blocked);
        for (const PolygonSplitter* splitter : machine.network.splitters) {
            RC_ASSERT(told(*splitter).busy == splitter->statistics().busy);
            RC_ASSERT(told(*splitter).blocked == splitter->statistics().blocked);
            RC_ASSERT(told(*splitter).passed == splitter->statistics().polygons + settings.frames);
        }
        for (const PolygonBus* bus : machine.network.buses) {
            RC_ASSERT(told(*bus).busy == bus->statistics().busy);
            RC_ASSERT(told(*bus).blocked == bus->statistics().held);
            RC_ASSERT(told(*bus).passed == bus->statistics().messages);
        }
    }));
}

using Row = std::tuple<std::uint64_t, NodeIndex, NodeIndex, std::uint8_t, Time, Time, Time, Time>;

std::vector<Row> rows(const PolygonMachine& machine) {
    std::vector<Row> all;
    for (const MessageRecord& m : machine.messages) {
        all.emplace_back(m.id, m.source(), m.destination, m.hops, m.queued, m.started, m.delivered,
                         m.consumed);
    }
    std::sort(all.begin(), all.end());
    return all;
}

TEST(PolygonNetwork, TakesTheSameTimeHoweverItIsBuiltAndExecuted) {
    EXPECT_TRUE(rc::check([] {
        PolygonMachineSettings settings = any_machine();
        const auto frames = any_frames(settings.frames, settings.size);
        PolygonMachine one(settings, frames);
        settings.run_ahead = false;
        settings.backwards = true;
        PolygonMachine other(settings, frames);
        RC_ASSERT(one.run() == other.run());
        RC_ASSERT(rows(one) == rows(other));
        RC_ASSERT(one.frame_ends == other.frame_ends);
    }));
}

TEST(PolygonNetwork, CostsNothingWhenItIsIdeal) {
    EXPECT_TRUE(rc::check([] {
        PolygonMachineSettings settings = any_machine();
        settings.fabric.ideal = true;
        settings.frames = 1;
        settings.clock = Clock::with_period(Duration::nanoseconds(300));
        PolygonMachine machine(settings, any_frames(1, settings.size));
        RC_ASSERT(machine.run() == "no failure");
        // The slowest processor's own work: a cycle for each message and CREDIT's own beginning,
        // and one for the first polygon's way, which takes some ticks.
        std::int64_t slowest = 0;
        for (NodeIndex node = 0; node < machine.cores.size(); ++node) {
            std::int64_t cycles = 1;
            for (const Polygon& polygon : machine.cores[node]->frames[0]) {
                cycles += 1 + settings.cycles_per_vertex(node) *
                                  static_cast<std::int64_t>(polygon.vertices.size());
            }
            slowest = std::max(slowest, cycles);
        }
        const Duration up = Duration::nanoseconds(10);
        const Duration took = machine.frame_ends[0].since_start() - up;
        RC_ASSERT(took == (slowest + 1) * Duration::nanoseconds(300));
        for (const PolygonSplitter* splitter : machine.network.splitters) {
            RC_ASSERT(splitter->statistics().blocked == Duration());
        }
    }));
}

TEST(PolygonNetwork, DrawsTheFramesAgainWhenThereAreFewerThanTheRunHas) {
    PolygonMachineSettings settings;
    settings.frames = 3;
    settings.fabric.phases_per_frame = 1;
    const Polygon point{{{1, 2, 3, 4}}};
    const Polygon other{{{5, 6, 7, 8}}};
    PolygonMachine machine(settings, {{point}, {other, other}});
    EXPECT_EQ(machine.run(), "no failure");
    const std::vector<std::vector<Polygon>> expected{{point}, {other, other}, {point}};
    EXPECT_EQ(machine.cores[0]->frames, expected);
    EXPECT_EQ(machine.network.source->statistics().frames, 3);
    EXPECT_EQ(machine.network.source->statistics().polygons, 4);
}

TEST(PolygonNetwork, NamesTheHostAsOneMoreNode) {
    PolygonMachineSettings settings;
    settings.tiling = {2, 2, 1, 1};
    PolygonMachine machine(settings, {{Polygon{{{0, 0, 0, 0}, {511, 0, 0, 0}, {0, 511, 0, 0}}}}});
    EXPECT_EQ(machine.run(), "no failure");
    ASSERT_EQ(machine.messages.size(), 3U + 4U);
    for (const MessageRecord& record : machine.messages) {
        EXPECT_EQ(record.source(), 4U);
        EXPECT_EQ(record.hops, 2);
        EXPECT_EQ(record.id & 0xffffffffU, record.kind == 1 ? 0U : 1U);
    }
}

TEST(PolygonNetwork, SendsAFrameInItsFirstPhaseOnly) {
    PolygonMachineSettings settings;
    settings.tiling = {2, 1, 1, 1};
    settings.fabric.phases_per_frame = 3;
    settings.frames = 2;
    const Polygon point{{{1, 2, 3, 4}}};
    PolygonMachine machine(settings, {{point}, {point, point}});
    EXPECT_EQ(machine.run(), "no failure");
    const std::vector<std::vector<Polygon>> expected{{point}, {point, point}};
    EXPECT_EQ(machine.cores[0]->frames, expected);
    EXPECT_EQ(machine.supervisor->phase().number, 6);
}

TEST(PolygonNetwork, ReportsWhoWaitsWhenAProgramExpectsMoreThanTheHostSends) {
    PolygonMachineSettings settings;
    settings.fabric.phases_per_frame = 2;
    settings.make_core = [](NodeIndex) { return std::make_unique<PolygonCore>(0, 1); };
    PolygonMachine machine(settings, {{}});
    EXPECT_THAT(machine.run(), HasSubstr("node/P0 waits for a message at port 0"));
}

TEST(PolygonNetwork, ReportsAProgramThatEndsAPhaseTheHostIsStillIn) {
    PolygonMachineSettings settings;
    settings.frames = 2;
    settings.make_core = [](NodeIndex) {
        return std::make_unique<ScriptCore>(
            Script().write(node_register(NodeRegister::credit), 0177776).halt().program(), 1,
            0160000);
    };
    PolygonMachine machine(settings, {{Polygon{{{1, 2, 3, 4}}}}});
    EXPECT_THAT(machine.run(),
                HasSubstr("host: a phase ends while frame 0 is being sent; this node runs no "
                          "program, so another has given back more than it had"));
}

TEST(PolygonNetwork, RefusesProcessorsThatDoNotFit) {
    const Distribution distribution = topology::distribute({2, 1, 1, 1}, 64, 64);
    const PolygonFabricSettings settings;
    Simulation simulation;
    Processor::Settings processor;
    set_polygon_ports(processor, settings, distribution.grids[0]);
    std::vector<Processor*> processors{
        &simulation.add<Processor>("node/P0", std::make_unique<PolygonCore>(), processor)};
    EXPECT_THROW(connect_polygon_network(simulation, distribution, processors, settings),
                 WiringError);
    processor.ports.input_queue = 5;
    processors.push_back(
        &simulation.add<Processor>("node/P1", std::make_unique<PolygonCore>(), processor));
    EXPECT_THAT(
        [&] { connect_polygon_network(simulation, distribution, processors, settings); },
        testing::ThrowsMessage<WiringError>(
            "node/P1: has 1 message ports with 5 places, not as set_polygon_ports() makes them"));
}

}  // namespace
}  // namespace rasterloom
