// SPDX-License-Identifier: MIT
// The contract of every instruction set, its taps: told of once before each execution, and nothing
// else changes.
#include "tests/isa/contract.hpp"

#include <algorithm>
#include <random>
#include <set>
#include <stdexcept>

namespace rasterloom::isa::testing {
namespace {

constexpr std::int64_t kEnough = 1'000'000;

class TapContract : public Contract {
  protected:
    std::unique_ptr<Core> running(std::string_view source) const {
        return core_running(isa(), source);
    }
    Snapshot snapshot(const Core& core) const { return snapshot_of(core, isa()); }
};

using Taps = std::vector<std::uint32_t>;

// Runs like run(), but past taps, which it notes.
Stop run_past_taps(Core& core, std::int64_t budget, Taps& told) {
    Stop all;
    while (true) {
        Stop stop = core.run(budget - all.cycles);
        stop.cycles += all.cycles;
        if (stop.reason != StopReason::tap)
            return stop;
        all.cycles = stop.cycles;
        told.push_back(core.program_counter());
    }
}

// The same made of steps: what run() should tell of.
Stop step_past_taps(Core& core, std::int64_t budget, const Taps& taps, Taps& told) {
    const std::set<std::uint32_t> tapped(taps.begin(), taps.end());
    AnsweringBus bus(Bus::Status::retry);
    Stop all;
    while (all.cycles < budget) {
        if (tapped.contains(core.program_counter()))
            told.push_back(core.program_counter());
        const Stop stop = core.step(bus);
        all.cycles += stop.cycles;
        if (stop.reason != StopReason::budget) {
            all.reason = stop.reason == StopReason::retry ? StopReason::io : stop.reason;
            break;
        }
    }
    return all;
}

TEST_P(TapContract, TellsOfEveryExecutionAndChangesNothingElse) {
    SKIP_WITHOUT(GetParam().code_in_memory, "code in memory");
    std::mt19937 random(23);
    std::size_t all_told = 0;
    for (int round = 0; round < 400; ++round) {
        std::vector<std::uint8_t> bytes(512);
        for (std::uint8_t& byte : bytes)
            byte = static_cast<std::uint8_t>(random());
        Taps taps;
        for (int i = 0; i < 1 + round % 40; ++i) {
            taps.push_back(static_cast<std::uint32_t>(1024 + random() % 200) / step_of_addresses() *
                           step_of_addresses());
        }
        const auto plain = running(GetParam().halt);
        const auto tapped = running(GetParam().halt);
        const auto stepped = running(GetParam().halt);
        std::vector<std::uint32_t> values(6);
        std::ranges::generate(values, [&] { return random() % 0xd000 & ~1U; });
        for (Core* each : {plain.get(), tapped.get(), stepped.get()}) {
            each->write_memory(1024, bytes);
            each->set_program_counter(1024);
            for (int i = 0; i < 6; ++i) {
                if (i < static_cast<int>(isa().register_names().size()) - 1 && each->reg(i) != 1024)
                    each->set_reg(i, values[static_cast<std::size_t>(i)]);
            }
        }
        tapped->set_taps(taps);
        Taps told;
        Taps expected;
        const Stop a = plain->run(500);
        const Stop b = run_past_taps(*tapped, 500, told);
        step_past_taps(*stepped, 500, taps, expected);
        ASSERT_EQ(a.reason, b.reason) << "round " << round;
        ASSERT_EQ(a.cycles, b.cycles) << "round " << round;
        ASSERT_EQ(snapshot(*plain), snapshot(*tapped)) << "round " << round;
        ASSERT_EQ(told, expected) << "round " << round;
        all_told += told.size();
    }
    EXPECT_GT(all_told, 20U);
}

TEST_P(TapContract, TellsOfEveryInstructionOfALoopWhateverTheBudget) {
    const auto stepped = running(GetParam().straight);
    std::set<std::uint32_t> addresses;
    AnsweringBus bus(Bus::Status::fault);
    do {
        addresses.insert(stepped->program_counter());
    } while (stepped->step(bus).reason == StopReason::budget);
    for (const std::int64_t budget : {1, 2, 3, 7, 50, 100'000}) {
        const auto core = running(GetParam().straight);
        core->set_taps(Taps(addresses.begin(), addresses.end()));
        Taps told;
        while (run_past_taps(*core, budget, told).reason == StopReason::budget) {
        }
        EXPECT_EQ(told.size(), static_cast<std::size_t>(stepped->instructions_retired()));
        EXPECT_EQ(snapshot(*core), snapshot(*stepped));
    }
}

TEST_P(TapContract, StopsBeforeTheInstructionHasAnyEffectAndTakesNoCycles) {
    const auto core = running(GetParam().straight);
    const std::uint32_t first = core->program_counter();
    core->set_taps(Taps{first});
    const Snapshot before = snapshot(*core);
    const Stop stop = core->run(kEnough);
    EXPECT_EQ(stop.reason, StopReason::tap);
    EXPECT_EQ(stop.cycles, 0);
    EXPECT_EQ(core->program_counter(), first);
    EXPECT_EQ(snapshot(*core), before);
    AnsweringBus bus(Bus::Status::fault);
    EXPECT_EQ(core->step(bus).reason, StopReason::budget);
    EXPECT_NE(core->program_counter(), first);
    EXPECT_EQ(core->run(kEnough).reason, StopReason::halt);
}

TEST_P(TapContract, TellsOfATapBeforeTheIoAccessOfItsInstruction) {
    SKIP_WITHOUT(!GetParam().store.empty(), "I/O page");
    const auto core = running(GetParam().store);
    const auto twin = running(GetParam().store);
    twin->run(kEnough);
    core->set_taps(Taps{twin->program_counter()});
    EXPECT_EQ(core->run(kEnough).reason, StopReason::tap);
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(core->run(kEnough).reason, StopReason::io);
    AnsweringBus bus(Bus::Status::retry);
    EXPECT_EQ(core->step(bus).reason, StopReason::retry);
    EXPECT_EQ(core->run(kEnough).reason, StopReason::io);
    bus.answer(Bus::Status::ok);
    EXPECT_EQ(core->step(bus).reason, StopReason::budget);
    EXPECT_EQ(core->run(kEnough).reason, StopReason::halt);
}

TEST_P(TapContract, LetsAnInterruptGoFirst) {
    SKIP_WITHOUT(!GetParam().interrupt.empty(), "interrupts");
    const Assembly assembly = assemble_text(isa(), "t.s", GetParam().interrupt);
    const std::uint32_t loop = assembly.image.symbol("loop").value();
    const std::uint32_t handler = assembly.image.symbol("handler").value();
    const auto core = running(GetParam().interrupt);
    core->run(100);
    ASSERT_EQ(core->program_counter(), loop);
    core->set_taps(Taps{loop, handler});
    core->request_interrupt(GetParam().level, GetParam().vector);
    Taps told;
    EXPECT_EQ(run_past_taps(*core, kEnough, told).reason, StopReason::halt);
    EXPECT_EQ(told, Taps{handler});
}

TEST_P(TapContract, SeesCodeOverwrittenAtATap) {
    SKIP_WITHOUT(GetParam().code_in_memory, "code in memory");
    const std::uint32_t patch =
        assemble_text(isa(), "t.s", GetParam().endless).image.symbol("patch").value();
    const Assembly halt = assemble_text(isa(), "t.s", GetParam().halt);
    const auto core = running(GetParam().endless);
    core->set_taps(Taps{patch});
    for (int i = 0; i < 3; ++i)
        ASSERT_EQ(core->run(kEnough).reason, StopReason::tap);
    core->write_memory(patch, halt.image.segments.at(0).bytes);
    EXPECT_EQ(core->run(kEnough).reason, StopReason::halt);
}

TEST_P(TapContract, ForgetsTheTapsThatOthersReplace) {
    const Assembly endless = assemble_text(isa(), "t.s", GetParam().endless);
    const std::uint32_t patch = endless.image.symbol("patch").value();
    const auto core = running(GetParam().endless);
    core->run(1000);
    core->set_taps(Taps{patch});
    EXPECT_EQ(core->run(kEnough).reason, StopReason::tap);
    core->set_taps(Taps{endless.image.entry});
    EXPECT_EQ(core->run(kEnough).reason, StopReason::tap);
    EXPECT_EQ(core->program_counter(), endless.image.entry);
    core->set_taps({});
    EXPECT_EQ(core->run(kEnough).reason, StopReason::budget);
}

TEST_P(TapContract, RefusesAddressesWhereNoInstructionCanBegin) {
    const auto core = running(GetParam().halt);
    EXPECT_THROW(core->set_taps(Taps{isa().private_bytes()}), std::invalid_argument);
    if (isa().word_bits() > 8) {
        EXPECT_THROW(core->set_taps(Taps{1023}), std::invalid_argument);
    }
}

INSTANTIATE_TEST_SUITE_P(EveryIsa, TapContract, ::testing::ValuesIn(subjects()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace rasterloom::isa::testing
