// SPDX-License-Identifier: MIT
#include "machine/node/lockstep/meeting.hpp"

#include "machine/node/lockstep/waiting.hpp"

namespace rasterloom::lockstep {
namespace {

constexpr std::uint32_t kRounds = 0xFFFFFF;  // are told apart

}  // namespace

std::uint32_t Meeting::exchange(int member, std::uint32_t bits) {
    if (members_.size() == 1) {
        return bits;
    }
    Member& self = members_[static_cast<std::size_t>(member)];
    const std::uint32_t round = ++self.round & kRounds;
    const std::size_t place = round % 2;
    self.said[place].store(round << 8U | bits, std::memory_order_release);
    self.said[place].notify_all();
    std::uint32_t all = 0;
    for (const Member& other : members_) {
        std::uint32_t said = 0;
        while ((said = other.said[place].load(std::memory_order_acquire)) >> 8U != round) {
            wait_while(other.said[place], said);
        }
        all |= said;
    }
    return all & 0xFFU;
}

}  // namespace rasterloom::lockstep
