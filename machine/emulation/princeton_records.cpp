// SPDX-License-Identifier: MIT
#include "machine/emulation/princeton_records.hpp"

#include "machine/emulation/node_memory.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom {

PrincetonRecords::PrincetonRecords(const isa::Image& image)
    : image_(image),
      are_homes_(image.symbol("sort_first").value_or(0) != 0),
      are_listed_(are_homes_ || image.symbol("kRegion").has_value()),
      words_(at(are_homes_ ? "kHome" : "kDescriptor")),
      passes_(at(are_homes_ ? "h_passes" : "d_passes")),
      left_(at(are_homes_ ? "h_left" : "d_left")),
      right_(at(are_homes_ ? "h_right" : "d_right")) {}

LaneRecords PrincetonRecords::to_be_sent(const LockstepArray& array, std::int64_t lane) const {
    if (are_homes_)
        return at_home(array, lane);
    LaneRecords records;
    const std::uint32_t begin = word(array, lane, "source_at");
    const std::uint32_t count = word(array, lane, "source_count");
    for (std::uint32_t k = 0; k < count; ++k)
        records.push_back(record(array, lane, begin + k * words_));
    return records;
}

LaneRecords PrincetonRecords::received(const LockstepArray& array, std::int64_t lane) const {
    if (are_listed_)
        return listed(array, lane, "wanted", "wanted_end");
    LaneRecords records;
    const std::uint32_t end = word(array, lane, "received_end");
    for (std::uint32_t at = word(array, lane, "received_at"); at < end; at += words_)
        records.push_back(record(array, lane, at));
    return records;
}

LaneRecords PrincetonRecords::at_home(const LockstepArray& array, std::int64_t lane) const {
    return listed(array, lane, "homes", "home_end");
}

std::int64_t PrincetonRecords::room_for_homes(const LockstepArray& array, std::int64_t lane) const {
    const std::int64_t room = word(array, lane, "homes_end") - word(array, lane, "polygons_at");
    return room / words_ - 1;  // one passes through
}

std::uint32_t PrincetonRecords::at(std::string_view symbol) const {
    return require_symbol(image_, symbol);
}

std::uint16_t PrincetonRecords::word(const LockstepArray& array, std::int64_t lane,
                                     std::string_view symbol) const {
    return array.read(lane, at(symbol));
}

// Their addresses lie in slow bank 0, from `begin` to what the word `end` says.
LaneRecords PrincetonRecords::listed(const LockstepArray& array, std::int64_t lane,
                                     std::string_view begin, std::string_view end) const {
    const auto first = static_cast<std::uint16_t>(at(begin));
    const std::uint16_t last = word(array, lane, end);
    if (last < first)
        throw std::invalid_argument(
            fmt::format("lane {}: {} is {:#x}, expected at least {:#x}", lane, end, last, first));
    std::vector<std::uint16_t> addresses(static_cast<std::size_t>(last - first));
    array.read(lane, slow_word(0, first), addresses);
    LaneRecords records;
    for (const std::uint16_t address : addresses)
        records.push_back(record(array, lane, address));
    return records;
}

PrincetonRecord PrincetonRecords::record(const LockstepArray& array, std::int64_t lane,
                                         std::uint32_t address) const {
    if (address + words_ > isa::vliw::kBankWords)
        throw std::invalid_argument(fmt::format(
            "lane {}: a polygon at address {:#x}, expected it in the fast memory", lane, address));
    std::vector<std::uint16_t> words(words_);
    array.read(lane, address, words);
    words[passes_] = 0;
    const auto signed_word = [&](std::uint32_t at) {
        return static_cast<int>(static_cast<std::int16_t>(words[at]));
    };
    // communicate.s cuts it so when it prepares the descriptor, homes.s has done so already.
    if (!are_listed_)
        words[right_] = static_cast<std::uint16_t>(
            std::min<std::int64_t>(signed_word(right_), array.lanes() - 1));
    PrincetonRecord record;
    record.words.assign(words.begin(), words.end());
    record.box.box = {signed_word(left_), 0, signed_word(right_),
                      static_cast<int>(at("screen_rows")) - 1};
    if (!are_homes_) {
        record.box.box.y0 = signed_word(at("d_top"));
        record.box.box.y1 = signed_word(at("d_bottom"));
    }
    const auto& box = record.box.box;
    record.box.is_visible = box.x0 <= box.x1 && box.y0 <= box.y1;
    if (are_homes_ && record.box.is_visible && (box.x0 < 0 || box.x0 >= array.lanes()))
        throw std::invalid_argument(
            fmt::format("lane {}: a visible polygon at address {:#x} begins in column {}, expected "
                        "0 to {}",
                        lane, address, box.x0, array.lanes() - 1));
    return record;
}

}  // namespace rasterloom
