// SPDX-License-Identifier: MIT
#include "machine/node/guest_error.hpp"

#include <fmt/format.h>

namespace rasterloom {

std::string format_word(std::uint32_t value, int radix) {
    return radix == 8 ? fmt::format("{:06o}", value) : fmt::format("{:#06x}", value);
}

std::string GuestError::message() const {
    std::string text =
        fmt::format("guest error at {}: {} (node {}), cycle {}: {}\n  at {}", to_string(time()),
                    component(), details_.node, details_.cycle, details_.what,
                    format_word(details_.program_counter, details_.radix));
    if (details_.source) {
        text += fmt::format(", {}:{}", details_.source->file, details_.source->line);
    }
    text += details_.registers.empty() ? "" : "\n ";
    for (const auto& [name, value] : details_.registers) {
        text += fmt::format(" {}={}", name, format_word(value, details_.radix));
    }
    return text;
}

}  // namespace rasterloom
