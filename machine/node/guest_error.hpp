// SPDX-License-Identifier: MIT
// The program of a node did what it may not: a value that the run returns, naming node, cycle,
// source line and registers.
#pragma once

#include "isa/image.hpp"
#include "machine/kernel/failure.hpp"
#include "topologies/topology.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rasterloom {

class GuestError final : public Failure {
  public:
    struct Details {
        topology::NodeIndex node = 0;
        std::int64_t cycle = 0;             // of the node's clock, stalls included
        std::uint32_t program_counter = 0;  // of the instruction that did it
        std::optional<isa::SourceLocation> source;
        std::vector<std::pair<std::string, std::uint32_t>> registers;  // empty: not known any more
        int radix = 8;     // in which the machine's people write addresses: 8 or 16
        std::string what;  // "odd address 000123"
    };
    GuestError(Time time, std::string component, Details details)
        : Failure(time, std::move(component)), details_(std::move(details)) {}

    const Details& details() const { return details_; }
    std::string message() const override;

  private:
    Details details_;
};

// A word as the machine's people write it: 000123 or 0x0053.
std::string format_word(std::uint32_t value, int radix);

}  // namespace rasterloom
