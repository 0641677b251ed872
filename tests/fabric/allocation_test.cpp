// SPDX-License-Identifier: MIT
// A machine in its steady state allocates nothing: counted by a global operator new of this
// program's own.
#include "machine/fabric/network.hpp"
#include "machine/fabric/polygon_network.hpp"
#include "machine/fabric/tile_sorter.hpp"
#include "tests/node/script_program.hpp"
#include "topologies/regular.hpp"

#include <atomic>
#include <cstdlib>
#include <memory>
#include <new>

#include <gtest/gtest.h>

namespace {
std::atomic<long> allocations{0};
}  // namespace

// Inlined, they would look to the compiler as if new and free were paired.
[[gnu::noinline]] void* operator new(std::size_t bytes) {
    ++allocations;
    if (void* memory = std::malloc(bytes)) {
        return memory;
    }
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace rasterloom {
namespace {

using Verb = ScriptCore::Verb;

// Two messages a node, of 20 to 63 bytes, which go round for ever.
Script endless_traffic() {
    Script s;
    s.send(0, 20).send(1, 20);
    s.label("loop").write(node_register(NodeRegister::waitfor), kWaitMessage);
    s.load(1, node_register(NodeRegister::rxany))
        .set(2, 0)
        .store(2, port_register(PortRegister::rxaddr), 1);
    s.op(Verb::random, 1, 0, 2).op(Verb::random, 3, 0, 44).op(Verb::add, 3, 0, 20);
    s.store(2, port_register(PortRegister::txaddr), 1)
        .store(3, port_register(PortRegister::txlen), 1);
    return s.jump(Verb::jump, "loop");
}

TEST(SteadyState, AllocatesNothing) {
    const topology::Topology ring = topology::ring(16);
    Simulation simulation;
    std::vector<Processor*> processors;
    const LinkSettings link{Duration(), Duration::nanoseconds(10), Duration::nanoseconds(50), 32};
    for (NodeIndex node = 0; node < 16; ++node) {
        Processor::Settings settings;
        settings.node = node;
        settings.clock = Clock::with_period(Duration::nanoseconds(10));
        settings.ports = {2, 32, link.input_queue, SendPolicy::one_at_a_time};
        settings.max_message = 64;
        settings.supervised = false;
        processors.push_back(&simulation.add<Processor>(
            "node/" + std::to_string(100 + node),
            std::make_unique<ScriptCore>(endless_traffic().program(), node + 1), settings));
    }
    const auto links = connect_network(simulation, ring, processors, link);
    simulation.seal();
    ASSERT_EQ(simulation.run(Time::zero() + Duration::milliseconds(20)).end, RunEnd::limit);
    const auto messages = [&] {
        std::int64_t sum = 0;
        for (const NetworkLink& one : links) {
            sum += one.link->statistics().messages;
        }
        return sum;
    };
    const std::int64_t messages_before = messages();
    const long before = allocations;
    simulation.run(Time::zero() + Duration::milliseconds(24));
    EXPECT_EQ(allocations - before, 0);
    EXPECT_GT(messages() - messages_before, 10'000);
}

// Takes whatever comes, at its own pace.
Script endless_reception(std::uint32_t work) {
    Script s;
    s.label("loop").write(port_register(PortRegister::rxaddr), 0).work(work);
    return s.jump(Verb::jump, "loop");
}

TEST(SteadyState, AllocatesNothingInThePolygonFabric) {
    const auto distribution = topology::distribute({4, 2, 2, 1}, 512, 512);
    PolygonFabricSettings settings;
    settings.supervised = false;
    settings.host_time_per_polygon = Duration::microseconds(1);
    Simulation simulation;
    std::vector<Processor*> processors;
    for (NodeIndex node = 0; node < 16; ++node) {
        Processor::Settings processor;
        processor.node = node;
        set_polygon_ports(processor, settings, distribution.grids[node]);
        processors.push_back(&simulation.add<Processor>(
            "node/P" + std::to_string(node),
            std::make_unique<ScriptCore>(endless_reception(node + 1).program(), 1, 0160000),
            processor));
    }
    const PolygonNetwork network =
        connect_polygon_network(simulation, distribution, processors, settings);
    simulation.seal();
    // Every third one goes everywhere, the others to one part.
    std::vector<Polygon> frame(30'000, Polygon{{{0, 0, 0, 0}, {511, 0, 0, 0}, {511, 511, 0, 0}}});
    for (std::size_t i = 0; i < frame.size(); ++i) {
        if (i % 3 != 0) {
            frame[i].vertices.assign(10, {static_cast<std::int16_t>(i % 512), 300, 0, 0});
        }
    }
    network.source->load({frame});
    ASSERT_EQ(simulation.run(Time::zero() + Duration::milliseconds(40)).end, RunEnd::limit);
    const std::int64_t sent_before = network.source->statistics().polygons;
    const long before = allocations;
    ASSERT_EQ(simulation.run(Time::zero() + Duration::milliseconds(60)).end, RunEnd::limit);
    EXPECT_EQ(allocations - before, 0);
    EXPECT_GT(network.source->statistics().polygons - sent_before, 1'000);
}

TEST(SteadyState, AllocatesNothingInTheTileFeeders) {
    TileSorterSettings sorting;
    sorting.queues = {TileAssignment::next_free, 128, 96, 4, 0};
    sorting.supervised = false;
    TileFeederSettings feeding;
    feeding.time_per_word = Duration::nanoseconds(50);
    auto scene = std::make_shared<TileScene>();
    scene->tiles = {1024, 768, {8, 8}};
    scene->frames[0].resize(1000);
    TileFrame frame{1000, {}};
    for (TileIndex i = 0; i < 50'000; ++i) {
        frame.pairs.push_back({i % scene->tiles.tiles(), i % 1000, 1});
    }
    Simulation simulation;
    auto& sorter = simulation.add<TileSorter>("sorter", sorting);
    std::vector<TileFeeder*> feeders;
    for (int i = 0; i < sorting.queues.rasterizers; ++i) {
        Processor::Settings processor;
        processor.ports = {1, 1, feeding.receiver_places, SendPolicy::one_at_a_time};
        processor.ports.transmitting = 0;
        processor.supervised = false;
        auto& node = simulation.add<Processor>(
            "node/P" + std::to_string(i),
            std::make_unique<ScriptCore>(
                endless_reception(static_cast<std::uint32_t>(i)).program()),
            processor);
        feeders.push_back(&simulation.add<TileFeeder>("feeder/" + std::to_string(i), feeding));
        feeders.back()->load(scene);
        feeders.back()->connect(simulation, node, Processor::receive_port(0));
        sorter.connect(simulation, i, *feeders.back());
    }
    sorter.load({frame});
    simulation.seal();
    const auto sent = [&] {
        std::int64_t sum = 0;
        for (const TileFeeder* feeder : feeders) {
            sum += feeder->statistics().triangles;
        }
        return sum;
    };
    ASSERT_EQ(simulation.run(Time::zero() + Duration::milliseconds(10)).end, RunEnd::limit);
    const std::int64_t sent_before = sent();
    const long before = allocations;
    ASSERT_EQ(simulation.run(Time::zero() + Duration::milliseconds(20)).end, RunEnd::limit);
    EXPECT_EQ(allocations - before, 0);
    EXPECT_GT(sent() - sent_before, 5'000);
}

}  // namespace
}  // namespace rasterloom
