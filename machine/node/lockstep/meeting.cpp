// SPDX-License-Identifier: MIT
#include "machine/node/lockstep/meeting.hpp"

#include "machine/node/lockstep/waiting.hpp"

namespace rasterloom::lockstep {

std::uint32_t Meeting::exchange(int member, std::uint32_t bits) {
    if (members_.size() == 1) {
        return bits;
    }
    Member& self = members_[static_cast<std::size_t>(member)];
    const std::uint64_t round = ++self.round;
    const std::size_t place = round % 2;
    self.said[place].store(round << 8U | bits, std::memory_order_release);
    std::uint64_t all = 0;
    for (const Member& other : members_) {
        std::uint64_t said = 0;
        wait_until([&] {
            said = other.said[place].load(std::memory_order_acquire);
            return said >> 8U == round;
        });
        all |= said;
    }
    return static_cast<std::uint32_t>(all & 0xFFU);
}

}  // namespace rasterloom::lockstep
