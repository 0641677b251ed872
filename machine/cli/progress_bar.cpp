// SPDX-License-Identifier: MIT
#include "machine/cli/progress_bar.hpp"

#include "machine/kernel/failure.hpp"

#include <cstdio>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

namespace rasterloom::cli {

ProgressBar::ProgressBar(bool wanted) : visible_(wanted && ::isatty(STDERR_FILENO) == 1) {}

void ProgressBar::show(const emulation::Progress& progress) {
    if (!visible_) {
        return;
    }
    constexpr std::int64_t kWidth = 30;
    const std::int64_t steps = progress.frames * progress.phases;
    const std::int64_t done = progress.frame * progress.phases + progress.phase;
    const auto filled = static_cast<std::size_t>(kWidth * done / steps);
    const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
    fmt::print(stderr, "\r[{}] frame {}/{}, phase {}/{}, machine time {}\x1b[K", bar,
               progress.frame + 1, progress.frames, progress.phase + 1, progress.phases,
               to_string(progress.now));
    std::fflush(stderr);
    drawn_ = true;
}

void ProgressBar::clear() {
    if (drawn_) {
        fmt::print(stderr, "\r\x1b[K");
        std::fflush(stderr);
        drawn_ = false;
    }
}

}  // namespace rasterloom::cli
