// SPDX-License-Identifier: MIT
#include "machine/observe/phase_log.hpp"

#include "tests/observe/small_run.hpp"

#include <map>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom::observe {
namespace {

MessageRecord message(NodeIndex source, int hops, std::int64_t started_us) {
    MessageRecord record;
    record.id = std::uint64_t{source} << 32U;
    record.bytes = 10;
    record.hops = static_cast<std::uint8_t>(hops);
    record.started = at_us(started_us);
    record.delivered = at_us(started_us + 100);
    record.consumed = record.delivered;
    return record;
}

PhaseRecord phase(int frame, int number, std::int64_t began_us, std::int64_t ended_us) {
    return {.number = 0,
            .frame = frame,
            .phase = number,
            .began = at_us(began_us),
            .ended = at_us(ended_us)};
}

TEST(PhaseLog, SumsUpMessagesByPhaseAndFrame) {
    PhaseLog log(std::nullopt);
    log.message_consumed(message(0, 0, 5));
    log.message_consumed(message(0, 3, 6));
    log.phase_ended(phase(0, 0, 0, 100));
    log.phase_ended(phase(0, 1, 101, 150));
    log.frame_ended(0, at_us(150));
    log.message_consumed(message(1, 0, 160));
    log.phase_ended(phase(1, 0, 151, 300));
    EXPECT_EQ(log.frame_ends(), std::vector<Time>{at_us(150)});
    const auto phases = log.finish(at_us(300));
    ASSERT_EQ(phases.size(), 3U);
    EXPECT_EQ(phases[0].messages, 2);
    EXPECT_EQ(phases[0].bytes, 20);
    EXPECT_EQ(phases[0].longest_route, 4);
    EXPECT_FALSE(phases[0].rounds.has_value());
    EXPECT_EQ(phases[1].start, at_us(101));
    EXPECT_EQ(phases[1].messages, 0);
    EXPECT_EQ(phases[2].frame, 1);
    EXPECT_EQ(phases[2].messages, 1);
    EXPECT_EQ(phases[2].end, at_us(300));
}

TEST(PhaseLog, TakesARunWithoutSupervisorAsOnePhase) {
    PhaseLog log(std::nullopt);
    const auto phases = log.finish(at_us(7));
    ASSERT_EQ(phases.size(), 1U);
    EXPECT_EQ(phases[0].end, at_us(7));
}

TEST(PhaseLog, CountsAProcessorOnceARound) {
    PhaseLog log(Duration::microseconds(100));
    log.phase_ended(phase(0, 0, 0, 49));
    log.message_consumed(message(7, 0, 60));
    log.message_consumed(message(8, 0, 149));
    log.message_consumed(message(7, 1, 155));
    log.message_consumed(message(7, 1, 160));
    log.phase_ended(phase(0, 1, 50, 400));
    const auto phases = log.finish(at_us(400));
    ASSERT_EQ(phases.size(), 2U);
    EXPECT_EQ(phases[0].rounds->rounds, 0);
    EXPECT_EQ(phases[1].rounds->rounds, 3);
    EXPECT_EQ(phases[1].rounds->senders, (std::vector<std::int64_t>{2, 1, 0}));
}

TEST(PhaseLog, AgreesWithACountByHand) {
    EXPECT_TRUE(rc::check("senders by round", [] {
        const auto starts =
            *rc::gen::arbitrary<std::vector<std::pair<std::uint8_t, std::uint16_t>>>();
        PhaseLog log(Duration::microseconds(1000));
        std::map<std::int64_t, std::set<NodeIndex>> senders;
        for (const auto& [node, start] : starts) {
            log.message_consumed(message(node, 0, start));
            senders[start / 1000].insert(node);
        }
        const RoundsReport rounds = *log.finish(at_us(100'000)).at(0).rounds;
        RC_ASSERT(rounds.rounds == (senders.empty() ? 0 : senders.rbegin()->first + 2));
        for (std::int64_t round = 0; round < rounds.rounds; ++round) {
            RC_ASSERT(rounds.senders[static_cast<std::size_t>(round)] ==
                      static_cast<std::int64_t>(senders[round].size()));
        }
    }));
}

}  // namespace
}  // namespace rasterloom::observe
