// SPDX-License-Identifier: MIT
#include "machine/emulation/threads.hpp"

namespace rasterloom::emulation {

std::size_t threads_for(const config::MachineDescription& description, const Machine&) {
    return static_cast<std::size_t>(description.run.threads.value_or(1));
}

}  // namespace rasterloom::emulation
