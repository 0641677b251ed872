// SPDX-License-Identifier: MIT
#include "machine/observe/trace/key_sorter.hpp"

#include "machine/observe/output_folder.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace rasterloom::observe {

namespace {

constexpr int kBucketBits = 12;
constexpr std::size_t kReadAtOnce = 1 << 10;  // keys of one run: 24 KiB

[[noreturn]] void fail() {
    throw OutputError("a temporary file cannot be written: no room?");
}

}  // namespace

// All at once: memory that is not used yet costs nothing, copies of what is there do.
void KeySorter::make_room() {
    if (!keys_.empty()) {
        sort();
        put_aside();
    }
    keys_.reserve(most_in_memory_);
}

// By the highest bits of the first column, in which they differ, into buckets; and each bucket by
// itself. Keys come by time, so that most buckets are nearly in order.
void KeySorter::sort() {
    if (keys_.empty()) {
        return;
    }
    const auto [least, most] = std::minmax_element(
        keys_.begin(), keys_.end(), [](const Key& a, const Key& b) { return a.first < b.first; });
    const auto base = static_cast<std::uint64_t>(least->first);
    const std::uint64_t range = static_cast<std::uint64_t>(most->first) - base;
    const int shift = std::max(0, static_cast<int>(std::bit_width(range)) - kBucketBits);
    const auto bucket_of = [&](const Key& key) {
        return static_cast<std::size_t>((static_cast<std::uint64_t>(key.first) - base) >> shift);
    };
    std::vector<std::size_t> ends((range >> shift) + 1);
    for (const Key& key : keys_) {
        ++ends[bucket_of(key)];
    }
    std::size_t end = 0;
    for (std::size_t& bucket : ends) {
        bucket = std::exchange(end, end + bucket);  // where it begins, up to now
    }
    sorted_.resize(keys_.size());
    for (const Key& key : keys_) {
        sorted_[ends[bucket_of(key)]++] = key;
    }
    auto from = sorted_.begin();
    for (const std::size_t bucket : ends) {
        const auto to = sorted_.begin() + static_cast<std::ptrdiff_t>(bucket);
        if (!std::is_sorted(from, to)) {
            std::sort(from, to);
        }
        from = to;
    }
    keys_.swap(sorted_);
}

void KeySorter::put_aside() {
    if (!file_) {
        file_.reset(std::tmpfile());
    }
    const std::size_t from = runs_.empty() ? 0 : runs_.back().to;
    if (!file_ ||
        std::fwrite(keys_.data(), sizeof(Key), keys_.size(), file_.get()) != keys_.size()) {
        fail();
    }
    runs_.push_back({{}, 0, from, from + keys_.size()});
    keys_.clear();
}

// False: nothing of it is left.
bool KeySorter::read_on(Run& run) {
    run.read.resize(std::min(kReadAtOnce, run.to - run.from));
    run.next = 0;
    if (run.read.empty()) {
        return false;
    }
    if (std::fseek(file_.get(), static_cast<long>(run.from * sizeof(Key)), SEEK_SET) != 0 ||
        std::fread(run.read.data(), sizeof(Key), run.read.size(), file_.get()) != run.read.size()) {
        fail();
    }
    run.from += run.read.size();
    return true;
}

void KeySorter::visit(const std::function<void(const Key&)>& visitor) {
    sorting_.get();
    if (runs_.empty()) {
        std::for_each(keys_.begin(), keys_.end(), visitor);
        keys_.clear();
        return;
    }
    put_aside();
    // A heap of runs: that with the least key first.
    const auto later = [](const Run* a, const Run* b) {
        return a->read[a->next] > b->read[b->next];
    };
    std::vector<Run*> heap;
    for (Run& run : runs_) {
        if (read_on(run)) {
            heap.push_back(&run);
        }
    }
    std::make_heap(heap.begin(), heap.end(), later);
    while (!heap.empty()) {
        std::pop_heap(heap.begin(), heap.end(), later);
        Run& first = *heap.back();
        visitor(first.read[first.next++]);
        if (first.next == first.read.size() && !read_on(first)) {
            heap.pop_back();
        } else {
            std::push_heap(heap.begin(), heap.end(), later);
        }
    }
    runs_.clear();
    file_.reset();
}

}  // namespace rasterloom::observe
