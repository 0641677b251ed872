// SPDX-License-Identifier: MIT
// The kernel's speed in events a second.
//
// PHOLD: 1024 components, 1024 events pending; an event begets one, a quarter of the time on
// another component (one of 64 neighbours), after a lookahead of 0.1 of the mean delay and an
// exponential rest. The same draws drive a bare std::priority_queue, the floor of what a kernel
// built on it could reach: no component is called. Torus: messages run round a 22 x 22 torus of
// components that only pass them on.
#include "machine/kernel/random.hpp"
#include "machine/kernel/simulation.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <queue>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace rasterloom {
namespace {

constexpr int kComponents = 1024;
constexpr int kNeighbours = 64;
constexpr std::int64_t kMean = 1'000'000;  // ps
constexpr std::int64_t kLookahead = kMean / 10;

class Exponential {
  public:
    Exponential() {
        for (std::size_t i = 0; i < table_.size(); ++i) {
            const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(table_.size());
            table_[i] = static_cast<std::int64_t>(-std::log(u) * (kMean - kLookahead));
        }
    }
    // Takes bits 0 to 11 of a random number.
    Duration operator()(std::uint64_t random) const {
        return Duration::picoseconds(table_[random & 0xfffU]);
    }

  private:
    std::array<std::int64_t, 4096> table_;
};

class PholdComponent final : public Component {
  public:
    PholdComponent(int number, const Exponential& exponential)
        : Component("phold/" + std::to_string(100'000 + number)),
          random_(1, static_cast<std::uint64_t>(number) + 1),
          exponential_(exponential) {
        for (int port = 0; port < kNeighbours; ++port) {
            add_port("");
        }
    }
    void start() override { wake_at(Time::zero() + exponential_(random_()), 0); }
    void handle(const Event&) override {
        const std::uint64_t random = random_();
        const Time departure = now() + exponential_(random);
        if ((random >> 12U & 3U) == 0) {
            send(static_cast<PortIndex>(random >> 14U & (kNeighbours - 1)), 0, 0, departure);
        } else {
            wake_at(departure + Duration::picoseconds(kLookahead), 0);
        }
    }

  private:
    Random random_;
    const Exponential& exponential_;
};

void phold(benchmark::State& state) {
    const Exponential exponential;
    Simulation simulation;
    std::vector<PholdComponent*> components;
    for (int i = 0; i < kComponents; ++i) {
        components.push_back(&simulation.add<PholdComponent>(i, exponential));
    }
    for (int i = 0; i < kComponents; ++i) {
        for (int k = 0; k < kNeighbours / 2; ++k) {
            const int other = (i + 1 + k * 16) % kComponents;
            simulation.connect(*components[static_cast<std::size_t>(i)], static_cast<PortIndex>(k),
                               *components[static_cast<std::size_t>(other)],
                               static_cast<PortIndex>(kNeighbours / 2 + k),
                               Duration::picoseconds(kLookahead));
        }
    }
    simulation.seal();
    Time limit = Time::zero() + Duration::picoseconds(10 * kMean);
    simulation.run(limit);
    const std::uint64_t before = simulation.events_handled();
    for (auto _ : state) {
        limit += Duration::picoseconds(100 * kMean);
        simulation.run(limit);
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(simulation.events_handled() - before));
}
BENCHMARK(phold)->Unit(benchmark::kMillisecond);

struct Later {
    bool operator()(const Event& a, const Event& b) const { return happens_before(b, a); }
};

void phold_on_bare_priority_queue(benchmark::State& state) {
    const Exponential exponential;
    Random random(1);
    std::priority_queue<Event, std::vector<Event>, Later> queue;
    const auto event = [](Time time, std::uint64_t target, std::uint32_t sequence) {
        const auto id = static_cast<ComponentId>(target % kComponents);
        return Event{make_event_key(time, EventPhase::work, id, id), sequence, 0, PortIndex{}, 0};
    };
    std::uint32_t sequence = 0;
    for (int i = 0; i < kComponents; ++i) {
        queue.push(
            event(Time::zero() + exponential(random()), static_cast<std::uint64_t>(i), sequence++));
    }
    for (auto _ : state) {
        for (int i = 0; i < 100 * kComponents; ++i) {
            const Time now = queue.top().time();
            queue.pop();
            const std::uint64_t drawn = random();
            queue.push(event(now + Duration::picoseconds(kLookahead) + exponential(drawn),
                             drawn >> 14U, sequence++));
        }
    }
    state.SetItemsProcessed(state.iterations() * 100 * kComponents);
}
BENCHMARK(phold_on_bare_priority_queue)->Unit(benchmark::kMillisecond);

constexpr int kSide = 22;

class TorusComponent final : public Component {
  public:
    explicit TorusComponent(int number)
        : Component("torus/" + std::to_string(100'000 + number)),
          random_(2, static_cast<std::uint64_t>(number) + 1) {
        for (const char* side : {"right", "down", "left", "up"}) {
            add_port(side);
        }
    }
    void start() override {
        for (std::uint16_t port = 0; port < 4; ++port) {
            send(PortIndex{port}, 0, 0,
                 Time::zero() +
                     Duration::picoseconds(static_cast<std::int64_t>(random_.below(1000))));
        }
    }
    // Straight on: out at the side opposite to the one it came in by.
    void handle(const Event& event) override {
        send(static_cast<PortIndex>((static_cast<unsigned>(event.port) + 2U) % 4U), 0,
             event.payload, now());
    }

  private:
    Random random_;
};

void torus_hops(benchmark::State& state) {
    Simulation simulation;
    std::vector<TorusComponent*> components;
    for (int i = 0; i < kSide * kSide; ++i) {
        components.push_back(&simulation.add<TorusComponent>(i));
    }
    const auto at = [&](int x, int y) -> TorusComponent& {
        return *components[static_cast<std::size_t>(y % kSide * kSide + x % kSide)];
    };
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            simulation.connect(at(x, y), PortIndex{0}, at(x + 1, y), PortIndex{2},
                               Duration::nanoseconds(1));
            simulation.connect(at(x, y), PortIndex{1}, at(x, y + 1), PortIndex{3},
                               Duration::nanoseconds(1));
        }
    }
    simulation.seal();
    Time limit = Time::zero() + Duration::nanoseconds(10);
    simulation.run(limit);
    const std::uint64_t before = simulation.events_handled();
    for (auto _ : state) {
        limit += Duration::nanoseconds(100);
        simulation.run(limit);
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(simulation.events_handled() - before));
}
BENCHMARK(torus_hops)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rasterloom
