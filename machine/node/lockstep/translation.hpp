// SPDX-License-Identifier: MIT
// A program as micro-operations, made once. Those of successive bundles lie one behind the other,
// so that a straight piece of the program is a range of them.
#pragma once

#include "isa/vliw/program.hpp"
#include "machine/node/lockstep/micro_operation.hpp"
#include "machine/node/lockstep/transfer.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace rasterloom::lockstep {

class Translation {
  public:
    // `row_words`: the width of a block in lanes.
    Translation(const isa::vliw::Program& program, std::span<const Transfer> transfers,
                int row_words);

    std::uint32_t bundles() const { return static_cast<std::uint32_t>(plain_end_.size()); }
    const std::vector<MicroOperation>& operations() const { return operations_; }
    // By bundle address, and one more for the end of the program.
    std::uint32_t first_operation(std::uint32_t bundle) const { return first_[bundle]; }
    // Behind the bundle's `wake` or `toggle`, which act before the rest of it reads.
    std::uint32_t after_waking(std::uint32_t bundle) const {
        return first_[bundle] + (waking_[bundle] ? 1 : 0);
    }
    // Cycles and slots used from bundle 0 to this one, along the addresses.
    std::uint32_t cycles_before(std::uint32_t bundle) const { return cycles_[bundle]; }
    std::int64_t slots_before(std::uint32_t bundle) const { return slots_[bundle]; }
    // The work that a transfer puts off, by its first bundle.
    std::uint32_t first_work(const Transfer& transfer) const {
        return work_.at(transfer.first_bundle).first;
    }
    std::uint32_t end_work(const Transfer& transfer) const {
        return work_.at(transfer.first_bundle).second;
    }
    // The first bundle from here on that the sequencer has to look at, or with which a transfer
    // begins: all before it concern single lanes only.
    std::uint32_t plain_end(std::uint32_t bundle) const { return plain_end_[bundle]; }
    // The first micro-operation from here on that changes the sleep state, that may wake lanes.
    std::uint32_t next_sleep_change(std::uint32_t op) const { return next_sleep_change_[op]; }
    std::uint32_t next_waking(std::uint32_t op) const { return next_waking_[op]; }

  private:
    // Numbers base registers' lines of offsets that are used more than once before the register
    // changes, along the bundles' addresses: fetching for one operation alone does not pay.
    void number_lines(const isa::vliw::Program& program);
    void translate(const isa::vliw::Bundle& bundle, int row_words, std::uint8_t line);
    void translate_work(std::span<const Transfer> transfers, int row_words);
    void find_ends(const isa::vliw::Program& program);

    std::vector<MicroOperation> operations_;
    std::vector<std::uint8_t> line_ids_;  // by bundle; 0: none
    std::uint32_t line_bases_ = 0;        // bit r: register r is the base of a numbered line
    std::vector<std::uint32_t> first_;
    std::vector<bool> waking_;
    std::vector<std::uint32_t> cycles_;
    std::vector<std::int64_t> slots_;
    std::map<std::uint32_t, std::pair<std::uint32_t, std::uint32_t>> work_;
    std::vector<std::uint32_t> plain_end_;
    std::vector<std::uint32_t> next_sleep_change_;
    std::vector<std::uint32_t> next_waking_;
};

}  // namespace rasterloom::lockstep
