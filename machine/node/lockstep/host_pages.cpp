// SPDX-License-Identifier: MIT
#include "machine/node/lockstep/host_pages.hpp"

#include <cerrno>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <sys/mman.h>

namespace rasterloom::lockstep {
namespace {

// Up to here the host may back the pages by large ones: fewer misses in its tables of addresses.
// Beyond, a few touched words a lane would take whole large pages.
constexpr std::size_t kLargePagesUpTo = std::size_t{512} << 20U;

}  // namespace

HostPages::HostPages(std::size_t words) : bytes_(words * sizeof(std::uint16_t)) {
    void* const pages = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (pages == MAP_FAILED) {
        throw std::system_error(
            errno, std::generic_category(),
            fmt::format("cannot reserve {} MB of address space for lane memory", bytes_ >> 20U));
    }
    if (bytes_ <= kLargePagesUpTo) {
        madvise(pages, bytes_, MADV_HUGEPAGE);  // a wish: without it all is the same but slower
    }
    words_ = static_cast<std::uint16_t*>(pages);
}

HostPages::~HostPages() {
    munmap(words_, bytes_);
}

}  // namespace rasterloom::lockstep
