// SPDX-License-Identifier: MIT
#include "machine/node/lockstep/lane_memory.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::lockstep {
namespace {

constexpr std::size_t kLineWords = 32;  // a cache line of the host

// The least odd number of cache lines that holds `words`: what lies one stride apart then spreads
// over all sets of a cache.
std::size_t odd_lines(std::size_t words) {
    return (((words + kLineWords - 1) / kLineWords) | 1U) * kLineWords;
}

void check_range(std::uint32_t first, std::size_t words) {
    if (first > kLaneWords || words > kLaneWords - first) {
        throw std::out_of_range(
            fmt::format("a lane has {} words of memory; {} from {} on are not all in it",
                        kLaneWords, words, first));
    }
}

}  // namespace

LaneMemory::LaneMemory(std::int64_t lanes, int width)
    : lanes_(static_cast<std::size_t>(lanes)),
      width_(static_cast<std::size_t>(width)),
      blocks_((lanes_ + width_ - 1) / width_) {
    MemoryRegion& rest = add_region(0, kLaneWords, LaneLayout::across);
    unit_regions_.assign(kLaneWords / kUnit, &rest);
    find_extents();
}

MemoryRegion::Stored LaneMemory::across(std::uint32_t words) const {
    const std::size_t block = odd_lines(words * width_);
    auto pages = std::make_unique<HostPages>(block * blocks_);
    const MemoryView view{pages->words(), block, 1, width_};
    return {std::move(pages), view};
}

MemoryRegion::Stored LaneMemory::along(std::uint32_t words) const {
    const std::size_t lane = odd_lines(words);
    auto pages = std::make_unique<HostPages>(lane * width_ * blocks_);
    const MemoryView view{pages->words(), lane * width_, lane, 1};
    return {std::move(pages), view};
}

MemoryRegion& LaneMemory::add_region(std::uint32_t first, std::uint32_t words, LaneLayout layout) {
    MemoryRegion& region = *regions_.emplace_back(std::make_unique<MemoryRegion>());
    region.first_ = first;
    region.words_ = words;
    if (layout == LaneLayout::shared) {
        region.common_.pages = std::make_unique<HostPages>(words);
        region.common_.view = {region.common_.pages->words(), 0, 0, 1};
        region.view_ = &region.common_.view;
    } else {
        region.own_ = layout == LaneLayout::along ? along(words) : across(words);
        region.view_ = &region.own_.view;
    }
    return region;
}

void LaneMemory::set_layout(std::uint32_t first, std::uint32_t words, LaneLayout layout) {
    check_range(first, words);
    if (words == 0) {
        return;
    }
    const std::uint32_t end_unit = (first + words + kUnit - 1) / kUnit;
    const std::uint32_t first_unit = first / kUnit;
    MemoryRegion& region = add_region(first_unit * kUnit, (end_unit - first_unit) * kUnit, layout);
    for (std::uint32_t unit = first_unit; unit < end_unit; ++unit) {
        const bool whole = unit * kUnit >= first && (unit + 1) * kUnit <= first + words;
        if (!whole && unit_regions_[unit] != regions_.front().get()) {
            continue;  // the neighbour's range came first
        }
        move(region, unit * kUnit, std::min(first, (unit + 1) * kUnit));
        move(region, std::max(first + words, unit * kUnit), (unit + 1) * kUnit);
        unit_regions_[unit] = &region;
    }
    find_extents();
}

void LaneMemory::find_extents() {
    extents_.resize(unit_regions_.size());
    for (std::size_t first = 0; first < extents_.size();) {
        std::size_t end = first;
        while (end < extents_.size() && unit_regions_[end] == unit_regions_[first]) {
            ++end;
        }
        const MemoryExtent extent{static_cast<std::uint32_t>(first * kUnit),
                                  static_cast<std::uint32_t>(end * kUnit)};
        std::fill(extents_.begin() + static_cast<std::ptrdiff_t>(first),
                  extents_.begin() + static_cast<std::ptrdiff_t>(end), extent);
        first = end;
    }
}

// Words beside a range that widens over them may have been written already.
void LaneMemory::move(MemoryRegion& to, std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t address = first; address < end; ++address) {
        for (std::size_t lane = 0; lane < lanes_; ++lane) {
            const std::uint16_t value = read(static_cast<std::int64_t>(lane), address);
            if (value != 0) {
                unshare(to);
                *word(to, static_cast<std::int64_t>(lane), address) = value;
            }
        }
    }
}

void LaneMemory::unshare(const MemoryRegion& region) {
    const std::lock_guard<std::mutex> lock(unsharing_);
    if (region.view().lane_stride != 0) {
        return;
    }
    // Only the region's own lookup hands out references to it as constant.
    auto& shared = *std::find_if(regions_.begin(), regions_.end(),
                                 [&](const auto& owned) { return owned.get() == &region; });
    shared->own_ = along(region.words_);
    const MemoryView& own = shared->own_.view;
    const std::uint16_t* const common = shared->common_.view.words;
    for (std::size_t lane = 0; lane < lanes_; ++lane) {
        for (std::uint32_t i = 0; i < region.words_; ++i) {
            if (common[i] != 0) {
                own.words[lane * own.lane_stride + i] = common[i];
            }
        }
    }
    shared->view_.store(&own, std::memory_order_release);
}

std::uint16_t* LaneMemory::word(const MemoryRegion& region, std::int64_t lane,
                                std::uint32_t address) const {
    const MemoryView& view = region.view();
    const auto number = static_cast<std::size_t>(lane);
    return region.at(view, number / width_, address) + number % width_ * view.lane_stride;
}

std::uint16_t LaneMemory::read(std::int64_t lane, std::uint32_t address) const {
    return *word(region(address), lane, address);
}

void LaneMemory::read(std::int64_t lane, std::uint32_t address,
                      std::span<std::uint16_t> words) const {
    check_range(address, words.size());
    while (!words.empty()) {
        const std::size_t count =
            std::min<std::size_t>(words.size(), extent(address).end - address);
        const MemoryRegion& from = region(address);
        const std::size_t stride = from.view().address_stride;
        const std::uint16_t* const first = word(from, lane, address);
        for (std::size_t i = 0; i < count; ++i) {
            words[i] = first[i * stride];
        }
        words = words.subspan(count);
        address += static_cast<std::uint32_t>(count);
    }
}

void LaneMemory::write(std::int64_t lane, std::uint32_t address,
                       std::span<const std::uint16_t> words) {
    check_range(address, words.size());
    for (const std::uint16_t value : words) {
        const MemoryRegion& into = region(address);
        if (*word(into, lane, address) != value) {
            unshare(into);
            *word(into, lane, address) = value;
        }
        ++address;
    }
}

void LaneMemory::write_all(std::uint32_t address, std::span<const std::uint16_t> words) {
    check_range(address, words.size());
    for (const std::uint16_t value : words) {
        const MemoryRegion& into = region(address);
        if (into.view().lane_stride == 0) {
            *word(into, 0, address) = value;
        } else {
            for (std::size_t lane = 0; lane < lanes_; ++lane) {
                *word(into, static_cast<std::int64_t>(lane), address) = value;
            }
        }
        ++address;
    }
}

}  // namespace rasterloom::lockstep
