// SPDX-License-Identifier: MIT
#include "machine/fabric/lockstep_error.hpp"

#include "machine/node/guest_error.hpp"

#include <fmt/format.h>

namespace rasterloom {

namespace {

constexpr int kRadix = 16;

}  // namespace

std::string LockstepError::message() const {
    std::string text =
        fmt::format("guest error at {}: {}, cycle {}, scanline {}: {}\n  at {}", to_string(time()),
                    component(), details_.cycle, details_.scanline, details_.what,
                    format_word(details_.program_counter, kRadix));
    if (details_.source) {
        text += fmt::format(", {}:{}", details_.source->file, details_.source->line);
    }
    return text;
}

std::string label_before(const isa::Image& image, std::uint32_t address) {
    const std::string* nearest = nullptr;
    std::uint32_t at = 0;
    for (const std::string& label : image.labels) {
        const std::uint32_t value = *image.symbol(label);
        if (value <= address && (nearest == nullptr || value > at)) {
            nearest = &label;
            at = value;
        }
    }
    return nearest != nullptr ? *nearest : format_word(address, kRadix);
}

}  // namespace rasterloom
