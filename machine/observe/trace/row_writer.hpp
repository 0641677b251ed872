// SPDX-License-Identifier: MIT
// Writes rows of numbers into a database on a thread of its own, in the order in which they were
// added: inserting a row takes longer than making it. Rows wait in batches, of which only so many
// may wait.
#pragma once

#include "machine/observe/database.hpp"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <initializer_list>
#include <limits>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace rasterloom::observe {

class RowWriter {
  public:
    // In place of a number: NULL.
    static constexpr std::int64_t kNull = std::numeric_limits<std::int64_t>::min();
    struct Table {
        std::string name;
        int columns = 0;
    };

    // The database must outlive this, and nobody else may use it before finish().
    RowWriter(const Database& database, const std::vector<Table>& tables);
    RowWriter(const RowWriter&) = delete;
    RowWriter& operator=(const RowWriter&) = delete;
    ~RowWriter();

    // A row of the table with this number, a value a column. Throws what an earlier row has failed
    // with.
    void add(std::size_t table, std::initializer_list<std::int64_t> values);
    // Waits until all rows are written. Throws what a row has failed with.
    void finish();

  private:
    using Batch = std::vector<std::int64_t>;  // each row: its table, its values

    void hand_over();
    void work();
    void write(const Batch& batch);
    void end_thread();

    struct Target {
        Statement insert;
        int columns;
    };

    std::vector<Target> targets_;
    Batch filling_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Batch> waiting_;
    bool ends_ = false;
    std::exception_ptr failure_;
    std::thread thread_;
};

}  // namespace rasterloom::observe
