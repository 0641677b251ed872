// SPDX-License-Identifier: MIT
#include "machine/observe/trace/row_writer.hpp"

#include <utility>

#include <fmt/format.h>

namespace rasterloom::observe {

namespace {

constexpr std::size_t kBatch = 1 << 13;    // numbers; malloc maps larger ones anew each time
constexpr std::size_t kMostWaiting = 128;  // batches: 8 MiB

std::string insertion(const RowWriter::Table& table) {
    std::string values = "?";
    for (int column = 1; column < table.columns; ++column) {
        values += ", ?";
    }
    return fmt::format("INSERT INTO {} VALUES ({})", table.name, values);
}

}  // namespace

RowWriter::RowWriter(const Database& database, const std::vector<Table>& tables) {
    for (const Table& table : tables) {
        targets_.push_back({database.prepare(insertion(table)), table.columns});
    }
    filling_.reserve(kBatch);
    thread_ = std::thread([this] { work(); });
}

RowWriter::~RowWriter() {
    end_thread();
}

void RowWriter::add(std::size_t table, std::initializer_list<std::int64_t> values) {
    filling_.push_back(static_cast<std::int64_t>(table));
    filling_.insert(filling_.end(), values);
    if (filling_.size() + 32 > kBatch) {
        hand_over();
    }
}

void RowWriter::hand_over() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.size() < kMostWaiting || failure_ != nullptr; });
    if (failure_ != nullptr) {
        std::rethrow_exception(failure_);
    }
    waiting_.push_back(std::exchange(filling_, {}));
    lock.unlock();
    changed_.notify_all();
    filling_.reserve(kBatch);
}

void RowWriter::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return !waiting_.empty() || ends_; });
        if (waiting_.empty()) {
            return;
        }
        const Batch batch = std::move(waiting_.front());
        waiting_.pop_front();
        lock.unlock();
        changed_.notify_all();
        std::exception_ptr failure;
        try {
            write(batch);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        if (failure != nullptr) {
            failure_ = failure;
            changed_.notify_all();
            return;
        }
    }
}

void RowWriter::write(const Batch& batch) {
    for (std::size_t at = 0; at < batch.size();) {
        Target& target = targets_[static_cast<std::size_t>(batch[at++])];
        for (int column = 1; column <= target.columns; ++column) {
            const std::int64_t value = batch[at++];
            value == kNull ? target.insert.bind(column, nullptr)
                           : target.insert.bind(column, value);
        }
        target.insert.run();
    }
}

void RowWriter::end_thread() {
    if (thread_.joinable()) {
        {
            const std::lock_guard lock(mutex_);
            ends_ = true;
        }
        changed_.notify_all();
        thread_.join();
    }
}

void RowWriter::finish() {
    hand_over();
    end_thread();
    if (failure_ != nullptr) {
        std::rethrow_exception(failure_);
    }
    targets_.clear();
}

}  // namespace rasterloom::observe
