// SPDX-License-Identifier: MIT
// Machines wired wrongly: each ends with a message that names the component and the port.
#include "machine/kernel/simulation.hpp"

#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom {
namespace {

using testing::HasSubstr;

class Box final : public Component {
  public:
    explicit Box(std::string name, int ports = 1) : Component(std::move(name)) {
        for (int port = 0; port < ports; ++port) {
            add_port("side " + std::to_string(port));
        }
    }
    using Component::add_port;
    using Component::wake_at;
    void handle(const Event& event) override {
        if (on_event) {
            on_event(event);
        }
    }
    std::function<void(const Event&)> on_event;
};

template <class Error, class Action>
std::string message_of(Action&& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

constexpr PortIndex kFirst{};

TEST(Wiring, RefusesAPortThatDoesNotExist) {
    Simulation simulation;
    Box& a = simulation.add<Box>("left");
    Box& b = simulation.add<Box>("right");
    EXPECT_THAT(message_of<WiringError>([&] {
                    simulation.connect(a, kFirst, b, static_cast<PortIndex>(4), Duration::tick());
                }),
                HasSubstr("right port 4: it has 1 ports"));
}

TEST(Wiring, RefusesASecondWireAtAPort) {
    Simulation simulation;
    Box& a = simulation.add<Box>("left");
    Box& b = simulation.add<Box>("right");
    Box& c = simulation.add<Box>("third");
    simulation.connect(a, kFirst, b, kFirst, Duration::tick());
    EXPECT_THAT(message_of<WiringError>(
                    [&] { simulation.connect(c, kFirst, b, kFirst, Duration::tick()); }),
                HasSubstr("right port 0 (side 0): it has a wire already"));
}

TEST(Wiring, RefusesAWireWithoutLatencyOrWithOneEnd) {
    Simulation simulation;
    Box& a = simulation.add<Box>("left");
    Box& b = simulation.add<Box>("right");
    EXPECT_THAT(
        message_of<WiringError>([&] { simulation.connect(a, kFirst, b, kFirst, Duration()); }),
        HasSubstr("the latency is at least 1 ps, not 0 ps"));
    EXPECT_THAT(message_of<WiringError>(
                    [&] { simulation.connect(a, kFirst, a, kFirst, Duration::tick()); }),
                HasSubstr("a wire has two ends"));
}

TEST(Wiring, RefusesToSealWithAnOpenPort) {
    Simulation simulation;
    simulation.add<Box>("lonely", 2);
    EXPECT_THAT(message_of<WiringError>([&] { simulation.seal(); }),
                HasSubstr("lonely port 0 (side 0) has no wire"));
}

TEST(Wiring, RefusesTwoComponentsOfOneName) {
    Simulation simulation;
    simulation.add<Box>("twin", 0);
    simulation.add<Box>("single", 0);
    simulation.add<Box>("twin", 0);
    EXPECT_THAT(message_of<WiringError>([&] { simulation.seal(); }),
                HasSubstr("two components are named twin"));
}

TEST(Wiring, RefusesAWireOutOfTheMachine) {
    Simulation simulation;
    Box& inside = simulation.add<Box>("inside");
    Box outside("outside");
    simulation.connect(inside, kFirst, outside, kFirst, Duration::tick());
    EXPECT_THAT(message_of<WiringError>([&] { simulation.seal(); }),
                HasSubstr("inside is wired to outside, which is not part of the machine"));
}

TEST(Wiring, RefusesChangesOnceSealedAndARunBefore) {
    Simulation simulation;
    Box& box = simulation.add<Box>("box", 0);
    EXPECT_THAT(message_of<WiringError>([&] { simulation.run(); }), HasSubstr("not sealed yet"));
    simulation.seal();
    EXPECT_THAT(message_of<WiringError>([&] { simulation.add<Box>("late"); }),
                HasSubstr("add component late: the machine is sealed already"));
    EXPECT_THAT(message_of<WiringError>([&] { box.add_port("late"); }),
                HasSubstr("box: port late"));
    EXPECT_THAT(message_of<WiringError>([&] { simulation.seal(); }), HasSubstr("sealed already"));
}

TEST(Wiring, StopsAtAnEventSentIntoThePast) {
    Simulation simulation;
    Box& box = simulation.add<Box>("time traveller", 0);
    simulation.seal();
    simulation.run();
    box.wake_at(Time::zero() + Duration::nanoseconds(2), 0);
    box.on_event = [&](const Event&) { box.wake_at(Time::zero() + Duration::nanoseconds(1), 0); };
    EXPECT_THAT(message_of<InvariantError>([&] { simulation.run(); }),
                HasSubstr("at 2 ns, time traveller: sends an event to time traveller for 1 ns"));
}

}  // namespace
}  // namespace rasterloom
