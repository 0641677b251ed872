// SPDX-License-Identifier: MIT
// Arrivals that wait until their target looks.
#include "machine/kernel/simulation.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom {
namespace {

using testing::ElementsAre;

Duration ns(std::int64_t count) {
    return Duration::nanoseconds(count);
}

// Sends payloads 1, 2, ... at the given times, all of them at its first event.
class Sender final : public Component {
  public:
    Sender(std::string name, std::vector<std::int64_t> departures)
        : Component(std::move(name)), departures_(std::move(departures)) {
        add_port("out");
    }
    void start() override { wake_at(Time::zero(), 0); }
    void handle(const Event&) override {
        std::uint64_t payload = 0;
        for (const std::int64_t departure : departures_) {
            send(PortIndex{0}, 0, ++payload, Time::zero() + ns(departure));
        }
    }

  private:
    std::vector<std::int64_t> departures_;
};

// Looks at port 0 at the given times, and may await the next arrival at one of them.
class Looker final : public Component {
  public:
    Looker(std::vector<std::int64_t> looks, std::int64_t awaits_at)
        : Component("looker"), looks_(std::move(looks)), awaits_at_(awaits_at) {
        add_port("in");
        keep_arrivals(PortIndex{0});
    }
    void start() override {
        for (const std::int64_t look : looks_) {
            wake_at(Time::zero() + ns(look), 0);
        }
    }
    void handle(const Event& event) override {
        const std::int64_t at = now().picoseconds() / 1000;
        if (event.phase() == EventPhase::arrival) {
            log.push_back("handed " + std::to_string(event.payload) + " at " + std::to_string(at));
            return;
        }
        while (const auto kept = take_kept(PortIndex{0})) {
            log.push_back("took " + std::to_string(kept->payload) + " at " + std::to_string(at));
        }
        if (at == awaits_at_) {
            await_arrival(PortIndex{0});
        }
    }

    std::vector<std::string> log;

  private:
    std::vector<std::int64_t> looks_;
    std::int64_t awaits_at_;
};

std::vector<std::string> log_of(std::vector<std::int64_t> departures,
                                std::vector<std::int64_t> looks, std::int64_t awaits_at,
                                std::size_t threads) {
    Simulation simulation;
    auto& sender = simulation.add<Sender>("sender", std::move(departures));
    auto& looker = simulation.add<Looker>(std::move(looks), awaits_at);
    simulation.connect(sender, PortIndex{0}, looker, PortIndex{0}, ns(1));
    simulation.seal();
    simulation.use_threads(threads);
    EXPECT_EQ(simulation.run().end, RunEnd::finished);
    return looker.log;
}

constexpr std::int64_t kNever = -1;

class KeptArrivals : public testing::TestWithParam<std::size_t> {};

TEST_P(KeptArrivals, AreTakenWhenTheyHaveComeAndNotEarlier) {
    EXPECT_THAT(
        log_of({4, 9, 14}, {7, 15}, kNever, GetParam()),
        ElementsAre("took 1 at 7", "took 2 at 15", "took 3 at 15"));  // what arrives comes first
}

TEST_P(KeptArrivals, AreHandedOverInTheirTimeOnceAwaited) {
    EXPECT_THAT(log_of({4, 9, 14}, {7, 30}, 7, GetParam()),
                ElementsAre("took 1 at 7", "handed 2 at 10", "took 3 at 30"));
}

TEST_P(KeptArrivals, MayBeAwaitedBeforeTheyAreSent) {
    EXPECT_THAT(log_of({0, 2}, {0, 9}, 0, GetParam()), ElementsAre("handed 1 at 1", "took 2 at 9"));
}

TEST_P(KeptArrivals, CostNoEvent) {
    Simulation simulation;
    auto& sender = simulation.add<Sender>("sender", std::vector<std::int64_t>(100, 5));
    auto& looker = simulation.add<Looker>(std::vector<std::int64_t>{50}, kNever);
    simulation.connect(sender, PortIndex{0}, looker, PortIndex{0}, ns(1));
    simulation.seal();
    simulation.use_threads(GetParam());
    simulation.run();
    EXPECT_EQ(looker.log.size(), 100U);
    EXPECT_EQ(simulation.events_handled(), 2U);
}

INSTANTIATE_TEST_SUITE_P(Threads, KeptArrivals, testing::Values(1, 2));

}  // namespace
}  // namespace rasterloom
