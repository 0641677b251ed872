// SPDX-License-Identifier: MIT
#include "machine/observe/appendix_c/distribution.hpp"

#include <cmath>

namespace rasterloom::observe {

void Distribution::add(std::int64_t value, std::int64_t times) {
    if (times == 0) {
        return;
    }
    counts_[value] += times;
    points_ += times;
    sum_ += value * times;
}

void Distribution::add(const Distribution& other) {
    for (const auto& [value, times] : other.counts_) {
        add(value, times);
    }
}

std::int64_t Distribution::count(std::int64_t value) const {
    const auto found = counts_.find(value);
    return found == counts_.end() ? 0 : found->second;
}

double Distribution::mean() const {
    return points_ == 0 ? 0 : static_cast<double>(sum_) / static_cast<double>(points_);
}

double Distribution::variance() const {
    if (points_ == 0) {
        return 0;
    }
    const double middle = mean();
    double squares = 0;
    for (const auto& [value, times] : counts_) {
        const double away = static_cast<double>(value) - middle;
        squares += away * away * static_cast<double>(times);
    }
    return squares / static_cast<double>(points_);
}

double Distribution::deviation() const {
    return std::sqrt(variance());
}

}  // namespace rasterloom::observe
