// SPDX-License-Identifier: MIT
#include "machine/kernel/simulation.hpp"

#include "machine/kernel/probe.hpp"
#include "machine/kernel/random.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom {
namespace {

using LogEntry = std::tuple<std::int64_t, std::string, int, std::uint64_t>;

// Passes tokens on to random neighbours after random, often equal, delays; writes down what reaches
// it.
class Relay final : public Component {
  public:
    Relay(int number, int ports, std::vector<LogEntry>& log)
        : Component("relay/" + std::to_string(number)),
          random_(99, static_cast<std::uint64_t>(number) + 1),
          log_(log) {
        for (int port = 0; port < ports; ++port) {
            add_port(std::to_string(port));
        }
    }
    void start() override { wake_at(Time::zero(), 0, 5); }
    void handle(const Event& event) override {
        log_.emplace_back(event.time().picoseconds(), name(), static_cast<int>(event.port),
                          event.payload);
        if (event.payload == 0) {
            return;
        }
        for (int copy = 0; copy < 2; ++copy) {
            const auto port = static_cast<PortIndex>(random_.below(ports().size()));
            send(port, 0, event.payload - 1,
                 now() + Duration::picoseconds(static_cast<std::int64_t>(random_.below(3))));
        }
    }

  private:
    Random random_;
    std::vector<LogEntry>& log_;
};

// A ring with chords, its components made and its wires laid in the given order, run up to each of
// the given limits.
std::vector<LogEntry> run_ring(const std::vector<int>& construction_order,
                               const std::vector<std::int64_t>& limits) {
    const int n = static_cast<int>(construction_order.size());
    std::vector<LogEntry> log;
    Simulation simulation;
    std::vector<Relay*> relays(construction_order.size());
    for (const int number : construction_order) {
        relays[static_cast<std::size_t>(number)] = &simulation.add<Relay>(number, 4, log);
    }
    for (const int number : construction_order) {
        for (const int step : {1, 2}) {
            simulation.connect(*relays[static_cast<std::size_t>(number)],
                               static_cast<PortIndex>(step - 1),
                               *relays[static_cast<std::size_t>((number + step) % n)],
                               static_cast<PortIndex>(step + 1), Duration::picoseconds(step));
        }
    }
    simulation.seal();
    for (const std::int64_t limit : limits) {
        simulation.run(Time::zero() + Duration::picoseconds(limit));
    }
    EXPECT_EQ(simulation.run().end, RunEnd::finished);
    return log;
}

TEST(Simulation, DoesTheSameWhateverTheOrderOfConstruction) {
    std::vector<int> order(12);
    std::iota(order.begin(), order.end(), 0);
    const std::vector<LogEntry> expected = run_ring(order, {});
    ASSERT_GT(expected.size(), 500U);
    Random random(5);
    for (int trial = 0; trial < 20; ++trial) {
        std::shuffle(order.begin(), order.end(), random);
        EXPECT_EQ(run_ring(order, {}), expected);
    }
}

TEST(Simulation, DoesTheSameWhereverItsRunIsCut) {
    std::vector<int> order(12);
    std::iota(order.begin(), order.end(), 0);
    const std::vector<LogEntry> expected = run_ring(order, {});
    EXPECT_TRUE(rc::check([&] {
        auto limits =
            *rc::gen::container<std::vector<std::int64_t>>(rc::gen::inRange<std::int64_t>(0, 20));
        std::sort(limits.begin(), limits.end());
        RC_ASSERT(run_ring(order, limits) == expected);
    }));
}

class Waiter final : public Component {
  public:
    Waiter(std::string name, std::optional<std::string> wish)
        : Component(std::move(name)), wish_(std::move(wish)) {}
    void start() override { wake_at(Time::zero() + Duration::nanoseconds(3), 0); }
    void handle(const Event&) override {}
    std::optional<std::string> waits_for() const override { return wish_; }

  private:
    std::optional<std::string> wish_;
};

TEST(Simulation, ReportsADeadlockWithEveryoneWhoWaitsAndForWhat) {
    Simulation simulation;
    simulation.add<Waiter>("node/b", "room at port 2");
    simulation.add<Waiter>("node/c", std::nullopt);
    simulation.add<Waiter>("node/a", "a message");
    simulation.seal();
    const RunResult result = simulation.run();
    EXPECT_EQ(result.end, RunEnd::failed);
    ASSERT_NE(result.failure, nullptr);
    EXPECT_EQ(result.failure->message(),
              "deadlock at 3 ns: no event is left, and 2 components wait\n"
              "  node/a waits for a message\n"
              "  node/b waits for room at port 2");
}

TEST(Simulation, StopsBeforeTheLimitAndGoesOnFromThere) {
    Simulation simulation;
    simulation.add<Waiter>("only", std::nullopt);
    simulation.seal();
    const Time at_event = Time::zero() + Duration::nanoseconds(3);
    EXPECT_EQ(simulation.run(at_event).end, RunEnd::limit);
    EXPECT_EQ(simulation.events_handled(), 0U);
    const RunResult rest = simulation.run();
    EXPECT_EQ(rest.end, RunEnd::finished);
    EXPECT_EQ(rest.time, at_event);
}

// Counts to a number, at one step a nanosecond, through the queue or without.
class Counter final : public Component {
  public:
    Counter(std::string name, bool inline_steps)
        : Component(std::move(name)), inline_steps_(inline_steps) {}
    void start() override { wake_at(Time::zero(), 0); }
    void handle(const Event&) override {
        while (++count < 100) {
            times.push_back(now());
            const Time next = now() + Duration::nanoseconds(1);
            if (!inline_steps_ || !scheduler().advance_to(own_key(next))) {
                wake_at(next, 0);
                return;
            }
        }
        scheduler().request_stop();
    }
    int count = 0;
    std::vector<Time> times;

  private:
    bool inline_steps_;
};

TEST(Simulation, LetsAComponentAdvanceWithoutTheQueueOnlyWhenNothingComesBefore) {
    Simulation simulation;
    Counter& direct = simulation.add<Counter>("a", true);
    Counter& queued = simulation.add<Counter>("b", false);
    simulation.seal();
    const Time limit = Time::zero() + Duration::nanoseconds(50);
    EXPECT_EQ(simulation.run(limit).end, RunEnd::limit);
    EXPECT_EQ(direct.times, queued.times);
    EXPECT_EQ(direct.times.back(), Time::zero() + Duration::nanoseconds(49));
    EXPECT_EQ(simulation.run().end, RunEnd::stopped);
    EXPECT_EQ(direct.count, 100);
    EXPECT_EQ(queued.count, 99);  // stopped before its turn at 99 ns
}

TEST(Probe, TellsItsListenersAndNobodyElse) {
    struct Listener {
        int heard = 0;
    };
    Probe<Listener> probe;
    probe.tell([](Listener&) { FAIL() << "nobody listens"; });
    EXPECT_FALSE(probe.observed());
    Listener first;
    Listener second;
    probe.attach(first);
    probe.attach(second);
    probe.tell([](Listener& listener) { ++listener.heard; });
    EXPECT_EQ(first.heard + second.heard, 2);
}

}  // namespace
}  // namespace rasterloom
