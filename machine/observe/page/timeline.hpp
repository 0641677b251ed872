// SPDX-License-Identifier: MIT
// Many quantities over a run, each as its integral over equal bins of time. How long the run will
// be is not known before: when it outgrows the bins, they merge pairwise and are twice as wide from
// then on. All of it is integers, so the result depends neither on the order in which things are
// added nor on when the bins merged, and memory stays as it is from the start.
#pragma once

#include "machine/kernel/time.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rasterloom::observe {

class Timeline {
  public:
    // Throws std::invalid_argument unless the width is above zero and the bins are an even number.
    Timeline(std::size_t tracks, Duration first_width, std::size_t most_bins);

    // The quantity is greater by `amount` from `from` until `to`.
    void add(std::size_t track, Time from, Time to, std::int64_t amount = 1);

    Duration width() const { return width_; }  // of a bin: the first one times a power of two
    Time end() const { return end_; }          // the latest `to` so far
    // Bins up to the end; the last one may reach beyond it.
    std::size_t bins() const;
    // Amount times picoseconds, of one bin and of the whole run.
    std::int64_t integral(std::size_t track, std::size_t bin) const {
        return cells_[track * most_bins_ + bin];
    }
    std::int64_t total(std::size_t track) const;

  private:
    void reach(Time to);
    void merge_pairs();

    std::size_t most_bins_;
    Duration width_;
    Time end_;
    std::vector<std::int64_t> cells_;  // [track][bin]
};

}  // namespace rasterloom::observe
