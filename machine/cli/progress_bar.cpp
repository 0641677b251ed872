// SPDX-License-Identifier: MIT
#include "machine/cli/progress_bar.hpp"

#include "machine/kernel/failure.hpp"

#include <cstdio>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

namespace rasterloom::cli {

namespace {

constexpr std::chrono::milliseconds kLeastApart{50};

}  // namespace

ProgressBar::ProgressBar(bool wanted) : visible_(wanted && ::isatty(STDERR_FILENO) == 1) {}

void ProgressBar::draw(std::int64_t done, std::int64_t steps, const std::string& text) {
    const auto now = std::chrono::steady_clock::now();
    if (!visible_ || (drawn_ && now - last_drawn_ < kLeastApart)) {
        return;
    }
    last_drawn_ = now;
    constexpr std::int64_t kWidth = 30;
    const auto filled = static_cast<std::size_t>(kWidth * done / steps);
    const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
    fmt::print(stderr, "\r[{}] {}\x1b[K", bar, text);
    std::fflush(stderr);
    drawn_ = true;
}

void ProgressBar::show(const emulation::Progress& progress) {
    draw(
        progress.frame * progress.phases + progress.phase, progress.frames * progress.phases,
        fmt::format("frame {}/{}, phase {}/{}, machine time {}", progress.frame + 1,
                    progress.frames, progress.phase + 1, progress.phases, to_string(progress.now)));
}

void ProgressBar::show(const emulation::SweepProgress& progress) {
    std::string text = fmt::format("{} of {} points", progress.done, progress.points);
    if (progress.failed > 0) {
        text += fmt::format(", {} failed", progress.failed);
    }
    if (const auto left = static_cast<std::int64_t>(progress.seconds_left()); left > 0) {
        constexpr std::int64_t kHour = 3600;
        text += left >= kHour ? fmt::format(", {} h {} min left", left / kHour, left % kHour / 60)
                              : fmt::format(", {}:{:02} min left", left / 60, left % 60);
    }
    draw(static_cast<std::int64_t>(progress.done), static_cast<std::int64_t>(progress.points),
         text);
}

void ProgressBar::clear() {
    if (drawn_) {
        fmt::print(stderr, "\r\x1b[K");
        std::fflush(stderr);
        drawn_ = false;
    }
}

}  // namespace rasterloom::cli
