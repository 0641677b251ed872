// SPDX-License-Identifier: MIT
// Brings the keys of an index into order, however many there are: what does not fit into memory
// waits in a temporary file.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <future>
#include <memory>
#include <vector>

namespace rasterloom::observe {

class KeySorter {
  public:
    struct Key {
        std::int64_t first = 0;
        std::int64_t second = 0;
        std::int64_t rowid = 0;

        friend auto operator<=>(const Key&, const Key&) = default;
    };
    static constexpr std::size_t kMostInMemory = std::size_t{1} << 17;  // 3 MiB

    explicit KeySorter(std::size_t most_in_memory = kMostInMemory)
        : most_in_memory_(most_in_memory) {}

    // Throws OutputError when there is no room for a temporary file; so does the next.
    void add(const Key& key) {
        if (keys_.size() == keys_.capacity()) {
            make_room();
        }
        keys_.push_back(key);
    }
    // No more keys come: begins to bring them into order, on another thread.
    void close() {
        sorting_ = std::async(std::launch::async, [this] { sort(); });
    }
    // Tells all keys in order, and forgets them; after close().
    void visit(const std::function<void(const Key&)>& visitor);

  private:
    struct Closer {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    // Keys in order, in the file: those read, and where the others begin and end.
    struct Run {
        std::vector<Key> read;
        std::size_t next = 0;  // of them
        std::size_t from = 0;
        std::size_t to = 0;
    };

    void make_room();
    void sort();
    void put_aside();
    bool read_on(Run& run);

    std::size_t most_in_memory_;
    std::vector<Key> keys_;
    std::vector<Key> sorted_;  // room to sort them into
    std::unique_ptr<std::FILE, Closer> file_;
    std::vector<Run> runs_;
    std::future<void> sorting_;  // uses what stands above
};

}  // namespace rasterloom::observe
