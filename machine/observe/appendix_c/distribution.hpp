// SPDX-License-Identifier: MIT
// How often each whole number came: what Parks' appendix C prints of every quantity.
#pragma once

#include <cstdint>
#include <map>

namespace rasterloom::observe {

class Distribution {
  public:
    void add(std::int64_t value, std::int64_t times = 1);
    void add(const Distribution& other);

    std::int64_t points() const { return points_; }
    std::int64_t sum() const { return sum_; }
    // How often `value` came.
    std::int64_t count(std::int64_t value) const;
    const std::map<std::int64_t, std::int64_t>& counts() const { return counts_; }

    // 0 without data points. The variance is the mean of the squared deviations: the thesis divides
    // by the number of points, not by one less.
    double mean() const;
    double variance() const;
    double deviation() const;

    friend bool operator==(const Distribution&, const Distribution&) = default;

  private:
    std::map<std::int64_t, std::int64_t> counts_;
    std::int64_t points_ = 0;
    std::int64_t sum_ = 0;
};

}  // namespace rasterloom::observe
