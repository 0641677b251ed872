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
        const bool aside = goes_aside(bundle.mem);
        const Bundle::Memory mem = aside ? Bundle::Memory{} : bundle.mem;
        const Bundle::Communication& comm = bundle.comm;
        if (bundle.seq.op != isa::vliw::SeqOp::none || bundle.sleep != isa::vliw::SleepOp::none ||
            !takes(mem) || !takes(comm) || !puts_off_work(bundle, aside)) {
            return false;
        }
        if (aside) {
            banks_aside_.insert(bank_of(bundle.mem));
        }
        if (is_store(mem.op)) {
            transfer_.store_base = mem.base;
            transfer_.store_bank = bank_of(mem);
            stored_.emplace(mem.offset, values_.at(mem.reg).source);
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

    // What has been followed up to here, if it hands whole records on.
    std::optional<Transfer> transfer(std::uint32_t end_bundle) const {
        if (stored_.size() < kFewestWords || !distance_ || *distance_ == 0 || !are_record()) {
            return std::nullopt;
        }
        Transfer found = transfer_;
        found.end_bundle = end_bundle;
        found.first_offset = stored_.begin()->first;
        found.words = static_cast<int>(stored_.size());
        found.distance = *distance_;
        // Of all words, those that somebody looks at.
        found.sources.clear();
        const auto look_at = [&](int source) {
            const Transfer::Source& looked_at = transfer_.sources[static_cast<std::size_t>(source)];
            auto known = std::find(found.sources.begin(), found.sources.end(), looked_at);
            if (known == found.sources.end()) {
                known = found.sources.insert(known, looked_at);
            }
            return static_cast<int>(known - found.sources.begin());
        };
        for (const auto& [reg, value] : values_) {
            auto& results = value.own ? found.own_results : found.taken_results;
            results.push_back({reg, look_at(value.source)});
        }
        for (const auto& [offset, source] : stored_) {
            if (transfer_.sources[static_cast<std::size_t>(source)].in_register) {
                found.handed.push_back({look_at(source), offset});
            }
        }
        found.last_put = look_at(*in_ring_);
        if (!std::all_of(found.sources.begin(), found.sources.end(),
                         [this](const auto& source) { return is_known(source); })) {
            return std::nullopt;
        }
        return found;
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

    // A store of something else into a bank that has no records can wait, as work can.
    bool goes_aside(const Bundle::Memory& mem) const {
        return is_store(mem.op) && !values_.contains(mem.reg) && transfer_.load_base != 0 &&
               bank_of(mem) != transfer_.load_bank &&
               (transfer_.store_base == 0 || bank_of(mem) != transfer_.store_bank);
    }
    bool takes(const Bundle::Memory& mem) const {
        const bool load = is_load(mem.op);
        if (mem.op == MemOp::none) {
            return true;
        }
        const int known = load ? transfer_.load_base : transfer_.store_base;
        const std::uint32_t bank = load ? transfer_.load_bank : transfer_.store_bank;
        if (mem.base == 0 || values_.contains(mem.base) || mem.offset >= 0x4000 ||
            (known != 0 && (known != mem.base || bank != bank_of(mem))) ||
            banks_aside_.contains(bank_of(mem))) {
            return false;
        }
        if (load) {  // what has been stored by an equal pointer is not loaded any more
            return mem.reg != 0 && mem.reg != mem.base && !is_base(mem.reg) &&
                   !stored_.contains(mem.offset);
        }
        const auto value = values_.find(mem.reg);
        if (stored_.contains(mem.offset) || value == values_.end() || value->second.own) {
            return false;
        }
        const Transfer::Source& source = source_of(value->second);
        return source.in_register || source.number == mem.offset;
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

    // The work of ALU and multiplier, and stores aside, come after all moves of words. False if it
    // would then find something else in a register, or a move would.
    bool puts_off_work(const Bundle& bundle, bool stores_aside) {
        Bundle moves = bundle;
        moves.alu = {};
        moves.mul = {};
        Bundle work = bundle;
        work.comm = {};
        (stores_aside ? moves : work).mem = {};
        const std::uint32_t read = work_reads_ | registers_read(work);
        if ((registers_read(moves) & work_writes_) != 0 ||
            (registers_written(moves) & (read | work_writes_)) != 0) {
            return false;
        }
        if (work.alu.op != isa::vliw::AluOp::none || work.mul.op != isa::vliw::MulOp::none ||
            stores_aside) {
            work_reads_ = read;
            work_writes_ |= registers_written(work);
            transfer_.work.push_back(without_unused_fields(work));
        }
        return true;
    }

    const Transfer::Source& source_of(const Value& value) const {
        return transfer_.sources[static_cast<std::size_t>(value.source)];
    }
    int add_source(const Transfer::Source& source) {
        transfer_.sources.push_back(source);
        return static_cast<int>(transfer_.sources.size()) - 1;
    }
    void follow_load(const Bundle::Memory& mem) {
        transfer_.load_base = mem.base;
        transfer_.load_bank = bank_of(mem);
        values_[mem.reg] = {add_source({false, mem.offset}), true};
    }
    void put(int reg) {
        const auto value = values_.find(reg);
        if (value == values_.end()) {
            in_ring_ = add_source({true, reg});
        } else {
            in_ring_ = value->second.source;
        }
        transfer_.shift_before_put = transfer_.shift;
        shift_since_put_ = 0;
    }
    void get(int reg) {
        distance_ = shift_since_put_;
        values_[reg] = {*in_ring_, false};
    }
    void shift(const Bundle::Communication& comm) {
        const int places = comm.op == CommOp::right  ? comm.count
                           : comm.op == CommOp::left ? -comm.count
                                                     : 0;
        transfer_.shift += places;
        shift_since_put_ += places;
    }

    // Whether the words that are stored are without a gap.
    bool are_record() const {
        const auto words = static_cast<int>(stored_.size());
        return words <= kMostRecordWords &&
               stored_.rbegin()->first - stored_.begin()->first == words - 1;
    }
    // A word of memory that is not handed on is not known where the record is not in memory.
    bool is_known(const Transfer::Source& source) const {
        const auto stored = stored_.find(source.number);
        return source.in_register ||
               (stored != stored_.end() &&
                transfer_.sources[static_cast<std::size_t>(stored->second)] == source);
    }

    Transfer transfer_;
    std::uint32_t work_reads_ = 0;  // bit r: register r
    std::uint32_t work_writes_ = 0;
    std::map<int, Value> values_;  // of registers that the piece has changed
    std::map<int, int> stored_;    // by offset: index of the source
    std::set<std::uint32_t> banks_aside_;
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
        std::optional<Transfer> longest;
        const std::uint32_t last = std::min(bundles, first + kMostTransferBundles);
        for (std::uint32_t end = first; end < last && follower.follow(program.bundles[end]);) {
            if (auto transfer = follower.transfer(++end)) {
                longest = std::move(transfer);
            }
        }
        if (longest) {
            first = longest->end_bundle - 1;
            transfers.push_back(std::move(*longest));
        }
    }
    return transfers;
}

}  // namespace rasterloom::lockstep
