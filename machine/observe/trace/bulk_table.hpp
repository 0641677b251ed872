// SPDX-License-Identifier: MIT
// Fills one empty table of a SQLite file, and its indices, without SQLite: rows are numbers, and
// all are there before anybody asks.
#pragma once

#include "machine/observe/database.hpp"
#include "machine/observe/trace/key_sorter.hpp"
#include "machine/observe/trace/page_file.hpp"
#include "machine/observe/trace/tree_builder.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <vector>

namespace rasterloom::observe {

class BulkTable {
  public:
    // What SQLite's schema says of a table: where its tree and those of its indices begin.
    struct Layout {
        struct Index {
            std::uint32_t root = 0;
            std::vector<std::size_t> columns;  // one or two
        };
        std::size_t columns = 0;
        std::uint32_t root = 0;
        bool has_rowid = true;
        bool first_is_rowid = false;  // INTEGER PRIMARY KEY
        std::vector<Index> indices;
    };
    // Throws std::invalid_argument when it is a table that this cannot fill.
    static Layout layout_of(const Database& database, const std::string& table);

    BulkTable(PageFile& file, Layout layout);

    // A row, a value a column, kSqlNull for NULL: of a table whose primary key is the first columns
    // in the order of those.
    void add(std::span<const std::int64_t> values);
    // No more rows come: begins to put its indices in order, on other threads.
    void close();
    // Writes the last pages and the indices.
    void finish();
    std::size_t columns() const { return layout_.columns; }

  private:
    PageFile& file_;
    Layout layout_;
    TreeBuilder tree_;
    std::deque<KeySorter> keys_;  // of each index
    std::int64_t rows_ = 0;
    std::int64_t last_rowid_ = 0;
};

}  // namespace rasterloom::observe
