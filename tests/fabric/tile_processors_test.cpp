// SPDX-License-Identifier: MIT
// Software rasterizers whole: feeders with real processors, whose program does what a tiler does
// but for the drawing.
#include "machine/node/processor.hpp"
#include "tests/fabric/tile_feeder_machine.hpp"
#include "tests/node/script_program.hpp"

#include <gtest/gtest.h>

namespace rasterloom {
namespace {

using Verb = ScriptCore::Verb;

// Takes messages, works on each but the end of a frame, for which it gives its credit back and
// waits for the next phase.
Script drawing(std::uint32_t work) {
    Script s;
    s.set(2, static_cast<std::uint32_t>(TriangleMessage::end_of_frame)).set(3, kRunOver);
    s.label("next").write(port_register(PortRegister::rxaddr), 0).op(Verb::peek, 1, 0, 0);
    s.jump(Verb::jump_if_equal, "end", 1, 2).work(work).jump(Verb::jump, "next");
    s.label("end").write(node_register(NodeRegister::credit), 0177777);
    s.write(node_register(NodeRegister::waitfor), kWaitPhase);
    s.load(0, node_register(NodeRegister::phase)).jump(Verb::jump_if_equal, "over", 0, 3);
    s.jump(Verb::jump, "next");
    s.label("over").halt();
    return s;
}

struct ProcessorMachineSettings {
    TileSorterSettings sorter;
    int frames = 1;
    TileFeederSettings feeder;
    std::uint32_t most_work = 1;  // cycles for a message; the nodes differ
    bool run_ahead = true;
    std::size_t threads = 1;
};

class ProcessorMachine {
  public:
    struct Heard : NodeListener {
        void message_consumed(const MessageRecord& message) override { all.push_back(message); }
        std::vector<MessageRecord> all;
    };

    ProcessorMachine(const ProcessorMachineSettings& settings,
                     const std::vector<TileFrame>& frames) {
        const int count = settings.sorter.queues.rasterizers;
        const auto scene = scene_of(settings.sorter.queues, frames);
        sorter = &simulation.add<TileSorter>("sorter", settings.sorter);
        supervisor = &simulation.add<Supervisor>(
            "supervisor",
            Supervisor::Settings{Duration::nanoseconds(20), 1, settings.frames, count + 1});
        supervisor->connect(simulation, count, *sorter, sorter->supervisor_port());
        for (int i = 0; i < count; ++i) {
            TileFeederSettings feeding = settings.feeder;
            feeding.node = static_cast<NodeIndex>(count + i);
            auto& feeder = simulation.add<TileFeeder>(fmt::format("feeder/{}", i), feeding);
            feeder.load(scene);
            sorter->connect(simulation, i, feeder);
            feeder.connect(simulation, add_processor(i, settings), Processor::receive_port(0));
            feeders.push_back(&feeder);
        }
        sorter->load(frames);
        simulation.seal();
        simulation.use_threads(settings.threads);
        result = simulation.run();
    }

    // All that can be seen of the run.
    std::string record() const {
        std::string all = fmt::format("ended {}\n", result.time.picoseconds());
        for (const TileFrameRecord& frame : sorter->frames()) {
            all += fmt::format("{} {} {}\n", frame.began.picoseconds(), frame.sorted.picoseconds(),
                               frame.ended.picoseconds());
        }
        for (std::size_t i = 0; i < feeders.size(); ++i) {
            for (const MessageRecord& message : heard[i].all) {
                all += fmt::format("{}.{} {}: {} {} {} {}\n", message.source(), message.id,
                                   message.kind, message.queued.picoseconds(),
                                   message.started.picoseconds(), message.delivered.picoseconds(),
                                   message.consumed.picoseconds());
            }
            all += fmt::format("{} {} {}\n", feeders[i]->statistics().busy.picoseconds(),
                               feeders[i]->statistics().blocked.picoseconds(),
                               processors[i]->statistics().cycles);
        }
        return all;
    }

    Simulation simulation;
    RunResult result;
    TileSorter* sorter = nullptr;
    Supervisor* supervisor = nullptr;
    std::vector<TileFeeder*> feeders;
    std::vector<Processor*> processors;
    std::deque<Heard> heard;  // [processor]

  private:
    Processor& add_processor(int index, const ProcessorMachineSettings& settings) {
        Processor::Settings processor;
        processor.node = static_cast<NodeIndex>(index);
        processor.clock = Clock::with_period(Duration::nanoseconds(3));
        processor.ports.ports = 1;
        processor.ports.transmitting = 0;
        processor.ports.input_queue = settings.feeder.receiver_places;
        processor.run_ahead = settings.run_ahead;
        const std::uint32_t work = settings.most_work / (static_cast<std::uint32_t>(index) + 1);
        auto& added = simulation.add<Processor>(
            fmt::format("node/P{}", index), std::make_unique<ScriptCore>(drawing(work).program()),
            processor);
        added.probe().attach(heard.emplace_back());
        supervisor->connect(simulation, index, added);
        processors.push_back(&added);
        return added;
    }
};

ProcessorMachineSettings random_machine() {
    ProcessorMachineSettings settings;
    settings.sorter.queues = random_queues();
    settings.frames = *rc::gen::inRange(1, 5);
    settings.feeder.receiver_places = *rc::gen::inRange(1, 6);
    settings.feeder.time_per_word = Duration::picoseconds(*rc::gen::element(0, 1, 3000));
    settings.feeder.latency = Duration::picoseconds(*rc::gen::element(1, 1500));
    settings.most_work = *rc::gen::element(1U, 50U, 5000U);
    return settings;
}

TEST(TileProcessors, TakeEveryTileEveryTriangleAndTheEndOfEveryFrame) {
    EXPECT_TRUE(rc::check([] {
        const ProcessorMachineSettings settings = random_machine();
        const std::vector<TileFrame> frames = random_frames(settings.sorter.queues);
        const ProcessorMachine machine(settings, frames);
        RC_ASSERT(machine.result.end == RunEnd::finished);
        std::int64_t triangles = 0;
        for (std::size_t i = 0; i < machine.feeders.size(); ++i) {
            RC_ASSERT(machine.processors[i]->halted());
            const TileFeederStatistics& sent = machine.feeders[i]->statistics();
            RC_ASSERT(static_cast<std::int64_t>(machine.heard[i].all.size()) ==
                      sent.tiles + sent.triangles + settings.frames);
            triangles += sent.triangles;
        }
        RC_ASSERT(triangles == machine.sorter->statistics().pairs);
    }));
}

TEST(TileProcessors, DoTheSameOnAnyNumberOfThreadsAndWithoutRunningAhead) {
    EXPECT_TRUE(rc::check([] {
        ProcessorMachineSettings settings = random_machine();
        const std::vector<TileFrame> frames = random_frames(settings.sorter.queues);
        const std::string alone = ProcessorMachine(settings, frames).record();
        settings.threads = *rc::gen::inRange<std::size_t>(2, 5);
        const ProcessorMachine divided(settings, frames);
        RC_ASSERT(divided.simulation.partitions() > 1U);
        RC_ASSERT(divided.record() == alone);
        settings.run_ahead = false;
        RC_ASSERT(ProcessorMachine(settings, frames).record() == alone);
    }));
}

}  // namespace
}  // namespace rasterloom
