// SPDX-License-Identifier: MIT
// What a pixel costs that is drawn, and one that is hidden: least squares over the runs of two
// pixels and more that a processor went through,
//
//     cycles = a run + drawn x pixels drawn + hidden x pixels hidden
//
// kept as sums of whole numbers, so that fits of several processors add up.
#pragma once

#include <cstdint>
#include <optional>

namespace rasterloom::observe {

struct PixelCosts {
    double run = 0;  // entering and leaving the loop
    double drawn = 0;
    double hidden = 0;
};

class PixelFit {
  public:
    void add(std::int64_t drawn, std::int64_t hidden, std::int64_t cycles);
    void add(const PixelFit& other);

    std::int64_t runs() const { return runs_; }
    // None while the runs do not determine all three, as when nothing was ever hidden.
    std::optional<PixelCosts> solve() const;

  private:
    std::int64_t runs_ = 0;
    std::int64_t drawn_ = 0;
    std::int64_t hidden_ = 0;
    std::int64_t cycles_ = 0;
    std::int64_t drawn_drawn_ = 0;
    std::int64_t drawn_hidden_ = 0;
    std::int64_t hidden_hidden_ = 0;
    std::int64_t drawn_cycles_ = 0;
    std::int64_t hidden_cycles_ = 0;
};

}  // namespace rasterloom::observe
