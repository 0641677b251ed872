// SPDX-License-Identifier: MIT
// What a bundle becomes for a block of lanes: a few operations, each a pass over one row of
// registers, in an order in which nothing is overwritten that a later one still reads.
#pragma once

#include "isa/vliw/bundle.hpp"

#include <cstddef>
#include <cstdint>

namespace rasterloom::lockstep {

// Rows of a block of lanes, one value a lane. Registers come first, by their numbers.
inline constexpr int kScratchRow = isa::vliw::kRegisters;  // results on their way: one a slot
inline constexpr int kScratchRows = 4;
inline constexpr int kVideoRow = kScratchRow + kScratchRows;
inline constexpr int kAwakeRow = kVideoRow + 1;  // cycles awake that are not in the totals yet
inline constexpr int kRows = kAwakeRow + 1;

// Which bits of the product the picker takes; each has a kernel of its own.
enum class ProductPart : std::uint8_t { low, middle, high };  // pick 0, 1 ... 15, 16 ... 31
inline constexpr int kProductParts = 3;

using Code = std::uint8_t;

// Value operations, then tests by mode, then products; each without and with an immediate.
inline constexpr int kValueCodes = static_cast<int>(isa::vliw::AluOp::teq) * 2;
inline constexpr int kTests = isa::vliw::kAluOps - static_cast<int>(isa::vliw::AluOp::teq);
inline constexpr int kFirstTestCode = kValueCodes;
inline constexpr int kFirstProductCode = kFirstTestCode + kTests * 3 * 2;
inline constexpr int kRegisterCodes = kFirstProductCode + 3 * kProductParts * 2;

constexpr Code value_code(isa::vliw::AluOp op, bool immediate) {
    return static_cast<Code>(static_cast<int>(op) * 2 + (immediate ? 1 : 0));
}
constexpr Code test_code(isa::vliw::AluOp op, isa::vliw::TestMode mode, bool immediate) {
    const int test = static_cast<int>(op) - static_cast<int>(isa::vliw::AluOp::teq);
    return static_cast<Code>(kFirstTestCode + (test * 3 + static_cast<int>(mode)) * 2 +
                             (immediate ? 1 : 0));
}
constexpr Code product_code(isa::vliw::MulOp op, ProductPart part, bool immediate) {
    const int product = static_cast<int>(op) - 1;
    return static_cast<Code>(kFirstProductCode +
                             (product * kProductParts + static_cast<int>(part)) * 2 +
                             (immediate ? 1 : 0));
}

// Operations that reach beyond a block's own rows.
inline constexpr Code kLoadFixed = kRegisterCodes;  // the same address on all lanes
inline constexpr Code kLoad = kLoadFixed + 1;       // each lane's own address
inline constexpr Code kStoreFixed = kLoad + 1;
inline constexpr Code kStore = kStoreFixed + 1;
inline constexpr Code kPut = kStore + 1;
inline constexpr Code kGet = kPut + 1;
inline constexpr Code kAux = kGet + 1;
inline constexpr Code kKeepTest = kAux + 1;         // T as the bundle found it, for a later sleep
inline constexpr Code kForgetBase = kKeepTest + 1;  // register `a` has changed: lane_lines.hpp
inline constexpr Code kCloseLine = kForgetBase + 1;
inline constexpr int kKernelCodes = kCloseLine + 1;
// Changes of the sleep state: no kernels, since they choose among the kernels' variants.
inline constexpr Code kWake = kKernelCodes;
inline constexpr Code kToggle = kWake + 1;
inline constexpr Code kSleepIfSet = kToggle + 1;
inline constexpr Code kSleepIfClear = kSleepIfSet + 1;
inline constexpr Code kSleepIfKeptSet = kSleepIfClear + 1;
inline constexpr Code kSleepIfKeptClear = kSleepIfKeptSet + 1;

constexpr bool wakes(Code code) {
    return code == kWake || code == kToggle;
}
constexpr bool changes_sleep(Code code) {
    return code >= kWake;
}

struct MicroOperation {
    Code code = 0;
    // Of products: the pick. Of memory operations: the number of base register and line of offsets
    // in the program, 0 if it is not to be looked for among the lines.
    std::uint8_t detail = 0;
    std::uint16_t immediate = 0;  // or the offset of a memory operation
    std::uint16_t dst = 0;        // rows, as distances in words from the block's first
    std::uint16_t a = 0;
    std::uint16_t b = 0;
    // Of a memory operation: the fixed word address, or the first of the bank. Of a change of the
    // sleep state: when it happens, in cycles from bundle 0 along the bundles' addresses.
    std::uint32_t where = 0;
};

}  // namespace rasterloom::lockstep
