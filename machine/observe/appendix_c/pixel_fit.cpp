// SPDX-License-Identifier: MIT
#include "machine/observe/appendix_c/pixel_fit.hpp"

namespace rasterloom::observe {

void PixelFit::add(std::int64_t drawn, std::int64_t hidden, std::int64_t cycles) {
    ++runs_;
    drawn_ += drawn;
    hidden_ += hidden;
    cycles_ += cycles;
    drawn_drawn_ += drawn * drawn;
    drawn_hidden_ += drawn * hidden;
    hidden_hidden_ += hidden * hidden;
    drawn_cycles_ += drawn * cycles;
    hidden_cycles_ += hidden * cycles;
}

void PixelFit::add(const PixelFit& other) {
    runs_ += other.runs_;
    drawn_ += other.drawn_;
    hidden_ += other.hidden_;
    cycles_ += other.cycles_;
    drawn_drawn_ += other.drawn_drawn_;
    drawn_hidden_ += other.drawn_hidden_;
    hidden_hidden_ += other.hidden_hidden_;
    drawn_cycles_ += other.drawn_cycles_;
    hidden_cycles_ += other.hidden_cycles_;
}

// The normal equations, the runs' own cost eliminated: covariances about the means.
std::optional<PixelCosts> PixelFit::solve() const {
    if (runs_ == 0) {
        return std::nullopt;
    }
    const auto n = static_cast<double>(runs_);
    const auto d = static_cast<double>(drawn_) / n;
    const auto h = static_cast<double>(hidden_) / n;
    const auto t = static_cast<double>(cycles_) / n;
    const double dd = static_cast<double>(drawn_drawn_) / n - d * d;
    const double dh = static_cast<double>(drawn_hidden_) / n - d * h;
    const double hh = static_cast<double>(hidden_hidden_) / n - h * h;
    const double dt = static_cast<double>(drawn_cycles_) / n - d * t;
    const double ht = static_cast<double>(hidden_cycles_) / n - h * t;
    const double determinant = dd * hh - dh * dh;
    constexpr double kSingular = 1e-9;  // against what rounding leaves of an exact zero
    if (determinant <= kSingular * (1 + dd * hh)) {
        return std::nullopt;
    }
    PixelCosts costs;
    costs.drawn = (dt * hh - ht * dh) / determinant;
    costs.hidden = (ht * dd - dt * dh) / determinant;
    costs.run = t - costs.drawn * d - costs.hidden * h;
    return costs;
}

}  // namespace rasterloom::observe
