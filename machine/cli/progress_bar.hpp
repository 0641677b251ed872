// SPDX-License-Identifier: MIT
// A line on the terminal that shows how far a run or a sweep is; nothing when standard error is no
// terminal.
#pragma once

#include "machine/emulation/run.hpp"
#include "machine/emulation/sweep.hpp"

#include <chrono>
#include <cstdint>
#include <string>

namespace rasterloom::cli {

class ProgressBar {
  public:
    explicit ProgressBar(bool wanted);
    ~ProgressBar() { clear(); }
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    bool visible() const { return visible_; }
    void show(const emulation::Progress& progress);
    void show(const emulation::SweepProgress& progress);
    void clear();

  private:
    void draw(std::int64_t done, std::int64_t steps, const std::string& text);

    bool visible_;
    bool drawn_ = false;
    std::chrono::steady_clock::time_point last_drawn_;
};

}  // namespace rasterloom::cli
