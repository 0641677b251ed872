// SPDX-License-Identifier: MIT
#include "machine/observe/page/timeline.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace rasterloom::observe {

Timeline::Timeline(std::size_t tracks, Duration first_width, std::size_t most_bins)
    : most_bins_(most_bins), width_(first_width), cells_(tracks * most_bins) {
    if (first_width <= Duration() || most_bins == 0 || most_bins % 2 != 0) {
        throw std::invalid_argument("a timeline has an even number of bins wider than nothing");
    }
}

void Timeline::add(std::size_t track, Time from, Time to, std::int64_t amount) {
    if (to <= from) {
        return;
    }
    reach(to);
    const std::int64_t width = width_.picoseconds();
    std::int64_t* bins = &cells_[track * most_bins_];
    const std::int64_t last = (to.picoseconds() - 1) / width;
    std::int64_t at = from.picoseconds();
    for (std::int64_t bin = at / width; bin <= last; ++bin) {
        const std::int64_t until = std::min(to.picoseconds(), (bin + 1) * width);
        bins[bin] += (until - at) * amount;
        at = until;
    }
}

std::size_t Timeline::bins() const {
    const std::int64_t width = width_.picoseconds();
    return static_cast<std::size_t>((end_.picoseconds() + width - 1) / width);
}

std::int64_t Timeline::total(std::size_t track) const {
    const auto first = cells_.begin() + static_cast<std::ptrdiff_t>(track * most_bins_);
    return std::accumulate(first, first + static_cast<std::ptrdiff_t>(most_bins_), std::int64_t{0});
}

void Timeline::reach(Time to) {
    end_ = std::max(end_, to);
    while (bins() > most_bins_) {
        merge_pairs();
    }
}

void Timeline::merge_pairs() {
    for (auto track = cells_.begin(); track != cells_.end();
         track += static_cast<std::ptrdiff_t>(most_bins_)) {
        const auto half = track + static_cast<std::ptrdiff_t>(most_bins_ / 2);
        auto pair = track;
        for (auto merged = track; merged != half; ++merged, pair += 2) {
            *merged = pair[0] + pair[1];
        }
        std::fill(half, half + (half - track), 0);
    }
    width_ = width_ * 2;
}

}  // namespace rasterloom::observe
