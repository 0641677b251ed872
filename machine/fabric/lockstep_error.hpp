// SPDX-License-Identifier: MIT
// The program of a lock-step array did what it may not: a value that the run returns, naming cycle,
// scanline, program counter and source line.
#pragma once

#include "isa/image.hpp"
#include "machine/kernel/failure.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace rasterloom {

class LockstepError final : public Failure {
  public:
    struct Details {
        std::int64_t cycle = 0;             // of the machine's clock
        std::int64_t scanline = 0;          // since the start
        std::uint32_t program_counter = 0;  // of the bundle that did it
        std::optional<isa::SourceLocation> source;
        std::string what;  // "call stack is full"
    };
    LockstepError(Time time, std::string component, Details details)
        : Failure(time, std::move(component)), details_(std::move(details)) {}

    const Details& details() const { return details_; }
    std::string message() const override;

  private:
    Details details_;
};

// The program's label at or nearest before `address`; "0x0012" where there is none.
std::string label_before(const isa::Image& image, std::uint32_t address);

}  // namespace rasterloom
