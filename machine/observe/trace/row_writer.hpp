// SPDX-License-Identifier: MIT
// Writes rows of numbers into the tables of a SQLite file.
#pragma once

#include "machine/observe/trace/bulk_table.hpp"
#include "machine/observe/trace/page_file.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

namespace rasterloom::observe {

class RowWriter {
  public:
    // Of a file with these tables, which are empty. Nobody else may use it before finish(). Throws
    // OutputError when it cannot be opened.
    RowWriter(const std::filesystem::path& path, const std::vector<std::string>& tables);
    RowWriter(const RowWriter&) = delete;
    RowWriter& operator=(const RowWriter&) = delete;

    // A row of the table with this number (BulkTable::add). This and the next throw OutputError
    // when there is no room.
    void add(std::size_t table, std::initializer_list<std::int64_t> values) {
        tables_[table].add({values.begin(), values.size()});
    }
    // Writes the indices.
    void finish();

  private:
    PageFile file_;
    std::deque<BulkTable> tables_;
};

}  // namespace rasterloom::observe
