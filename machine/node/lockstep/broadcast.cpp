// SPDX-License-Identifier: MIT
#include "machine/node/lockstep/broadcast.hpp"

#include <bit>
#include <cstdint>
#include <vector>

namespace rasterloom::lockstep {
namespace {

std::vector<std::size_t> senders_of(const LaneState& lanes) {
    std::vector<std::size_t> senders;
    for (const LaneBlock& block : lanes.blocks) {
        for (std::size_t word = 0; word < block.bit_words(); ++word) {
            std::uint64_t bits = block.test[word] & block.awake[word];
            for (; bits != 0; bits &= bits - 1) {
                senders.push_back(block.index * block.width + word * kBitsPerWord +
                                  static_cast<std::size_t>(std::countr_zero(bits)));
            }
        }
    }
    return senders;
}

}  // namespace

void broadcast_communication(LaneState& lanes, std::size_t ring_offset) {
    const std::vector<std::size_t> senders = senders_of(lanes);
    const std::size_t ring = lanes.ring.size();
    for (std::size_t i = 0; i < senders.size(); ++i) {
        const bool last = i + 1 == senders.size();
        const std::size_t end = last ? senders.front() + ring : senders[i + 1];
        std::size_t place = (ring_offset + senders[i]) % ring;
        const std::uint16_t value = lanes.ring[place];
        for (std::size_t lane = senders[i]; lane < end; ++lane) {
            lanes.ring[place] = value;
            place = place + 1 == ring ? 0 : place + 1;
        }
    }
}

}  // namespace rasterloom::lockstep
