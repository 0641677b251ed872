// SPDX-License-Identifier: MIT
// Where the host's threads that compute an array's lanes wait for each other: all come with a few
// bits, and all go on with everybody's bits together.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rasterloom::lockstep {

class Meeting {
  public:
    explicit Meeting(int members) : members_(static_cast<std::size_t>(members)) {}

    // What all members wrote before the meeting can be read by all after it. `bits`: below 256.
    std::uint32_t exchange(int member, std::uint32_t bits);

  private:
    struct alignas(64) Member {
        std::uint32_t round = 0;
        // Two places: a member may be one round ahead of another, not two.
        // The round in the upper bits.
        std::array<std::atomic<std::uint32_t>, 2> said{};
    };

    std::vector<Member> members_;
};

}  // namespace rasterloom::lockstep
