// SPDX-License-Identifier: MIT
// Writes rows of numbers into the tables of a SQLite file on a thread of its own, in the order in
// which they were added. Rows wait in batches, of which only so many may wait.
#pragma once

#include "machine/observe/trace/bulk_table.hpp"
#include "machine/observe/trace/page_file.hpp"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <filesystem>
#include <initializer_list>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace rasterloom::observe {

class RowWriter {
  public:
    // Of a file with these tables, which are empty. Nobody else may use it before finish(). Throws
    // OutputError when it cannot be opened.
    RowWriter(const std::filesystem::path& path, const std::vector<std::string>& tables);
    RowWriter(const RowWriter&) = delete;
    RowWriter& operator=(const RowWriter&) = delete;
    ~RowWriter();

    // A row of the table with this number (BulkTable::add). Throws what an earlier row has failed
    // with.
    void add(std::size_t table, std::initializer_list<std::int64_t> values);
    // Waits until all rows are written, and writes the indices. Throws what a row has failed with.
    void finish();

  private:
    using Batch = std::vector<std::int64_t>;  // each row: its table, its values

    void hand_over();
    void work();
    void write(const Batch& batch);
    void end_thread();

    PageFile file_;
    std::deque<BulkTable> tables_;
    Batch filling_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Batch> waiting_;
    bool ends_ = false;
    std::exception_ptr failure_;
    std::thread thread_;
};

}  // namespace rasterloom::observe
