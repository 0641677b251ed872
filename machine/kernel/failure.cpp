// SPDX-License-Identifier: MIT
#include "machine/kernel/failure.hpp"

#include <array>
#include <cstdint>

#include <fmt/format.h>

namespace rasterloom {

std::string Deadlock::message() const {
    std::string text = fmt::format(
        "deadlock at {}: no event is left, and {} component{} wait{}", to_string(time()),
        waiters_.size(), waiters_.size() == 1 ? "" : "s", waiters_.size() == 1 ? "s" : "");
    for (const Waiter& waiter : waiters_) {
        text += fmt::format("\n  {} waits for {}", waiter.component, waiter.waits_for);
    }
    return text;
}

InvariantError::InvariantError(Time time, const std::string& component, const std::string& what)
    : std::logic_error("at " + to_string(time) + ", " + component + ": " + what) {}

std::string to_string(Duration duration) {
    struct Unit {
        std::int64_t picoseconds;
        int digits;
        const char* name;
    };
    static constexpr std::array<Unit, 5> kUnits = {{{1'000'000'000'000, 12, "s"},
                                                    {1'000'000'000, 9, "ms"},
                                                    {1'000'000, 6, "us"},
                                                    {1'000, 3, "ns"},
                                                    {1, 0, "ps"}}};
    const std::int64_t count = duration.picoseconds();
    const std::uint64_t magnitude =
        count < 0 ? 0 - static_cast<std::uint64_t>(count) : static_cast<std::uint64_t>(count);
    for (const Unit& unit : kUnits) {
        const auto one = static_cast<std::uint64_t>(unit.picoseconds);
        if (magnitude < one && one > 1) {
            continue;
        }
        std::string text = fmt::format("{}{}", count < 0 ? "-" : "", magnitude / one);
        if (magnitude % one != 0) {
            text += fmt::format(".{:0{}}", magnitude % one, unit.digits);
            text.erase(text.find_last_not_of('0') + 1);
        }
        return fmt::format("{} {}", text, unit.name);
    }
    return "0 ps";
}

std::string to_string(Time time) {
    return to_string(time.since_start());
}

}  // namespace rasterloom
