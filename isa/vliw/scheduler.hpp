// SPDX-License-Identifier: MIT
// Packs straight-line code into fewer bundles. A packed program computes what the source says: at
// every branch, call, `halt`, `line`, `frame` and `phase` all state is what it would have been.
//
// Blocks reach from what can be jumped to, or has a label, to the next, or to where the sequencer
// may leave; nothing moves from one to another. Within a block the bundles of the source, each kept
// in one piece, are put as early as their dependences, the slots and the ports allow, those first
// that most others wait for.
#pragma once

#include "isa/image.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace rasterloom::isa::vliw {

// From a label to the next.
struct PackedPart {
    std::string label;  // empty for what stands before the first
    std::int64_t operations = 0;
    std::int64_t bundles_before = 0;
    std::int64_t bundles = 0;
};

struct Packed {
    Image image;
    std::vector<PackedPart> parts;  // by address
};

// Segments stay where they begin; labels, branch targets, the entry and source lines go along. What
// a program computes from labels by itself (`size = end - start`, `mov r1, #label`) stays as it is.
// Throws std::invalid_argument as Program does.
Packed pack(const Image& image);

// A table: operations, bundles before and after, operations a bundle, of each part and in all.
std::string to_string(const std::vector<PackedPart>& parts);

}  // namespace rasterloom::isa::vliw
