// SPDX-License-Identifier: MIT
// Builds one b-tree of a SQLite file from rows that come in the order of their keys: each page is
// written once, when it is full. That takes a tenth of what it takes SQLite to insert them.
#pragma once

#include "machine/observe/trace/page_file.hpp"
#include "machine/observe/trace/sqlite_page.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace rasterloom::observe {

class TreeBuilder {
  public:
    enum class Kind : std::uint8_t { table, index };

    // In place of the empty tree whose root is this page. A record must not take more than a
    // quarter of a page, in an index an eighth: what is longer SQLite would cut into pieces.
    TreeBuilder(PageFile& file, std::uint32_t root, Kind kind);

    // To a table.
    void add(std::int64_t rowid, Bytes record);
    // To an index, or to a table WITHOUT ROWID, which is one.
    void add(Bytes record);
    void finish();

  private:
    using Key = std::vector<std::uint8_t>;
    // A page that is full, and the key between it and the next. It waits until that has a cell,
    // for SQLite takes a page without any for a damaged one.
    struct Full {
        TreePage page;
        Key key;
    };
    struct Level {
        TreePage page;
        std::optional<Full> full;
    };

    Level& level(std::size_t number);
    void add_cell(std::size_t number, Bytes first, Bytes key);
    void add_child(std::size_t number, std::uint32_t child, Bytes key);
    void settle(std::size_t number);
    void fill_last_page(Level& last);

    PageFile& file_;
    std::uint32_t root_;
    Kind kind_;
    std::deque<Level> levels_;  // from the leaves up
    std::int64_t last_rowid_ = 0;
};

}  // namespace rasterloom::observe
