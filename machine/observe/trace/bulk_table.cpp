// SPDX-License-Identifier: MIT
#include "machine/observe/trace/bulk_table.hpp"

#include "machine/observe/trace/sqlite_page.hpp"

#include <stdexcept>
#include <utility>

namespace rasterloom::observe {

namespace {

std::vector<std::size_t> columns_of_index(const Database& database, const std::string& index) {
    std::vector<std::size_t> columns;
    Statement statement = database.prepare("SELECT cid FROM pragma_index_info(?) ORDER BY seqno");
    statement.bind(1, std::string_view(index));
    while (statement.step()) {
        columns.push_back(static_cast<std::size_t>(statement.column<std::int64_t>(0)));
    }
    return columns;
}

}  // namespace

BulkTable::Layout BulkTable::layout_of(const Database& database, const std::string& table) {
    Layout layout;
    Statement columns = database.prepare("SELECT pk, type FROM pragma_table_info(?) ORDER BY cid");
    columns.bind(1, std::string_view(table));
    std::size_t keys = 0;
    while (columns.step()) {
        const bool is_key = columns.column<std::int64_t>(0) != 0;
        if (columns.column<std::string>(1) != "INTEGER" || (is_key && keys != layout.columns)) {
            throw std::invalid_argument(table +
                                        ": not all columns are numbers, or the key is behind");
        }
        keys += is_key ? 1 : 0;
        ++layout.columns;
    }
    Statement list = database.prepare("SELECT wr FROM pragma_table_list(?)");
    list.bind(1, std::string_view(table));
    layout.has_rowid = list.step() && list.column<std::int64_t>(0) == 0;
    layout.first_is_rowid = layout.has_rowid && keys == 1;
    Statement roots = database.prepare(
        "SELECT type, name, rootpage FROM sqlite_schema WHERE tbl_name = ? AND rootpage <> 0");
    roots.bind(1, std::string_view(table));
    while (roots.step()) {
        const auto root = static_cast<std::uint32_t>(roots.column<std::int64_t>(2));
        if (roots.column<std::string>(0) == "table") {
            layout.root = root;
        } else {
            layout.indices.push_back(
                {root, columns_of_index(database, roots.column<std::string>(1))});
        }
    }
    if (layout.root == 0 || layout.columns > SqliteRecord::kMostValues) {
        throw std::invalid_argument(table + ": no table, or one of too many columns");
    }
    for (const Layout::Index& index : layout.indices) {
        if (index.columns.empty() || index.columns.size() > 2 || !layout.has_rowid) {
            throw std::invalid_argument(table + ": an index is not of one or two columns");
        }
    }
    return layout;
}

BulkTable::BulkTable(PageFile& file, Layout layout)
    : file_(file),
      layout_(std::move(layout)),
      tree_(file, layout_.root,
            layout_.has_rowid ? TreeBuilder::Kind::table : TreeBuilder::Kind::index),
      keys_(layout_.indices.size()) {}

void BulkTable::add(std::span<const std::int64_t> values) {
    SqliteRecord record(values.size());
    ++rows_;
    std::int64_t rowid = rows_;
    std::span<const std::int64_t> stored = values;
    if (layout_.first_is_rowid) {
        if (rows_ > 1 && values[0] <= last_rowid_) {
            throw std::logic_error("rows come in the order of their numbers");
        }
        last_rowid_ = rowid = values[0];
        record.add(kSqlNull);
        stored = values.subspan(1);
    }
    for (const std::int64_t value : stored) {
        record.add(value);
    }
    if (!layout_.has_rowid) {
        tree_.add(record.bytes());
        return;
    }
    tree_.add(rowid, record.bytes());
    for (std::size_t index = 0; index < keys_.size(); ++index) {
        const std::vector<std::size_t>& columns = layout_.indices[index].columns;
        keys_[index].add({values[columns[0]], columns.size() > 1 ? values[columns[1]] : 0, rowid});
    }
}

void BulkTable::close() {
    for (KeySorter& keys : keys_) {
        keys.close();
    }
}

void BulkTable::finish() {
    tree_.finish();
    for (std::size_t index = 0; index < keys_.size(); ++index) {
        const Layout::Index& layout = layout_.indices[index];
        TreeBuilder tree(file_, layout.root, TreeBuilder::Kind::index);
        keys_[index].visit([&](const KeySorter::Key& key) {
            SqliteRecord record(layout.columns.size() + 1);
            record.add(key.first);
            if (layout.columns.size() > 1) {
                record.add(key.second);
            }
            record.add(key.rowid);
            tree.add(record.bytes());
        });
        tree.finish();
    }
}

}  // namespace rasterloom::observe
