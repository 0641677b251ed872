// SPDX-License-Identifier: MIT
// The core against SIMH: random sequences run on both, registers, status and memory compared. Left
// out are HALT, WAIT, RESET, the devices of the I/O page, and the processor modes that SIMH's 11/40
// has with its memory management.
#include "tests/isa/pdp11_machine.hpp"
#include "tests/isa/pdp11_random.hpp"
#include "tests/isa/simh.hpp"

#include <cstdlib>
#include <iostream>
#include <sstream>

#include <gtest/gtest.h>

namespace rasterloom::isa::testing {
namespace {

constexpr std::size_t kBatch = 500;

using Memory = std::vector<std::uint8_t>;

Memory copy_of(const Core& core) {
    return {core.memory().begin(), core.memory().end()};
}

std::vector<std::uint32_t> differing_words(const Core& core, const Memory& other) {
    std::vector<std::uint32_t> addresses;
    const auto memory = core.memory();
    for (std::uint32_t a = 0; a < other.size(); a += 2) {
        if (memory[a] != other[a] || memory[a + 1] != other[a + 1])
            addresses.push_back(a);
    }
    return addresses;
}

void restore(Core& core, const Memory& memory) {
    for (const std::uint32_t a : differing_words(core, memory)) {
        core.write_memory(a, std::span(memory).subspan(a, 2));
    }
}

void prepare(Core& core, const RandomStart& start) {
    std::uint32_t address = start.r[7];
    for (const std::uint16_t word : start.code) {
        put_word(core, address, word);
        address += 2;
    }
    for (int i = 0; i < 7; ++i)
        core.set_reg(i, start.r[static_cast<std::size_t>(i)]);
    core.set_program_counter(start.r[7]);
    core.set_reg(kPsw, start.psw);
}

SimhState state_of(const Core& core, const std::vector<std::uint32_t>& addresses) {
    SimhState state;
    for (int i = 0; i < 9; ++i)
        state.registers[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(core.reg(i));
    for (const std::uint32_t a : addresses)
        state.words.push_back(static_cast<std::uint16_t>(word_at(core, a)));
    return state;
}

// How far a sequence can be compared: SIMH takes a trap when the next instruction is due, so the
// last must not trap.
struct Extent {
    std::size_t calls = 0;         // of run(1)
    std::size_t instructions = 0;  // SIMH does not count one that could not be fetched
    std::int64_t cycles = 0;
};

Extent measure(pdp11::Pdp11Core& core, std::size_t limit) {
    Extent best;
    Extent now;
    while (now.calls < limit) {
        const std::uint32_t pc = core.program_counter();
        const bool fetched = pc % 2 == 0;
        // SIMH fetches from the I/O page: the status word would be an instruction.
        if (fetched && (pc >= core.memory().size() || left_out(word_at(core, pc)))) {
            break;
        }
        const auto traps = core.traps_taken();
        const auto dropped = core.beyond_model();
        const Stop stop = core.run(1);
        if (stop.reason != StopReason::budget || core.beyond_model() != dropped)
            break;
        ++now.calls;
        now.instructions += fetched ? 1U : 0U;
        now.cycles += stop.cycles;
        if (core.traps_taken() == traps)
            best = now;
    }
    return best;
}

std::string describe(const RandomStart& start, std::size_t instructions) {
    std::ostringstream text;
    text << std::oct << "start:";
    for (const auto r : start.r)
        text << ' ' << r;
    text << " psw " << start.psw << "\ncode:";
    for (const auto w : start.code)
        text << ' ' << w;
    text << std::dec << "\ninstructions: " << instructions;
    return text.str();
}

std::string describe(const SimhState& state) {
    std::ostringstream text;
    text << std::oct;
    for (const auto r : state.registers)
        text << ' ' << r;
    text << " |";
    for (const auto w : state.words)
        text << ' ' << w;
    return text.str();
}

struct Expectation {
    RandomStart start;
    std::size_t instructions;
    SimhState state;
};

// One batch: memory goes on from one sequence to the next on both machines and is compared as a
// whole at the end.
void compare_batch(std::uint64_t seed, std::int64_t& instructions) {
    RandomPdp11 random(seed);
    Image image{"random", 01000, {{0, random.memory()}}, {}, {}};
    auto core = core_of(image, {.memory_bytes = 0, .traps = TrapPolicy::always_vector});
    SimhScript simh(image.segments[0].bytes);
    std::vector<Expectation> expected;
    while (expected.size() < kBatch) {
        for (const std::uint32_t vector : kVectors) {
            const auto handler = static_cast<std::uint16_t>(02000U + 2U * random.below(060000));
            const auto status = static_cast<std::uint16_t>(0340U | random.below(16));
            put_word(*core, vector, handler);
            put_word(*core, vector + 2, status);
            simh.deposit(vector, handler);
            simh.deposit(vector + 2, status);
        }
        const RandomStart start = random_start(random, 1 + random.below(12));
        const Memory before = copy_of(*core);
        prepare(*core, start);
        const Extent extent = measure(*core, 1 + random.below(16));
        restore(*core, before);
        if (extent.instructions == 0)
            continue;
        prepare(*core, start);
        for (std::size_t i = 0; i < extent.calls; ++i)
            core->run(1);
        const auto changed = differing_words(*core, before);
        const SimhState stepped = state_of(*core, changed);
        // The same in one run, where handlers follow one another.
        restore(*core, before);
        prepare(*core, start);
        ASSERT_EQ(core->run(extent.cycles).cycles, extent.cycles)
            << describe(start, extent.instructions);
        ASSERT_EQ(describe(state_of(*core, changed)), describe(stepped))
            << describe(start, extent.instructions);
        ASSERT_EQ(differing_words(*core, before), changed) << describe(start, extent.instructions);
        simh.start(start);
        simh.step(extent.instructions);
        simh.examine(changed);
        expected.push_back({start, extent.instructions, stepped});
        instructions += static_cast<std::int64_t>(extent.instructions);
    }
    std::vector<std::uint32_t> everything;
    for (std::uint32_t a = 0; a < pdp11::kIoPage; a += 2)
        everything.push_back(a);
    simh.examine(everything);
    const auto answers = simh.run();
    ASSERT_EQ(answers.size(), kBatch + 1) << "SIMH's printout was not understood";
    for (std::size_t i = 0; i < kBatch; ++i) {
        ASSERT_EQ(describe(expected[i].state), describe(answers[i]))
            << "seed " << seed << ", sequence " << i << "\n"
            << describe(expected[i].start, expected[i].instructions);
    }
    EXPECT_EQ(state_of(*core, everything).words, answers.back().words);
}

TEST(Pdp11AgainstSimh, AgreesOnRandomSequences) {
    if (!SimhScript::available())
        GTEST_SKIP() << "SIMH's pdp11 is not installed";
    const std::size_t sequences = std::getenv("RASTERLOOM_LONG_TESTS") != nullptr ? 120'000 : 4'000;
    std::int64_t instructions = 0;
    for (std::uint64_t batch = 0; batch < sequences / kBatch; ++batch) {
        compare_batch(batch + 1, instructions);
        if (HasFatalFailure())
            return;
    }
    RecordProperty("sequences", std::to_string(sequences));
    std::cout << sequences << " sequences, " << instructions << " instructions\n";
}

}  // namespace
}  // namespace rasterloom::isa::testing
