// SPDX-License-Identifier: MIT
#include "machine/node/message_ports.hpp"

#include <array>
#include <stdexcept>

#include <gtest/gtest.h>

namespace rasterloom {
namespace {

constexpr std::array<std::uint8_t, 3> kBytes = {1, 2, 3};

Time at(std::int64_t ns) {
    return Time::zero() + Duration::nanoseconds(ns);
}

MessagePorts make_ports(SendPolicy send) {
    return {7, {.ports = 3, .output_queue = 2, .input_queue = 2, .send = send}};
}

TEST(MessagePorts, SendOneAtATimeTheOldestFirst) {
    MessagePorts ports = make_ports(SendPolicy::one_at_a_time);
    ports.enqueue(2, kBytes, at(1));
    ports.enqueue(0, kBytes, at(2));
    ports.enqueue(1, kBytes, at(3));
    for (const int expected : {2, 0, 1}) {
        const auto transmission = ports.next_transmission(at(4));
        ASSERT_TRUE(transmission.has_value());
        EXPECT_EQ(transmission->port, expected);
        EXPECT_FALSE(ports.next_transmission(at(4)).has_value());
        ports.transfer_done(expected, true, at(5));
    }
    EXPECT_FALSE(ports.next_transmission(at(6)).has_value());
}

TEST(MessagePorts, SendSideBySideWithEachPort) {
    MessagePorts ports = make_ports(SendPolicy::each_port);
    ports.enqueue(2, kBytes, at(1));
    ports.enqueue(0, kBytes, at(2));
    EXPECT_EQ(ports.next_transmission(at(3))->port, 2);
    EXPECT_EQ(ports.next_transmission(at(3))->port, 0);
    EXPECT_FALSE(ports.next_transmission(at(3)).has_value());
}

TEST(MessagePorts, PassOverAPortWhoseLinkIsNotReadyAndBookTheTimeItIsBlocked) {
    MessagePorts ports = make_ports(SendPolicy::one_at_a_time);
    ports.enqueue(0, kBytes, at(0));
    ports.enqueue(0, kBytes, at(0));
    ports.enqueue(1, kBytes, at(0));
    EXPECT_FALSE(ports.has_room(0));
    EXPECT_EQ(ports.next_transmission(at(0))->port, 0);
    ports.transfer_done(0, false, at(10));
    EXPECT_TRUE(ports.has_room(0));
    EXPECT_EQ(ports.next_transmission(at(10))->port, 1);
    ports.transfer_done(1, true, at(20));
    EXPECT_FALSE(ports.next_transmission(at(20)).has_value());
    ports.link_ready(0, at(25));
    EXPECT_EQ(ports.next_transmission(at(25))->port, 0);
    EXPECT_EQ(ports.statistics(0).blocked, Duration::nanoseconds(15));
    EXPECT_EQ(ports.statistics(1).blocked, Duration());
    EXPECT_EQ(ports.statistics(0).messages_sent, 2);
    EXPECT_EQ(ports.statistics(0).bytes_sent, 6);
    EXPECT_EQ(ports.statistics(0).peak_output_queue, 2);
}

TEST(MessagePorts, FindTheMessageThatHasWaitedLongestThenTheLowestPort) {
    MessagePorts ports = make_ports(SendPolicy::each_port);
    Message early;
    Message tied;
    Message late;
    EXPECT_FALSE(ports.longest_waiting().has_value());
    EXPECT_TRUE(ports.deliver(2, &early, at(1)));
    EXPECT_TRUE(ports.deliver(1, &tied, at(1)));
    EXPECT_TRUE(ports.deliver(0, &late, at(2)));
    for (const int expected : {1, 2, 0}) {
        EXPECT_EQ(ports.longest_waiting(), expected);
        ports.consume_oldest(expected, at(3));
    }
    EXPECT_FALSE(ports.any_waiting());
}

TEST(MessagePorts, RefuseMoreThanTheInputQueueHolds) {
    MessagePorts ports = make_ports(SendPolicy::each_port);
    std::array<Message, 3> messages;
    EXPECT_TRUE(ports.deliver(0, &messages[0], at(1)));
    EXPECT_TRUE(ports.deliver(0, &messages[1], at(1)));
    EXPECT_FALSE(ports.deliver(0, &messages[2], at(1)));
}

TEST(MessagePorts, CountAPlaceAsTakenUntilItsMessageIsConsumed) {
    MessagePorts ports = make_ports(SendPolicy::each_port);
    std::array<Message, 4> messages;
    EXPECT_TRUE(ports.deliver(0, &messages[0], at(1)));
    ports.consume_oldest(0, at(10));  // by a processor that is ahead
    EXPECT_EQ(ports.waiting(0), 0);
    EXPECT_TRUE(ports.deliver(0, &messages[1], at(5)));
    EXPECT_EQ(&ports.oldest(0), &messages[1]);
    EXPECT_FALSE(ports.deliver(0, &messages[2], at(10)));  // messages come before work
    EXPECT_TRUE(ports.deliver(0, &messages[2], at(11)));
    EXPECT_EQ(ports.waiting(0), 2);
    EXPECT_EQ(ports.statistics(0).peak_input_queue, 2);
}

TEST(MessagePorts, RefuseSettingsOutOfRange) {
    EXPECT_THROW(MessagePorts(0, {.ports = 17}), std::invalid_argument);
    EXPECT_THROW(MessagePorts(0, {.ports = 1, .output_queue = 0}), std::invalid_argument);
    EXPECT_THROW(MessagePorts(0, {.ports = 1, .input_queue = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace rasterloom
