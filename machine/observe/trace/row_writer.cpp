// SPDX-License-Identifier: MIT
#include "machine/observe/trace/row_writer.hpp"

namespace rasterloom::observe {

RowWriter::RowWriter(const std::filesystem::path& path, const std::vector<std::string>& tables)
    : file_(path) {
    const Database database = Database::open(path, Database::Access::read);
    for (const std::string& table : tables) {
        tables_.emplace_back(file_, BulkTable::layout_of(database, table));
    }
}

void RowWriter::finish() {
    for (BulkTable& table : tables_) {
        table.close();
    }
    for (BulkTable& table : tables_) {
        table.finish();
    }
    file_.close();
}

}  // namespace rasterloom::observe
