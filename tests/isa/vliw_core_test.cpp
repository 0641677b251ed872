// SPDX-License-Identifier: MIT
// A lane as a core: what the contract suite cannot ask of it, for its program is not in its memory.
#include "isa/vliw/core.hpp"
#include "tests/isa/vliw_assembling.hpp"
#include "tests/isa/vliw_random_programs.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <stdexcept>

namespace rasterloom::isa::vliw {
namespace {

class NoBus final : public Bus {
    Read read(std::uint32_t, int) override { return {}; }
    Status write(std::uint32_t, std::uint32_t, int) override { return Status::fault; }
};

std::shared_ptr<const Program> random_one(std::uint64_t seed) {
    return std::make_shared<const Program>(testing::random_program(seed).image());
}

// The registers by value, and the memory.
void start(Core& core, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    for (int reg = 1; reg < 28; ++reg) {
        core.set_reg(reg, random() & 0xffff);
    }
    std::array<std::uint8_t, 2 * testing::kWindowWords> bytes{};
    for (std::uint8_t& byte : bytes) {
        byte = static_cast<std::uint8_t>(random());
    }
    core.write_memory(2 * testing::kWindow, bytes);
}

TEST(VliwCore, RunsAnyProgramAsStepsDo) {
    NoBus bus;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        LaneCore ran(random_one(seed));
        LaneCore stepped(random_one(seed));
        start(ran, seed);
        start(stepped, seed);
        std::int64_t cycles = 0;
        Stop stop;
        for (; stop.reason == StopReason::budget; cycles += stop.cycles) {
            stop = ran.run(7);
        }
        Stop step;
        for (; step.reason == StopReason::budget; cycles -= step.cycles) {
            step = stepped.step(bus);
        }
        ASSERT_EQ(stop.reason, StopReason::halt);
        ASSERT_EQ(step.reason, StopReason::halt);
        ASSERT_EQ(cycles, 0) << "seed " << seed;
        ASSERT_EQ(ran.instructions_retired(), stepped.instructions_retired());
        for (int reg = 0; reg < kRegisters + kCounters; ++reg) {
            ASSERT_EQ(ran.reg(reg), stepped.reg(reg)) << "seed " << seed;
        }
        const auto bytes = ran.memory();
        ASSERT_TRUE(std::ranges::equal(bytes, stepped.memory())) << "seed " << seed;
    }
}

TEST(VliwCore, TellsOfEveryTapAndChangesNothingElse) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const auto program = random_one(seed);
        LaneCore plain(program);
        LaneCore tapped(program);
        std::vector<std::uint32_t> everywhere(program->bundles.size());
        std::iota(everywhere.begin(), everywhere.end(), 0U);
        tapped.set_taps(everywhere);
        std::int64_t told = 0;
        Stop stop = tapped.run(1'000'000);
        for (; stop.reason == StopReason::tap; stop = tapped.run(1'000'000)) {
            ++told;
        }
        ASSERT_EQ(stop.reason, StopReason::halt);
        ASSERT_EQ(plain.run(1'000'000).reason, StopReason::halt);
        ASSERT_EQ(told, plain.instructions_retired());
        ASSERT_TRUE(std::ranges::equal(plain.memory(), tapped.memory()));
    }
}

TEST(VliwCore, ShowsItsMemoryAsBytesTheLowOneFirst) {
    LaneCore core(std::make_shared<const Program>(
        testing::image_of(" mov r1, #0x1234\n st r1, 1\n sts r1, 3, 0xffff\n ld r2, 2\n halt\n")));
    core.write_memory(5, std::array<std::uint8_t, 2>{0xab, 0xcd});
    core.run(100);
    EXPECT_EQ(core.reg(2), 0xab00U);
    const auto memory = core.memory();
    ASSERT_EQ(memory.size(), kMemoryBytes);
    EXPECT_EQ(memory[2], 0x34);
    EXPECT_EQ(memory[3], 0x12);
    EXPECT_EQ(memory[6], 0xcd);
    EXPECT_EQ(memory[kMemoryBytes - 1], 0x12);
    EXPECT_THROW(core.write_memory(kMemoryBytes - 1, std::array<std::uint8_t, 2>{}),
                 std::out_of_range);
}

TEST(VliwCore, HasTheMemoryOfALaneAndNoOther) {
    const auto program = vliw_isa().prepare(testing::image_of(" halt\n"), {});
    EXPECT_NO_THROW(vliw_isa().make_core(program, {.memory_bytes = kMemoryBytes}));
    EXPECT_THROW(vliw_isa().make_core(program, {.memory_bytes = 1024}), std::invalid_argument);
}

}  // namespace
}  // namespace rasterloom::isa::vliw
