// SPDX-License-Identifier: MIT
// What travels between the lanes of a Princeton Engine, as it lies in their memories before and
// after a communication: descriptors (programs/vliw/memory.s), in sort-first homes
// (programs/vliw/homes.s).
#pragma once

#include "isa/image.hpp"
#include "machine/host/bounding_boxes.hpp"
#include "machine/node/lockstep/lockstep_array.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom {

struct PrincetonRecord {
    // All of its words but the one that is the communication's own.
    std::u16string words;
    // As the lanes take it: a box that ends beyond the ring ends with the ring, a home has all
    // rows. Visible: there is a pixel in it.
    host::BoundingBox box;
};

using LaneRecords = std::vector<PrincetonRecord>;

// By an image's symbols. Its functions throw std::invalid_argument when it lacks one, and for a
// list that is no list: addresses where no memory is, an end before the beginning; and for a home
// that is nobody's: a visible polygon whose left column no lane has.
class PrincetonRecords {
  public:
    // The image must outlive it.
    explicit PrincetonRecords(const isa::Image& image);

    // Before distribution begins, in the order in which they are sent.
    LaneRecords to_be_sent(const LockstepArray& array, std::int64_t lane) const;
    // When it has ended: what the lane draws.
    LaneRecords received(const LockstepArray& array, std::int64_t lane) const;
    // Sort-first: those that are at home on a lane, and how many there may be.
    LaneRecords at_home(const LockstepArray& array, std::int64_t lane) const;
    std::int64_t room_for_homes(const LockstepArray& array, std::int64_t lane) const;

  private:
    std::uint32_t at(std::string_view symbol) const;
    std::uint16_t word(const LockstepArray& array, std::int64_t lane,
                       std::string_view symbol) const;
    LaneRecords listed(const LockstepArray& array, std::int64_t lane, std::string_view begin,
                       std::string_view end) const;
    PrincetonRecord record(const LockstepArray& array, std::int64_t lane,
                           std::uint32_t address) const;

    const isa::Image& image_;
    bool are_homes_;
    bool are_listed_;  // received ones, by their addresses
    std::uint32_t words_;
    std::uint32_t passes_;  // the communication's own word
    std::uint32_t left_;
    std::uint32_t right_;
};

}  // namespace rasterloom
