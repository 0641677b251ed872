// SPDX-License-Identifier: MIT
// A stretch of the host's memory that is zero and of which only touched pages are taken.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rasterloom::lockstep {

class HostPages {
  public:
    // Throws std::system_error if the host has no address space left.
    explicit HostPages(std::size_t words);
    ~HostPages();
    HostPages(const HostPages&) = delete;
    HostPages& operator=(const HostPages&) = delete;

    std::uint16_t* words() const { return words_; }  // on a page's boundary

  private:
    std::size_t bytes_;
    std::uint16_t* words_;
};

}  // namespace rasterloom::lockstep
