// SPDX-License-Identifier: MIT
// The PDP-11 core in the machine: its programs see the same whether it runs ahead or is stepped
// through the event queue.
#include "isa/assembler.hpp"
#include "isa/pdp11/pdp11.hpp"
#include "machine/fabric/network.hpp"
#include "machine/fabric/supervisor.hpp"
#include "topologies/regular.hpp"

#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom {
namespace {

// Sends six messages to random neighbours at random times, polling; receives by interrupt. r4 is
// the seed.
constexpr const char* kInterruptedTraffic = R"(
        .asect
        . = 300
        .word   recv0, 240, 0, 0
        .word   recv1, 240, 0, 0
        . = 1000
start:  mov     #1000, sp
        mov     #100, @#164010
        mov     #100, @#164030
        clr     @#177776
        mov     #6, r0
loop:   tst     r0
        beq     done
        mov     r4, r1
        mul     #25173., r1
        add     #13849., r1
        mov     r1, r4
        clr     r2
        bit     #20000, r4
        beq     1$
        mov     #20, r2
1$:     bit     #200, 164000(r2)
        beq     loop
        dec     r0
        mov     #1, @#165012
        mov     #start, 164002(r2)
        mov     #12., 164004(r2)
        mov     r4, r3
        bic     #177740, r3
        inc     r3
2$:     sob     r3, 2$
        br      loop
done:   mov     #-1, @#165012
3$:     mov     @#165014, r1
        cmp     r1, #177777
        bne     3$
        halt
recv0:  inc     count
        mov     #5, @#165016
        mov     #inbuf, @#164014
        mov     #-1, @#165012
        clr     @#165016
        rti
recv1:  inc     count
        mov     #inbuf, @#164034
        mov     #-1, @#165012
        rti
count:  .word   0
inbuf:  .blkw   40
        .end    start
)";

// Sleeps until its neighbours' two messages have come, which it counts in r0.
constexpr const char* kSleeper = R"(
        .asect
        . = 300
        .word   recv0, 240, 0, 0
        .word   recv1, 240, 0, 0
        . = 1000
start:  mov     #1000, sp
        tst     @#165000
        bne     send
        mov     #100, @#164010
        mov     #100, @#164030
        clr     @#177776
1$:     wait
        cmp     r0, #2
        bne     1$
        halt
send:   clr     r2
        cmp     @#165000, #1
        bne     2$
        mov     #20, r2
2$:     mov     #start, 164002(r2)
        mov     #2, 164004(r2)
        halt
recv0:  inc     r0
        mov     #2000, @#164014
        rti
recv1:  inc     r0
        mov     #2000, @#164034
        rti
        .end    start
)";

struct Machine {
    Machine(const char* source, int nodes, const LinkSettings& link, bool run_ahead,
            bool supervised, std::uint32_t seed) {
        const isa::Isa& isa = isa::pdp11::pdp11_isa();
        const isa::Assembly assembly = isa::assemble_text(isa, "test.s", source);
        if (!assembly.ok()) {
            throw std::runtime_error("the test's program has errors");
        }
        const auto program = isa.prepare(assembly.image, isa::CostChoice{"strothotte", {}});
        if (supervised) {
            Supervisor::Settings settings{Duration::microseconds(1), 1, 1, nodes};
            supervisor = &simulation.add<Supervisor>("supervisor", settings);
        }
        for (int node = 0; node < nodes; ++node) {
            Processor::Settings settings;
            settings.node = static_cast<NodeIndex>(node);
            settings.ports = {2, 2, link.input_queue, SendPolicy::one_at_a_time};
            settings.supervised = supervised;
            settings.run_ahead = run_ahead;
            auto core = isa.make_core(program, {});
            core->set_reg(4, (seed + 7U * static_cast<std::uint32_t>(node)) & 0177777U);
            processors.push_back(&simulation.add<Processor>("node/" + std::to_string(100 + node),
                                                            std::move(core), settings));
            if (supervised) {
                supervisor->connect(simulation, node, *processors.back());
            }
        }
        count_address = assembly.image.symbol("count").value_or(0);
        connect_network(simulation, topology::ring(nodes), processors, link);
        simulation.seal();
    }

    // Where every processor ended: time, instructions, cycles, messages that its handlers counted.
    auto outcome() const {
        std::vector<std::tuple<Time, std::int64_t, std::int64_t, int>> all;
        for (const Processor* processor : processors) {
            all.emplace_back(processor->reached(), processor->statistics().instructions,
                             processor->statistics().cycles,
                             processor->core().memory()[count_address]);
        }
        return all;
    }

    Simulation simulation;
    Supervisor* supervisor = nullptr;
    std::vector<Processor*> processors;
    std::uint32_t count_address = 0;
};

TEST(Pdp11Machine, TakesInterruptsAtTheSameInstructionWithAndWithoutRunningAhead) {
    EXPECT_TRUE(rc::check([] {
        const auto draw = [](int low, int high) { return *rc::gen::inRange(low, high + 1); };
        const int nodes = draw(3, 6);
        const LinkSettings link{Duration::microseconds(draw(0, 9)),
                                Duration::nanoseconds(draw(0, 500)),
                                Duration::nanoseconds(draw(1, 5'000)), draw(1, 3)};
        const auto seed = static_cast<std::uint32_t>(draw(0, 65'535));
        Machine ahead(kInterruptedTraffic, nodes, link, true, true, seed);
        RC_ASSERT(ahead.simulation.run().end == RunEnd::finished);
        int received = 0;
        for (const auto& [time, instructions, cycles, count] : ahead.outcome()) {
            received += count;
        }
        RC_ASSERT(received == 6 * nodes);
        Machine stepped(kInterruptedTraffic, nodes, link, false, true, seed);
        RC_ASSERT(stepped.simulation.run().end == RunEnd::finished);
        RC_ASSERT(stepped.outcome() == ahead.outcome());
    }));
}

TEST(Pdp11Machine, SleepsInWaitUntilAMessageInterrupts) {
    const LinkSettings link{Duration::microseconds(20), Duration(), Duration::microseconds(1), 2};
    Machine machine(kSleeper, 3, link, true, false, 0);
    const RunResult result = machine.simulation.run();
    EXPECT_EQ(result.end, RunEnd::finished) << (result.failure ? result.failure->message() : "");
    EXPECT_EQ(machine.processors[0]->core().reg(0), 2U);
    EXPECT_GT(machine.processors[0]->statistics().in_state(NodeState::waiting_interrupt),
              Duration::microseconds(5));
}

}  // namespace
}  // namespace rasterloom
