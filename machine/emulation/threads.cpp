// SPDX-License-Identifier: MIT
#include "machine/emulation/threads.hpp"

#include <algorithm>
#include <thread>

namespace rasterloom::emulation {

namespace {

constexpr std::size_t kProcessorsPerThread = 1'000;

}  // namespace

std::size_t threads_for(const config::MachineDescription& description, const Machine& machine) {
    if (machine.lockstep() != nullptr) {
        return 1;  // the array has its own
    }
    if (description.run.threads) {
        return static_cast<std::size_t>(*description.run.threads);
    }
    const std::size_t cores = std::max<std::size_t>(1, std::thread::hardware_concurrency());
    return std::clamp<std::size_t>(machine.processors().size() / kProcessorsPerThread, 1, cores);
}

}  // namespace rasterloom::emulation
