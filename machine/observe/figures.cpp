// SPDX-License-Identifier: MIT
#include "machine/observe/figures.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::observe {

double seconds(Duration duration) {
    return static_cast<double>(duration.picoseconds()) / static_cast<double>(kPicosecondsPerSecond);
}

double share(Duration part, Duration whole) {
    return whole > Duration()
               ? static_cast<double>(part.picoseconds()) / static_cast<double>(whole.picoseconds())
               : 0;
}

std::string human(Duration duration) {
    constexpr std::array<std::pair<double, const char*>, 4> kUnits{
        std::pair{1.0, "s"}, std::pair{1e-3, "ms"}, std::pair{1e-6, "us"}, std::pair{1e-9, "ns"}};
    for (const auto& [size, unit] : kUnits) {
        if (seconds(duration) >= size) {
            return fmt::format("{:.4g} {}", seconds(duration) / size, unit);
        }
    }
    return fmt::format("{} ps", duration.picoseconds());
}

}  // namespace rasterloom::observe
