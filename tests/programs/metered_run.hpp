// SPDX-License-Identifier: MIT
#pragma once

#include "isa/core.hpp"
#include "machine/emulation/appendix_c_collector.hpp"
#include "machine/kernel/time.hpp"

#include <cstdint>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::test {

// Lets a core without a machine run until it halts; its accesses to the I/O page go to `bus`, its
// taps to the meter. Throws std::runtime_error when the program stops otherwise.
inline void run_metered(isa::Core& core, isa::Bus& bus, emulation::AppendixCMeter& meter,
                        std::int64_t& cycles) {
    while (true) {
        isa::Stop stop = core.run(100'000);
        cycles += stop.cycles;
        if (stop.reason == isa::StopReason::io) {
            stop = core.step(bus);
            cycles += stop.cycles;
        }
        if (stop.reason == isa::StopReason::tap) {
            meter.tapped({0, core.program_counter(), cycles, Time::zero(), core});
        } else if (stop.reason == isa::StopReason::halt) {
            return;
        } else if (stop.reason != isa::StopReason::budget) {
            throw std::runtime_error(fmt::format("the program stops at {:06o}: {}",
                                                 core.program_counter(),
                                                 stop.trap ? stop.trap->what : ""));
        }
    }
}

}  // namespace rasterloom::test
