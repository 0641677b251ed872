// SPDX-License-Identifier: MIT
// The memories of all lanes, laid out in regions of word addresses. A word is found by three
// strides - of blocks, of lanes in a block, of addresses - whatever the layout.
#pragma once

#include "machine/node/lockstep/host_pages.hpp"
#include "machine/node/lockstep/lockstep_array.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace rasterloom::lockstep {

// Strides in words.
struct MemoryView {
    std::uint16_t* words = nullptr;
    std::size_t block_stride = 0;
    std::size_t lane_stride = 0;     // 1: `across`; 0: one copy for all
    std::size_t address_stride = 0;  // 1: `along`, or one copy
};

class MemoryRegion {
  public:
    std::uint32_t first() const { return first_; }
    const MemoryView& view() const { return *view_.load(std::memory_order_acquire); }
    std::uint16_t* at(const MemoryView& view, std::size_t block, std::uint32_t address) const {
        return view.words + block * view.block_stride + (address - first_) * view.address_stride;
    }

  private:
    friend class LaneMemory;
    struct Stored {
        std::unique_ptr<HostPages> pages;
        MemoryView view;
    };

    std::uint32_t first_ = 0;
    std::uint32_t words_ = 0;
    Stored own_;     // a copy for each lane; not there before a shared region needs it
    Stored common_;  // of a shared region
    std::atomic<const MemoryView*> view_{nullptr};
};

// Successive word addresses of one region.
struct MemoryExtent {
    std::uint32_t first = 0;
    std::uint32_t end = 0;

    bool holds(std::uint32_t address) const { return address >= first && address < end; }
};

class LaneMemory {
  public:
    // `width`: lanes in a block.
    LaneMemory(std::int64_t lanes, int width);

    // See LockstepArray::set_layout. Ranges widen to whole units of 64 words where those are not
    // declared yet.
    void set_layout(std::uint32_t first, std::uint32_t words, LaneLayout layout);

    const MemoryRegion& region(std::uint32_t address) const {
        return *unit_regions_[address / kUnit];
    }
    // All around the address that is of the same region: another may lie in the region's midst.
    const MemoryExtent& extent(std::uint32_t address) const { return extents_[address / kUnit]; }
    // Gives each lane its own copy, for a store: the view is then `along`. By any thread.
    void unshare(const MemoryRegion& region);

    std::uint16_t read(std::int64_t lane, std::uint32_t address) const;
    void read(std::int64_t lane, std::uint32_t address, std::span<std::uint16_t> words) const;
    void write(std::int64_t lane, std::uint32_t address, std::span<const std::uint16_t> words);
    void write_all(std::uint32_t address, std::span<const std::uint16_t> words);

  private:
    static constexpr std::uint32_t kUnit = 64;  // words

    MemoryRegion::Stored along(std::uint32_t words) const;
    MemoryRegion::Stored across(std::uint32_t words) const;
    MemoryRegion& add_region(std::uint32_t first, std::uint32_t words, LaneLayout layout);
    void find_extents();
    void move(MemoryRegion& to, std::uint32_t first, std::uint32_t end);
    std::uint16_t* word(const MemoryRegion& region, std::int64_t lane, std::uint32_t address) const;

    std::size_t lanes_;
    std::size_t width_;
    std::size_t blocks_;
    std::vector<std::unique_ptr<MemoryRegion>> regions_;  // the first is what nobody declared
    std::vector<MemoryRegion*> unit_regions_;
    std::vector<MemoryExtent> extents_;  // by unit
    std::mutex unsharing_;
};

}  // namespace rasterloom::lockstep
