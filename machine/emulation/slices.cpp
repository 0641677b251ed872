// SPDX-License-Identifier: MIT
#include "machine/emulation/slices.hpp"

#include <algorithm>

namespace rasterloom::emulation {

namespace {

using WallClock = std::chrono::steady_clock;

constexpr std::int64_t kFirstSlices =
    10'000;  // in the whole time: long enough to start threads for

Duration adapt(Duration slice, WallClock::duration took, WallClock::duration wanted,
               Duration whole) {
    if (took < wanted / 2 && slice < whole) {
        return slice * 2;
    }
    if (took > wanted * 2 && slice > Duration::picoseconds(1)) {
        return Duration::picoseconds(slice.picoseconds() / 2);
    }
    return slice;
}

}  // namespace

RunResult run_in_slices(Simulation& simulation, Time limit, std::chrono::milliseconds wanted,
                        const std::function<void(Time)>& between) {
    const Duration whole = limit.since_start();
    Duration slice =
        Duration::picoseconds(std::max<std::int64_t>(1, whole.picoseconds() / kFirstSlices));
    Time reached;
    while (true) {
        const auto start = WallClock::now();
        const Time until = slice < limit - reached ? reached + slice : limit;
        const RunResult result = simulation.run(until);
        reached = result.time;
        between(reached);
        const bool goes_on =
            result.end == RunEnd::paused || (result.end == RunEnd::limit && until < limit);
        if (!goes_on) {
            return result;
        }
        if (result.end == RunEnd::limit) {
            slice = adapt(slice, WallClock::now() - start, wanted, whole);
        }
    }
}

}  // namespace rasterloom::emulation
