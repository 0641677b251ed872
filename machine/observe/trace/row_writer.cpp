// SPDX-License-Identifier: MIT
#include "machine/observe/trace/row_writer.hpp"

#include <span>
#include <utility>

namespace rasterloom::observe {

namespace {

constexpr std::size_t kBatch = 1 << 13;    // numbers; malloc maps larger ones anew each time
constexpr std::size_t kMostWaiting = 128;  // batches: 8 MiB

}  // namespace

RowWriter::RowWriter(const std::filesystem::path& path, const std::vector<std::string>& tables)
    : file_(path) {
    const Database database = Database::open(path, Database::Access::read);
    for (const std::string& table : tables) {
        tables_.emplace_back(file_, BulkTable::layout_of(database, table));
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
    for (std::span<const std::int64_t> rest(batch); !rest.empty();) {
        BulkTable& table = tables_[static_cast<std::size_t>(rest[0])];
        table.add(rest.subspan(1, table.columns()));
        rest = rest.subspan(1 + table.columns());
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
    for (BulkTable& table : tables_) {
        table.finish();
    }
    file_.close();
}

}  // namespace rasterloom::observe
