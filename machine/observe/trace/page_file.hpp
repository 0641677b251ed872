// SPDX-License-Identifier: MIT
// Appends pages to a file of SQLite that nobody has open.
#pragma once

#include "machine/observe/trace/sqlite_page.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace rasterloom::observe {

class PageFile {
  public:
    // Throws OutputError when the file cannot be opened, or is not as this expects: without
    // reserved bytes, not in WAL mode, not vacuumed by itself.
    explicit PageFile(std::filesystem::path path);
    PageFile(const PageFile&) = delete;
    PageFile& operator=(const PageFile&) = delete;
    ~PageFile();

    std::size_t page_size() const { return page_size_; }
    // Returns the page's number. This, and all that follow, throw OutputError when there is no
    // room.
    std::uint32_t append(Bytes page);
    // In place of a page that is there already.
    void replace(std::uint32_t number, Bytes page);
    // Tells the file how many pages it has.
    void close();

  private:
    void flush();
    void write(Bytes bytes, std::size_t at);
    [[noreturn]] void fail() const;

    std::filesystem::path path_;
    int file_ = -1;
    std::size_t page_size_ = 0;
    std::uint32_t pages_ = 0;
    std::vector<std::uint8_t> waiting_;  // the last of them, not written yet
};

}  // namespace rasterloom::observe
