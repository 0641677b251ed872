// SPDX-License-Identifier: MIT
// A line on the terminal that shows how far the run is; nothing when standard error is no terminal.
#pragma once

#include "machine/emulation/run.hpp"

namespace rasterloom::cli {

class ProgressBar {
  public:
    explicit ProgressBar(bool wanted);
    ~ProgressBar() { clear(); }
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    bool visible() const { return visible_; }
    void show(const emulation::Progress& progress);
    void clear();

  private:
    bool visible_;
    bool drawn_ = false;
};

}  // namespace rasterloom::cli
