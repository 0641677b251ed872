// SPDX-License-Identifier: MIT
// A simulation on several threads does what it does on one.
#include "machine/kernel/random.hpp"
#include "machine/kernel/simulation.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom {
namespace {

// Time, port, payload.
using Entry = std::tuple<std::int64_t, int, std::uint64_t>;
using Log = std::vector<Entry>;

struct Network {
    int components = 2;
    std::uint64_t seed = 1;
    std::int64_t longest_wire = 8;  // ps
    std::int64_t delay = 0;         // promised at every port
    bool works = false;             // put private work off between events
    int fails_at = -1;              // this component's n-th event
};

// Passes tokens on to random neighbours after random, often equal, delays. Between events it may
// have private work: a stretch that ends in an event of its own, which cannot be foreseen.
class Station final : public Component {
  public:
    Station(int number, const Network& network, bool stands_apart)
        : Component("station/" + std::to_string(100 + number)),
          random_(network.seed, static_cast<std::uint64_t>(number) + 1),
          network_(network),
          stands_apart_(stands_apart) {}

    PortIndex plug() {
        const PortIndex port = add_port(std::to_string(ports().size()));
        promise_delay(port, Duration::picoseconds(network_.delay));
        return port;
    }
    void start() override { wake_at(Time::zero(), 0, 5); }
    bool stands_apart() const override { return stands_apart_; }

    void handle(const Event& event) override {
        finish();
        log.emplace_back(now().picoseconds(), static_cast<int>(event.port), event.payload);
        if (static_cast<int>(log.size()) == network_.fails_at) {
            scheduler().fail(std::make_shared<Deadlock>(now(), std::vector<Deadlock::Waiter>{
                                                                   {name(), "nothing"}}));
            return;
        }
        if (event.payload == 0 || ports().empty()) {
            return;
        }
        if (network_.works && random_.below(2) == 0) {
            begin_stretch(event.payload - 1);
        } else {
            pass_on(event.payload - 1);
        }
    }

    void work_ahead(bool to_the_end) override {
        if (to_the_end) {
            finish();
        } else if (std::exchange(put_off_, false)) {
            work();
        }
    }

    Log log;

  private:
    void pass_on(std::uint64_t payload) {
        for (int copy = 0; copy < 2; ++copy) {
            const auto port = static_cast<PortIndex>(random_.below(ports().size()));
            send(port, 0, payload,
                 now() + Duration::picoseconds(
                             network_.delay + static_cast<std::int64_t>(random_.below(3))));
        }
    }
    void begin_stretch(std::uint64_t payload) {
        position_ = now();
        payload_ = payload;
        steps_ = static_cast<int>(random_.below(40));
        if (scheduler().puts_work_off()) {
            put_off();
        } else {
            finish_steps();
        }
    }
    void put_off() {
        put_off_ = true;
        scheduler().put_off(own_key(position_));
    }
    void step() {
        position_ += Duration::picoseconds(static_cast<std::int64_t>(random_.below(4)));
        --steps_;
    }
    void finish_steps() {
        while (steps_ > 0) {
            step();
        }
        wake_at(position_, 0, payload_);
    }
    void work() {
        for (int part = 0; part < 8 && steps_ > 0; ++part) {
            step();
        }
        if (steps_ > 0) {
            put_off();
        } else {
            wake_at(position_, 0, payload_);
        }
    }
    // An event may draw random numbers: all private work goes before it.
    void finish() {
        if (std::exchange(put_off_, false)) {
            finish_steps();
        }
    }

    Random random_;
    Network network_;
    bool stands_apart_;
    bool put_off_ = false;
    Time position_;
    std::uint64_t payload_ = 0;
    int steps_ = 0;
};

struct Outcome {
    std::vector<Log> logs;  // by component
    RunEnd end = RunEnd::finished;
    Time time;
    std::string failure;

    friend bool operator==(const Outcome&, const Outcome&) = default;
};

std::vector<Station*> build(Simulation& simulation, const Network& network) {
    std::vector<Station*> stations;
    for (int i = 0; i < network.components; ++i) {
        stations.push_back(&simulation.add<Station>(i, network, i == 0));
    }
    Random random(network.seed, 1000);
    const auto count = static_cast<std::uint64_t>(network.components);
    for (int wire = 0; wire < 3 * network.components; ++wire) {
        Station& a = *stations[random.below(count)];
        Station& b = *stations[random.below(count)];
        const auto latency = static_cast<std::int64_t>(
            1 + random.below(static_cast<std::uint64_t>(network.longest_wire)));
        const PortIndex port = a.plug();
        simulation.connect(a, port, b, b.plug(), Duration::picoseconds(latency));
    }
    simulation.seal();
    return stations;
}

Outcome run(const Network& network, std::size_t threads, std::vector<std::int64_t> limits = {}) {
    Simulation simulation;
    const std::vector<Station*> stations = build(simulation, network);
    simulation.use_threads(threads);
    for (const std::int64_t limit : limits) {
        simulation.run(Time::zero() + Duration::picoseconds(limit));
    }
    const RunResult result = simulation.run();
    Outcome outcome;
    for (const Station* station : stations) {
        outcome.logs.push_back(station->log);
    }
    outcome.end = result.end;
    outcome.time = result.time;
    outcome.failure = result.failure == nullptr ? "" : result.failure->message();
    return outcome;
}

Network any_network() {
    Network network;
    network.components = *rc::gen::inRange(1, 20);
    network.seed = *rc::gen::inRange<std::uint64_t>(1, 1'000'000);
    network.longest_wire = *rc::gen::inRange<std::int64_t>(1, 30);
    network.delay = *rc::gen::element<std::int64_t>(0, 0, 1, 7);
    network.works = *rc::gen::arbitrary<bool>();
    return network;
}

TEST(Threads, DoWhatOneThreadDoes) {
    EXPECT_TRUE(rc::check([] {
        const Network network = any_network();
        const Outcome expected = run(network, 1);
        for (const std::size_t threads : {2U, 3U, 4U, 7U}) {
            RC_ASSERT(run(network, threads) == expected);
        }
    }));
}

TEST(Threads, DoTheSameWhereverTheRunIsCut) {
    EXPECT_TRUE(rc::check([] {
        const Network network = any_network();
        auto limits =
            *rc::gen::container<std::vector<std::int64_t>>(rc::gen::inRange<std::int64_t>(0, 60));
        std::sort(limits.begin(), limits.end());
        RC_ASSERT(run(network, 3, limits) == run(network, 1));
    }));
}

TEST(Threads, FailWhereOneThreadFails) {
    EXPECT_TRUE(rc::check([] {
        Network network = any_network();
        network.fails_at = *rc::gen::inRange(1, 12);
        const Outcome expected = run(network, 1);
        for (const std::size_t threads : {2U, 3U}) {
            const Outcome found = run(network, threads);
            RC_ASSERT(found.end == expected.end);
            RC_ASSERT(found.time == expected.time);
            RC_ASSERT(found.failure == expected.failure);
        }
    }));
}

TEST(Threads, AreNotWantedBeforeTheMachineIsSealedNorOnceItRuns) {
    Network network;
    Simulation simulation;
    EXPECT_THROW(simulation.use_threads(2), WiringError);
    build(simulation, network);
    EXPECT_THROW(simulation.use_threads(0), WiringError);
    simulation.use_threads(2);
    EXPECT_THROW(simulation.use_threads(2), WiringError);
    Simulation started;
    build(started, network);
    started.run();
    EXPECT_THROW(started.use_threads(2), WiringError);
}

// Two of these call each other for ever.
class Caller final : public Component {
  public:
    enum class Deed { none, stop, pause, wait, throws, early };
    Caller(std::string name, Deed deed, int when)
        : Component(std::move(name)), deed_(deed), when_(when) {
        promise_delay(add_port("peer"), Duration::nanoseconds(1));
    }
    void start() override { wake_at(Time::zero(), 0); }
    void handle(const Event&) override {
        times.push_back(now());
        const bool now_is_when = static_cast<int>(times.size()) == when_;
        if (now_is_when && deed_ == Deed::wait) {
            return;
        }
        if (now_is_when) {
            act();
        }
        const bool early = now_is_when && deed_ == Deed::early;
        send(PortIndex{0}, 0, 0, now() + (early ? Duration() : Duration::nanoseconds(1)));
    }
    std::optional<std::string> waits_for() const override {
        return deed_ == Deed::wait ? std::optional<std::string>("an answer") : std::nullopt;
    }
    int weight() const override { return 100; }

    std::vector<Time> times;

  private:
    void act() {
        if (deed_ == Deed::stop) {
            scheduler().request_stop();
        } else if (deed_ == Deed::pause) {
            scheduler().pause_before(now() + Duration::nanoseconds(2));
        } else if (deed_ == Deed::throws) {
            throw std::runtime_error("broken");
        }
    }

    Deed deed_;
    int when_;
};

struct Couple {
    explicit Couple(Caller::Deed deed, int when = 10, Caller::Deed other = Caller::Deed::none) {
        a = &simulation.add<Caller>("a", deed, when);
        b = &simulation.add<Caller>("b", other, when);
        simulation.connect(*a, PortIndex{0}, *b, PortIndex{0}, Duration::nanoseconds(1));
        simulation.seal();
        simulation.use_threads(2);
    }
    Simulation simulation;
    Caller* a;
    Caller* b;
};

Time at_ns(std::int64_t nanoseconds) {
    return Time::zero() + Duration::nanoseconds(nanoseconds);
}

TEST(Threads, StopWhenAComponentAsks) {
    Couple couple(Caller::Deed::stop);
    const RunResult result = couple.simulation.run();
    EXPECT_EQ(result.end, RunEnd::stopped);
    EXPECT_EQ(result.time, at_ns(18));
    EXPECT_EQ(couple.a->times.size(), 10U);
}

TEST(Threads, PauseAndGoOn) {
    Couple couple(Caller::Deed::pause);
    const RunResult pause = couple.simulation.run(at_ns(1000));
    EXPECT_EQ(pause.end, RunEnd::paused);
    EXPECT_EQ(pause.time, at_ns(20));
    EXPECT_EQ(couple.a->times.back(), at_ns(18));
    EXPECT_EQ(couple.b->times.back(), at_ns(18));
    const RunResult rest = couple.simulation.run(at_ns(30));
    EXPECT_EQ(rest.end, RunEnd::limit);
    EXPECT_EQ(couple.b->times.back(), at_ns(28));
}

TEST(Threads, ReportADeadlock) {
    Couple couple(Caller::Deed::wait, 3, Caller::Deed::wait);
    const RunResult result = couple.simulation.run();
    ASSERT_EQ(result.end, RunEnd::failed);
    EXPECT_EQ(result.failure->message(),
              "deadlock at 4 ns: no event is left, and 2 components wait\n"
              "  a waits for an answer\n  b waits for an answer");
}

TEST(Threads, PassOnWhatAComponentThrows) {
    Couple couple(Caller::Deed::throws);
    EXPECT_THROW(couple.simulation.run(), std::runtime_error);
}

TEST(Threads, HoldAComponentToTheDelayItPromised) {
    Couple couple(Caller::Deed::early);
    EXPECT_THROW(couple.simulation.run(), InvariantError);
}

}  // namespace
}  // namespace rasterloom
