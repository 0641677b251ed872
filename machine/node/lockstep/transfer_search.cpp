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
constexpr std::size_t kFewestWords = 8;

// Follows a piece of program bundle by bundle and knows of each register, of the ring and of
// memory where their values come from.
class Follower {
  public:
    explicit Follower(std::uint32_t first) { transfer_.first_bundle = first; }

    // False, and without effect, if the piece cannot go on with the bundle.
    bool follow(const Bundle& bundle) {
        const Bundle::Memory& mem = bundle.mem;
        const Bundle::Communication& comm = bundle.comm;
        if (bundle.seq.op != isa::vliw::SeqOp::none || bundle.sleep != isa::vliw::SleepOp::none ||
            transfer_.sources.size() + 2 > kMaxTransferWords || !takes(mem) || !takes(comm) ||
            !puts_off_work(bundle)) {
            return false;
        }
        if (is_store(mem.op)) {
            follow_store(mem);
        }
        if (comm.op == CommOp::put) {
            put(comm.reg);
        }
        if (comm.op == CommOp::get) {
            get(comm.reg);
        }
        if (is_load(mem.op)) {
            follow_load(mem);
        }
        shift(comm);
        return true;
    }

    std::optional<Transfer> transfer(std::uint32_t end_bundle) {
        if (transfer_.stores.size() < kFewestWords || transfer_.distance == 0) {
            return std::nullopt;
        }
        transfer_.end_bundle = end_bundle;
        transfer_.first_offset = *std::min_element(offsets_.begin(), offsets_.end());
        transfer_.last_offset = *std::max_element(offsets_.begin(), offsets_.end());
        for (const auto& [reg, value] : values_) {
            auto& results = value.own ? transfer_.own_results : transfer_.taken_results;
            results.push_back({reg, value.source});
        }
        find_moves();
        return transfer_;
    }

  private:
    struct Value {
        int source = 0;
        bool own = true;  // or the neighbour's
    };

    static std::uint32_t bank_of(const Bundle::Memory& mem) {
        return is_slow(mem.op) ? (mem.bank + 1U) * isa::vliw::kBankWords : 0;
    }
    bool is_base(int reg) const {
        return reg == transfer_.load_base || reg == transfer_.store_base;
    }

    bool takes(const Bundle::Memory& mem) const {
        const bool load = is_load(mem.op);
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

    // The work of ALU and multiplier comes after all moves of words. False if it would then find
    // something else in a register, or a move would.
    bool puts_off_work(const Bundle& bundle) {
        Bundle moves = bundle;
        moves.alu = {};
        moves.mul = {};
        Bundle work = bundle;
        work.mem = {};
        work.comm = {};
        const std::uint32_t read = work_reads_ | registers_read(work);
        if ((registers_read(moves) & work_writes_) != 0 ||
            (registers_written(moves) & (read | work_writes_)) != 0) {
            return false;
        }
        if (work.alu.op != isa::vliw::AluOp::none || work.mul.op != isa::vliw::MulOp::none) {
            work_reads_ = read;
            work_writes_ |= registers_written(work);
            transfer_.work.push_back(without_unused_fields(work));
        }
        return true;
    }

    int add_source(const Transfer::Source& source) {
        transfer_.sources.push_back(source);
        return static_cast<int>(transfer_.sources.size()) - 1;
    }
    void follow_load(const Bundle::Memory& mem) {
        transfer_.load_base = mem.base;
        transfer_.load_bank = bank_of(mem);
        offsets_.insert(mem.offset);
        values_[mem.reg] = {add_source({false, mem.offset}), true};
    }
    void follow_store(const Bundle::Memory& mem) {
        transfer_.store_base = mem.base;
        transfer_.store_bank = bank_of(mem);
        offsets_.insert(mem.offset);
        stored_.insert(mem.offset);
        if (const auto value = values_.find(mem.reg); value != values_.end()) {
            transfer_.stores.push_back({value->second.source, mem.offset});
        } else {
            transfer_.register_stores.push_back({mem.reg, mem.offset});
        }
    }
    void put(int reg) {
        const auto value = values_.find(reg);
        if (value == values_.end()) {
            in_ring_ = add_source({true, reg});
        } else {
            in_ring_ = value->second.source;
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

    // Moves go on over a word that a register fills afterwards.
    void find_moves() {
        for (const Transfer::Store& store : transfer_.stores) {
            const Transfer::Source& source =
                transfer_.sources[static_cast<std::size_t>(store.source)];
            if (source.in_register) {
                transfer_.handed.push_back({source.number, store.offset});
                continue;
            }
            Transfer::Move* const last =
                transfer_.moves.empty() ? nullptr : &transfer_.moves.back();
            const int gap = last == nullptr ? -1 : store.offset - last->to - last->count;
            const bool joins = gap >= 0 && source.number - last->from == store.offset - last->to &&
                               are_handed(store.offset - gap, store.offset);
            if (joins) {
                last->count += gap + 1;
            } else {
                transfer_.moves.push_back({source.number, store.offset, 1});
            }
        }
    }
    bool are_handed(int first, int end) const {
        const auto between = [first, end](const Transfer::Store& store) {
            return store.offset >= first && store.offset < end;
        };
        return std::count_if(transfer_.handed.begin(), transfer_.handed.end(), between) ==
               end - first;
    }

    Transfer transfer_;
    std::uint32_t work_reads_ = 0;  // bit r: register r
    std::uint32_t work_writes_ = 0;
    std::map<int, Value> values_;  // of registers that the piece has changed
    std::set<int> offsets_;
    std::set<int> stored_;
    std::optional<int> in_ring_;
    std::optional<std::int64_t> distance_;
    std::int64_t shift_since_put_ = 0;
};

}  // namespace

std::vector<Transfer> find_transfers(const isa::vliw::Program& program) {
    std::vector<Transfer> transfers;
    const auto bundles = static_cast<std::uint32_t>(program.bundles.size());
    for (std::uint32_t first = 0; first < bundles; ++first) {
        const Bundle& bundle = program.bundles[first];
        if (bundle.comm.op != CommOp::put && !is_load(bundle.mem.op)) {
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
