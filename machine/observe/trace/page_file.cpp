// SPDX-License-Identifier: MIT
#include "machine/observe/trace/page_file.hpp"

#include "machine/observe/output_folder.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace rasterloom::observe {

namespace {

constexpr std::size_t kFlushAt = 1 << 18;   // bytes
constexpr std::size_t kLockByte = 1 << 30;  // SQLite leaves out the page in which this lies

// Places in the file's header.
constexpr std::size_t kHeader = 100, kPageSize = 16, kReadVersion = 19, kReserved = 20, kPages = 28,
                      kLargestRoot = 52;

std::uint32_t big_endian(const std::uint8_t* from, std::size_t bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
        value = value << 8U | from[i];
    }
    return value;
}

}  // namespace

PageFile::PageFile(std::filesystem::path path)
    : path_(std::move(path)), file_(::open(path_.c_str(), O_RDWR | O_CLOEXEC)) {
    std::array<std::uint8_t, kHeader> header{};
    if (file_ < 0 || ::pread(file_, header.data(), kHeader, 0) != ssize_t{kHeader}) {
        fail();
    }
    page_size_ = big_endian(header.data() + kPageSize, 2);
    page_size_ = page_size_ == 1 ? 1 << 16 : page_size_;
    pages_ = big_endian(header.data() + kPages, 4);
    if (header[kReadVersion] != 1 || header[kReserved] != 0 ||
        big_endian(header.data() + kLargestRoot, 4) != 0 ||
        std::filesystem::file_size(path_) != pages_ * page_size_) {
        throw OutputError(path_.string() + ": is a file that no pages can be added to");
    }
}

PageFile::~PageFile() {
    if (file_ >= 0) {
        ::close(file_);
    }
}

void PageFile::fail() const {
    throw OutputError(path_.string() + ": cannot be written: " + std::strerror(errno));
}

void PageFile::write(Bytes bytes, std::size_t at) {
    while (!bytes.empty()) {
        const ssize_t written = ::pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(at));
        if (written < 0 && errno != EINTR) {
            fail();
        }
        const auto size = static_cast<std::size_t>(std::max<ssize_t>(written, 0));
        bytes = bytes.subspan(size);
        at += size;
    }
}

void PageFile::flush() {
    write(waiting_, pages_ * page_size_ - waiting_.size());
    waiting_.clear();
}

std::uint32_t PageFile::append(Bytes page) {
    if (pages_ == kLockByte / page_size_) {
        waiting_.resize(waiting_.size() + page_size_);
        ++pages_;
    }
    waiting_.insert(waiting_.end(), page.begin(), page.end());
    const std::uint32_t number = ++pages_;
    if (waiting_.size() >= kFlushAt) {
        flush();
    }
    return number;
}

void PageFile::replace(std::uint32_t number, Bytes page) {
    write(page, (number - 1) * page_size_);
}

void PageFile::close() {
    flush();
    std::array<std::uint8_t, 4> pages{};
    put_big_endian(pages.data(), pages_, 4);
    write(pages, kPages);
    if (::close(std::exchange(file_, -1)) != 0) {
        fail();
    }
}

}  // namespace rasterloom::observe
