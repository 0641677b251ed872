// SPDX-License-Identifier: MIT
// What one bundle needs of another that stands before it in the source, so that both compute the
// same wherever a scheduler puts them.
#pragma once

#include "isa/vliw/bundle.hpp"

#include <cstdint>
#include <optional>

namespace rasterloom::isa::vliw {

// What a bundle reads and writes, apart from memory: a bit for each register, C, T, X, the video
// register, the procedure pointer, each counter.
struct Effects {
    std::uint64_t reads = 0;
    std::uint64_t writes = 0;
    bool minds_sleep = false;  // does something on the lanes that are awake only, or looks at them
    bool wakes = false;        // changes who is awake before all else: wake, toggle
    bool sleeps = false;       // ... after all else: slt, slf
};
Effects effects_of(const Bundle& bundle);

// How many bundles behind `first` the later `second` must come at least: 1, or 0, which is the same
// bundle; empty if any order will do. The second form is about the words of memory alone.
std::optional<int> distance(const Effects& first, const Effects& second);
std::optional<int> distance(const Bundle::Memory& first, const Bundle::Memory& second);

}  // namespace rasterloom::isa::vliw
