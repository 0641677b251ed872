// SPDX-License-Identifier: MIT
// Half-digested broadcast with programs that do what machine/fabric/turn_bus.hpp asks of them.
#include "tests/fabric/polygon_machine.hpp"
#include "tests/node/script_program.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom {
namespace {

using Verb = ScriptCore::Verb;

// Digests are drawn first; polygons are set up when there is room for what becomes of them.
Script digesting_program(std::uint32_t set_up, std::uint32_t draw) {
    constexpr std::uint32_t kDigest = 0;
    constexpr std::uint32_t kRaw = 256;
    constexpr std::uint32_t kSent = 512;
    Script s;
    s.set(5, 2);
    s.label("loop").load(1, port_register(PortRegister::rxstat, 1));
    s.jump(Verb::jump_if_clear, "no digest", 1, kStatReady);
    s.label("digest").write(port_register(PortRegister::rxaddr, 1), kDigest);
    s.op(Verb::peek, 2, 0, kDigest).jump(Verb::jump_if_equal, "end", 2, 5);
    s.work(draw).jump(Verb::jump, "loop");

    s.label("no digest").load(1, port_register(PortRegister::rxstat, 0));
    s.jump(Verb::jump_if_clear, "idle", 1, kStatReady);
    s.load(1, port_register(PortRegister::txstat, 1));
    s.jump(Verb::jump_if_clear, "digest", 1, kStatReady);  // stalls until one is there
    s.write(port_register(PortRegister::rxaddr, 0), kRaw);
    s.write(port_register(PortRegister::txaddr, 1), kSent);
    s.op(Verb::peek, 2, 0, kRaw).jump(Verb::jump_if_equal, "send end", 2, 5);
    s.work(set_up).set(1, 3).op(Verb::poke, 1, 0, kSent);
    s.write(port_register(PortRegister::txlen, 1), 40).jump(Verb::jump, "loop");
    s.label("send end").op(Verb::poke, 2, 0, kSent);
    s.write(port_register(PortRegister::txlen, 1), 2).jump(Verb::jump, "loop");

    s.label("idle").write(node_register(NodeRegister::waitfor), kWaitMessage);
    s.jump(Verb::jump, "loop");

    s.label("end").write(node_register(NodeRegister::credit), 0177777);
    s.write(node_register(NodeRegister::waitfor), kWaitPhase);
    s.load(1, node_register(NodeRegister::phase)).set(2, kRunOver);
    s.jump(Verb::jump_if_equal, "halt", 1, 2).jump(Verb::jump, "loop");
    return s.label("halt").halt();
}

PolygonMachineSettings digesting_machine(int columns, int rows) {
    PolygonMachineSettings settings;
    settings.size = 24;
    settings.tiling = {1, 1, columns, rows};
    settings.fabric.half_digested = true;
    settings.make_core = [](NodeIndex node) {
        return std::make_unique<ScriptCore>(digesting_program(100, 30).program(), node + 1,
                                            0160000);
    };
    return settings;
}

const Polygon kPoint{{{1, 2, 3, 4}}};

// What each processor has to consume by port 1, as (source, which one of the source's messages).
std::vector<std::pair<NodeIndex, std::uint32_t>> expected_digests(
    const std::vector<std::size_t>& frames, std::size_t processors) {
    std::vector<std::pair<NodeIndex, std::uint32_t>> all;
    std::vector<std::uint32_t> sent(processors);
    for (const std::size_t polygons : frames) {
        for (std::size_t i = 0; i < polygons; ++i) {
            const std::size_t sender = i % processors;
            all.emplace_back(static_cast<NodeIndex>(sender), sent[sender]++);
        }
        for (std::uint32_t& each : sent) {
            ++each;  // the end of the frame, which is broadcast once: under the last one's name
        }
        const std::size_t last = (polygons + processors - 1) % processors;
        all.emplace_back(static_cast<NodeIndex>(last), sent[last] - 1);
    }
    return all;
}

TEST(TurnBus, GivesEverybodyAllDigestsInTheOrderOfThePolygonsForAnyNumberOfThem) {
    EXPECT_TRUE(rc::check([] {
        PolygonMachineSettings settings =
            digesting_machine(*rc::gen::element(2, 3, 4), *rc::gen::element(1, 2, 3));
        PolygonFabricSettings& fabric = settings.fabric;
        fabric.ideal = *rc::gen::inRange(0, 5) == 0;
        fabric.host_time_per_polygon = Duration::nanoseconds(*rc::gen::inRange(0, 5000));
        fabric.bus_time_per_word = Duration::nanoseconds(*rc::gen::inRange(0, 400));
        fabric.processor_fifo = *rc::gen::inRange(1, 4);
        fabric.bus_input_fifo = *rc::gen::inRange(1, 3);
        fabric.digest_output_queue = *rc::gen::inRange(1, 4);
        const auto set_up = *rc::gen::inRange<std::uint32_t>(0, 200);
        const auto draw = *rc::gen::inRange<std::uint32_t>(0, 200);
        settings.make_core = [=](NodeIndex node) {
            return std::make_unique<ScriptCore>(
                digesting_program(set_up * (node % 3), draw * (node % 2)).program(), node + 1,
                0160000);
        };
        const auto polygons =
            *rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(0, 20));
        RC_PRE(!polygons.empty());
        settings.frames = static_cast<int>(polygons.size());
        std::vector<std::vector<Polygon>> frames;
        for (const std::size_t count : polygons) {
            frames.emplace_back(count, kPoint);
        }
        PolygonMachine machine(settings, frames);
        const std::string end = machine.run();
        if (end != "no failure") {
            RC_FAIL(end);
        }
        const std::size_t processors = machine.processors.size();
        const auto expected = expected_digests(polygons, processors);
        for (NodeIndex node = 0; node < processors; ++node) {
            std::vector<std::pair<NodeIndex, std::uint32_t>> digests;
            for (const MessageRecord& m : machine.messages) {
                if (m.destination == node && m.source() != processors) {
                    digests.emplace_back(m.source(), static_cast<std::uint32_t>(m.id));
                }
            }
            RC_ASSERT(digests == expected);
        }
    }));
}

TEST(TurnBus, DealsThePolygonsOneByOneAndTheEndOfTheFrameToAll) {
    PolygonMachine machine(digesting_machine(3, 1), {std::vector<Polygon>(5, kPoint)});
    EXPECT_EQ(machine.run(), "no failure");
    std::vector<std::vector<std::uint32_t>> raw(3);
    for (const MessageRecord& m : machine.messages) {
        if (m.source() == 3) {
            raw[m.destination].push_back(static_cast<std::uint32_t>(m.id));
        }
    }
    EXPECT_THAT(raw[0], testing::ElementsAre(0, 3, 5));
    EXPECT_THAT(raw[1], testing::ElementsAre(1, 4, 5));
    EXPECT_THAT(raw[2], testing::ElementsAre(2, 5));
    const TurnBusStatistics& bus = machine.network.turn_buses[0]->statistics();
    EXPECT_EQ(bus.messages, 5 + 1);
    EXPECT_EQ(bus.words, 5 * 20 + 2);
    EXPECT_EQ(bus.busy, (5 * 20 + 2) * Duration::nanoseconds(300));
}

TEST(TurnBus, KnowsWhomItWaitedFor) {
    PolygonMachineSettings settings = digesting_machine(2, 1);
    settings.make_core = [](NodeIndex node) {
        return std::make_unique<ScriptCore>(digesting_program(node == 0 ? 1000 : 1, 1).program(), 1,
                                            0160000);
    };
    PolygonMachine machine(settings, {{kPoint, kPoint, kPoint, kPoint}});
    EXPECT_EQ(machine.run(), "no failure");
    const TurnBusStatistics& bus = machine.network.turn_buses[0]->statistics();
    EXPECT_GT(bus.waited_for[0], Duration::nanoseconds(300 * 1500));
    EXPECT_EQ(bus.waited_for[1], Duration());
    EXPECT_EQ(bus.out_of_turn, bus.waited_for[0]);
}

TEST(TurnBus, NeedsSharedParts) {
    PolygonMachineSettings settings = digesting_machine(1, 1);
    settings.tiling = {2, 1, 1, 1};
    EXPECT_THAT([&] { PolygonMachine(settings, {}); },
                testing::ThrowsMessage<std::invalid_argument>(
                    testing::HasSubstr("node/P0: has its part of the screen to itself")));
}

TEST(TurnBus, WorksInEveryPartOfAHybrid) {
    PolygonMachineSettings settings = digesting_machine(2, 2);
    settings.tiling.columns = settings.tiling.rows = 2;
    const Polygon everywhere{{{0, 0, 0, 0}, {23, 0, 0, 0}, {23, 23, 0, 0}, {0, 23, 0, 0}}};
    settings.frames = 2;
    PolygonMachine machine(settings, {std::vector<Polygon>(7, everywhere)});
    EXPECT_EQ(machine.run(), "no failure");
    EXPECT_EQ(machine.network.turn_buses.size(), 4U);
    for (const TurnBus* bus : machine.network.turn_buses) {
        EXPECT_EQ(bus->statistics().messages, 2 * (7 + 1));
    }
}

}  // namespace
}  // namespace rasterloom
