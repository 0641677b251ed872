// SPDX-License-Identifier: MIT
#include "machine/node/lockstep/transfer.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace rasterloom::lockstep {
namespace {

using isa::vliw::Bundle;
using isa::vliw::CommOp;
using isa::vliw::MemOp;

// Below so many words, handing on at once saves nothing.
constexpr int kFewestWords = 8;

// Follows a piece of program bundle by bundle and knows of each register, of the ring and of
// memory where their values come from.
class Follower {
  public:
    explicit Follower(std::uint32_t first) { transfer_.first_bundle = first; }

    // False, and without effect, if the piece cannot go on with the bundle.
    bool follow(const Bundle& bundle) {
        const auto& [seq, alu, mul, mem, comm, sleep, immediate] = bundle;
        if (seq.op != isa::vliw::SeqOp::none || alu.op != isa::vliw::AluOp::none ||
            mul.op != isa::vliw::MulOp::none || sleep != isa::vliw::SleepOp::none || !takes(mem) ||
            !takes(comm) || transfer_.slots + 2 > kMaxTransferSlots) {
            return false;
        }
        const bool store = mem.op == MemOp::st || mem.op == MemOp::sts;
        const bool load = mem.op == MemOp::ld || mem.op == MemOp::lds;
        if (store) {
            follow_store(mem);
        }
        if (comm.op == CommOp::put) {
            put(comm.reg);
        }
        if (comm.op == CommOp::get) {
            get(comm.reg);
        }
        if (load) {
            follow_load(mem);
        }
        shift(comm);
        return true;
    }

    std::optional<Transfer> transfer(std::uint32_t end_bundle) {
        if (stored_words_ < kFewestWords) {
            return std::nullopt;
        }
        transfer_.end_bundle = end_bundle;
        transfer_.first_offset = *std::min_element(offsets_.begin(), offsets_.end());
        transfer_.last_offset = *std::max_element(offsets_.begin(), offsets_.end());
        for (const auto& [reg, value] : values_) {
            auto& words = value.own ? transfer_.own_registers : transfer_.taken_registers;
            words.push_back({reg, value.slot});
        }
        return transfer_;
    }

  private:
    struct Value {
        int slot = 0;
        bool own = true;  // or the neighbour's
    };

    static std::uint32_t bank_of(const Bundle::Memory& mem) {
        const bool slow = mem.op == MemOp::lds || mem.op == MemOp::sts;
        return slow ? (mem.bank + 1U) * isa::vliw::kBankWords : 0;
    }
    bool is_base(int reg) const {
        return reg == transfer_.load_base || reg == transfer_.store_base;
    }

    bool takes(const Bundle::Memory& mem) const {
        const bool load = mem.op == MemOp::ld || mem.op == MemOp::lds;
        if (mem.op == MemOp::none) {
            return true;
        }
        const int known = load ? transfer_.load_base : transfer_.store_base;
        const std::uint32_t bank = load ? transfer_.load_bank : transfer_.store_bank;
        if (mem.base == 0 || values_.contains(mem.base) || mem.offset >= 0x4000 ||
            (known != 0 && (known != mem.base || bank != bank_of(mem)))) {
            return false;
        }
        if (load) {  // what has been stored by an equal pointer is not loaded any more
            return mem.reg != 0 && mem.reg != mem.base && !is_base(mem.reg) &&
                   !stored_.contains(mem.offset);
        }
        const auto value = values_.find(mem.reg);
        return !stored_.contains(mem.offset) && (value == values_.end() || !value->second.own);
    }
    bool takes(const Bundle::Communication& comm) const {
        switch (comm.op) {
            case CommOp::put: {
                const auto value = values_.find(comm.reg);
                return value == values_.end() || value->second.own;
            }
            case CommOp::get:
                return comm.reg != 0 && !is_base(comm.reg) && in_ring_ &&
                       (!distance_ || *distance_ == shift_since_put_);
            case CommOp::none:
            case CommOp::right:
            case CommOp::left:
                return true;
            default:
                return false;
        }
    }

    static void lengthen(std::vector<TransferRun>& runs, int slot, int offset) {
        if (!runs.empty() && runs.back().slot + runs.back().count == slot &&
            runs.back().offset + runs.back().count == offset) {
            ++runs.back().count;
        } else {
            runs.push_back({slot, offset, 1});
        }
    }
    void follow_load(const Bundle::Memory& mem) {
        transfer_.load_base = mem.base;
        transfer_.load_bank = bank_of(mem);
        offsets_.insert(mem.offset);
        values_[mem.reg] = {transfer_.slots, true};
        lengthen(transfer_.loads, transfer_.slots++, mem.offset);
    }
    void follow_store(const Bundle::Memory& mem) {
        transfer_.store_base = mem.base;
        transfer_.store_bank = bank_of(mem);
        offsets_.insert(mem.offset);
        stored_.insert(mem.offset);
        if (const auto value = values_.find(mem.reg); value != values_.end()) {
            lengthen(transfer_.stores, value->second.slot, mem.offset);
            ++stored_words_;
        } else {
            transfer_.register_stores.push_back({mem.reg, mem.offset});
        }
    }
    void put(int reg) {
        const auto value = values_.find(reg);
        if (value == values_.end()) {
            transfer_.laid_registers.push_back({reg, transfer_.slots});
            in_ring_ = transfer_.slots++;
        } else {
            in_ring_ = value->second.slot;
        }
        transfer_.last_put = *in_ring_;
        transfer_.shift_before_put = transfer_.shift;
        shift_since_put_ = 0;
    }
    void get(int reg) {
        distance_ = transfer_.distance = shift_since_put_;
        values_[reg] = {*in_ring_, false};
    }
    void shift(const Bundle::Communication& comm) {
        const int places = comm.op == CommOp::right  ? comm.count
                           : comm.op == CommOp::left ? -comm.count
                                                     : 0;
        transfer_.shift += places;
        shift_since_put_ += places;
    }

    Transfer transfer_;
    std::map<int, Value> values_;  // of registers that the piece has changed
    std::set<int> offsets_;
    std::set<int> stored_;
    std::optional<int> in_ring_;
    std::optional<std::int64_t> distance_;
    std::int64_t shift_since_put_ = 0;
    int stored_words_ = 0;
};

}  // namespace

std::vector<Transfer> find_transfers(const isa::vliw::Program& program) {
    std::vector<Transfer> transfers;
    const auto bundles = static_cast<std::uint32_t>(program.bundles.size());
    for (std::uint32_t first = 0; first < bundles; ++first) {
        if (program.bundles[first].comm.op != CommOp::put) {
            continue;
        }
        Follower follower(first);
        std::uint32_t end = first;
        while (end < bundles && follower.follow(program.bundles[end])) {
            ++end;
        }
        if (auto transfer = follower.transfer(end)) {
            transfers.push_back(std::move(*transfer));
            first = end - 1;
        }
    }
    return transfers;
}

}  // namespace rasterloom::lockstep
