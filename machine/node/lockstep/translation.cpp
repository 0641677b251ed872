// SPDX-License-Identifier: MIT
#include "machine/node/lockstep/translation.hpp"

#include "machine/node/lockstep/lane_lines.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <optional>

namespace rasterloom::lockstep {
namespace {

using isa::vliw::AluOp;
using isa::vliw::Bundle;
using isa::vliw::CommOp;
using isa::vliw::MemOp;
using isa::vliw::MulOp;
using isa::vliw::SeqOp;
using isa::vliw::SleepOp;

// A slot's work before it is put in order. Rows are numbers of rows still.
struct Slot {
    MicroOperation op;
    std::uint32_t reads = 0;   // bit r: register r
    std::uint32_t writes = 0;  // no bit or one
};

std::uint32_t bit(int reg) {
    return (1U << reg) & ~1U;
}

std::optional<Slot> alu_slot(const Bundle& bundle) {
    const Bundle::Alu& alu = bundle.alu;
    const bool test = is_test(alu.op);
    if (alu.op == AluOp::none || (!test && alu.dst == 0 && !writes_carry(alu.op))) {
        return std::nullopt;
    }
    Slot slot;
    slot.op.code =
        test ? test_code(alu.op, alu.mode, alu.immediate) : value_code(alu.op, alu.immediate);
    slot.op.immediate = bundle.immediate;
    slot.op.dst = alu.dst == 0 ? kScratchRow : alu.dst;  // only the carry is wanted of r0
    slot.op.a = alu.a;
    slot.op.b = alu.b;
    slot.reads = bit(alu.a) | bit(alu.b);
    slot.writes = test ? 0 : bit(alu.dst);
    return slot;
}

std::optional<Slot> mul_slot(const Bundle& bundle) {
    const Bundle::Multiplier& mul = bundle.mul;
    if (mul.op == MulOp::none || mul.dst == 0) {
        return std::nullopt;
    }
    const ProductPart part = mul.pick == 0   ? ProductPart::low
                             : mul.pick < 16 ? ProductPart::middle
                                             : ProductPart::high;
    Slot slot;
    slot.op.code = product_code(mul.op, part, mul.immediate);
    slot.op.detail = mul.pick;
    slot.op.immediate = bundle.immediate;
    slot.op.dst = mul.dst;
    slot.op.a = mul.a;
    slot.op.b = mul.b;
    slot.reads = bit(mul.a) | bit(mul.b);
    slot.writes = bit(mul.dst);
    return slot;
}

std::optional<Slot> memory_slot(const Bundle& bundle) {
    const Bundle::Memory& mem = bundle.mem;
    const bool load = mem.op == MemOp::ld || mem.op == MemOp::lds;
    if (mem.op == MemOp::none || (load && mem.reg == 0)) {
        return std::nullopt;
    }
    const bool slow = mem.op == MemOp::lds || mem.op == MemOp::sts;
    const bool fixed = mem.base == 0;
    Slot slot;
    slot.op.code = load ? (fixed ? kLoadFixed : kLoad) : (fixed ? kStoreFixed : kStore);
    slot.op.immediate = mem.offset;
    slot.op.dst = mem.reg;
    slot.op.a = mem.base;
    slot.op.b = mem.reg;
    const auto bank = static_cast<std::uint32_t>(slow ? mem.bank + 1 : 0);
    slot.op.where = bank * isa::vliw::kBankWords + (fixed ? mem.offset : 0U);
    slot.reads = bit(mem.base) | (load ? 0 : bit(mem.reg));
    slot.writes = load ? bit(mem.reg) : 0;
    return slot;
}

std::optional<Slot> communication_slot(const Bundle& bundle) {
    const Bundle::Communication& comm = bundle.comm;
    Slot slot;
    slot.op.dst = comm.reg;
    slot.op.b = comm.reg;
    switch (comm.op) {
        case CommOp::put:
            slot.op.code = kPut;
            slot.reads = bit(comm.reg);
            return slot;
        case CommOp::vout:
            slot.op.code = value_code(AluOp::mov, false);
            slot.op.dst = kVideoRow;
            slot.reads = bit(comm.reg);
            return slot;
        case CommOp::get:
        case CommOp::aux:
            if (comm.reg == 0) {
                return std::nullopt;
            }
            slot.op.code = comm.op == CommOp::get ? kGet : kAux;
            slot.writes = bit(comm.reg);
            return slot;
        default:  // shifts and broadcasts are the sequencer's
            return std::nullopt;
    }
}

// Puts slots in an order in which each reads before another writes what it reads. Where slots
// read each other's results in a circle, one result waits in a scratch row.
class Order {
  public:
    explicit Order(const Bundle& bundle) {
        for (const auto& slot : {alu_slot(bundle), mul_slot(bundle), memory_slot(bundle),
                                 communication_slot(bundle)}) {
            if (slot) {
                slots_.push_back(*slot);
            }
        }
    }

    std::vector<MicroOperation> operations() {
        std::vector<MicroOperation> ordered;
        std::vector<MicroOperation> copies;
        while (!slots_.empty()) {
            auto next = std::find_if(slots_.begin(), slots_.end(),
                                     [this](const Slot& slot) { return !is_awaited(slot); });
            if (next == slots_.end()) {
                next = slots_.begin();
                copies.push_back(through_scratch(next->op, copies.size()));
            }
            ordered.push_back(next->op);
            slots_.erase(next);
        }
        ordered.insert(ordered.end(), copies.begin(), copies.end());
        return ordered;
    }

  private:
    bool is_awaited(const Slot& writer) const {
        return std::any_of(slots_.begin(), slots_.end(), [&writer](const Slot& reader) {
            return &reader != &writer && (reader.reads & writer.writes) != 0;
        });
    }
    static MicroOperation through_scratch(MicroOperation& op, std::size_t number) {
        MicroOperation copy;
        copy.code = value_code(AluOp::mov, false);
        copy.dst = op.dst;
        copy.b = static_cast<std::uint16_t>(kScratchRow + number);
        op.dst = copy.b;
        return copy;
    }

    std::vector<Slot> slots_;
};

std::optional<Code> first_sleep_change(SleepOp op) {
    switch (op) {
        case SleepOp::wake:
        case SleepOp::wslt:
        case SleepOp::wslf:
            return kWake;
        case SleepOp::toggle:
            return kToggle;
        default:
            return std::nullopt;
    }
}

// `kept`: the bundle's own test has overwritten T.
std::optional<Code> last_sleep_change(SleepOp op, bool kept) {
    switch (op) {
        case SleepOp::slt:
        case SleepOp::wslt:
            return kept ? kSleepIfKeptSet : kSleepIfSet;
        case SleepOp::slf:
        case SleepOp::wslf:
            return kept ? kSleepIfKeptClear : kSleepIfClear;
        default:
            return std::nullopt;
    }
}

// Whether single lanes are all that the bundle concerns. Puts and gets are not plain since they
// depend on how far the ring has been shifted.
bool is_plain(const Bundle& bundle) {
    const CommOp comm = bundle.comm.op;
    return bundle.seq.op == SeqOp::none &&
           (comm == CommOp::none || comm == CommOp::vout || comm == CommOp::aux);
}

MicroOperation sleep_change(Code code, std::uint32_t when) {
    MicroOperation op;
    op.code = code;
    op.where = when;
    return op;
}

// Base register, first word of the bank, offset of the line.
using LineKey = std::array<std::uint32_t, 3>;
LineKey line_of(const Bundle::Memory& mem) {
    const bool slow = mem.op == MemOp::lds || mem.op == MemOp::sts;
    return {mem.base, slow ? mem.bank + 1U : 0U, line_offset(mem.offset)};
}

MicroOperation forget_base(int reg) {
    MicroOperation forget;
    forget.code = kForgetBase;
    forget.a = static_cast<std::uint16_t>(reg);
    return forget;
}

}  // namespace

void Translation::number_lines(const isa::vliw::Program& program) {
    std::array<std::uint32_t, isa::vliw::kRegisters> changes{};  // of registers, so far
    std::vector<std::pair<LineKey, std::uint32_t>> accesses;     // and how often the base changed
    std::map<std::pair<LineKey, std::uint32_t>, int> uses;
    for (const Bundle& bundle : program.bundles) {
        accesses.emplace_back(line_of(bundle.mem), changes[bundle.mem.base]);
        if (bundle.mem.op != MemOp::none && bundle.mem.base != 0) {
            ++uses[accesses.back()];
        }
        for (std::uint32_t changed = registers_written(bundle); changed != 0;
             changed &= changed - 1) {
            ++changes[static_cast<std::size_t>(std::countr_zero(changed))];
        }
    }
    std::map<LineKey, std::uint8_t> ids;
    for (const auto& [line, change] : accesses) {
        const auto use = uses.find({line, change});
        const bool again = use != uses.end() && use->second > 1;
        if (again && ids.size() < kMostLineIds) {
            ids.emplace(line, static_cast<std::uint8_t>(ids.size() + 1));
            line_bases_ |= 1U << line.front();
        }
        line_ids_.push_back(again && ids.contains(line) ? ids[line] : std::uint8_t{0});
    }
}

Translation::Translation(const isa::vliw::Program& program, std::span<const Transfer> transfers,
                         int row_words) {
    number_lines(program);
    cycles_.push_back(0);
    slots_.push_back(0);
    for (const Bundle& bundle : program.bundles) {
        first_.push_back(static_cast<std::uint32_t>(operations_.size()));
        waking_.push_back(first_sleep_change(bundle.sleep).has_value());
        cycles_.push_back(cycles_.back() + static_cast<std::uint32_t>(cycles_of(bundle)));
        slots_.push_back(slots_.back() + operations_in(bundle));
        translate(bundle, row_words, line_ids_[first_.size() - 1]);
    }
    first_.push_back(static_cast<std::uint32_t>(operations_.size()));
    translate_work(transfers, row_words);
    find_ends(program);
}

void Translation::translate_work(std::span<const Transfer> transfers, int row_words) {
    for (const Transfer& transfer : transfers) {
        const auto first = static_cast<std::uint32_t>(operations_.size());
        for (const Bundle& bundle : transfer.work) {
            translate(bundle, row_words, 0);
        }
        work_[transfer.first_bundle] = {first, static_cast<std::uint32_t>(operations_.size())};
    }
}

void Translation::translate(const Bundle& bundle, int row_words, std::uint8_t line) {
    const std::uint32_t end = cycles_.back();
    if (const auto code = first_sleep_change(bundle.sleep)) {
        operations_.push_back(
            sleep_change(*code, end - static_cast<std::uint32_t>(cycles_of(bundle))));
    }
    const bool test = is_test(bundle.alu.op);
    const auto sleep = last_sleep_change(bundle.sleep, test);
    if (sleep && test) {
        MicroOperation keep;
        keep.code = kKeepTest;
        operations_.push_back(keep);
    }
    for (MicroOperation op : Order(bundle).operations()) {
        if (op.code >= kLoadFixed && op.code <= kStore) {
            op.detail = line;
        }
        for (std::uint16_t* row : {&op.dst, &op.a, &op.b}) {
            *row = static_cast<std::uint16_t>(*row * row_words);
        }
        operations_.push_back(op);
    }
    for (std::uint32_t changed = registers_written(bundle) & line_bases_; changed != 0;
         changed &= changed - 1) {
        operations_.push_back(forget_base(std::countr_zero(changed) * row_words));
    }
    if (sleep) {
        operations_.push_back(sleep_change(*sleep, end));
    }
}

void Translation::find_ends(const isa::vliw::Program& program) {
    const auto bundles = static_cast<std::uint32_t>(program.bundles.size());
    plain_end_.resize(bundles);
    for (std::uint32_t i = bundles; i-- > 0;) {
        const bool last = i + 1 == bundles || work_.contains(i + 1);
        plain_end_[i] = !is_plain(program.bundles[i]) ? i : last ? i + 1 : plain_end_[i + 1];
    }
    const auto operations = static_cast<std::uint32_t>(operations_.size());
    next_sleep_change_.assign(operations + 1, operations);
    next_waking_.assign(operations + 1, operations);
    for (std::uint32_t i = operations; i-- > 0;) {
        const Code code = operations_[i].code;
        next_sleep_change_[i] = changes_sleep(code) ? i : next_sleep_change_[i + 1];
        next_waking_[i] = wakes(code) ? i : next_waking_[i + 1];
    }
}

}  // namespace rasterloom::lockstep
