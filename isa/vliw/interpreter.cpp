// SPDX-License-Identifier: MIT
#include "isa/vliw/interpreter.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::isa::vliw {
namespace {

std::uint16_t word(std::int64_t value) {
    return static_cast<std::uint16_t>(value);
}
std::int32_t as_signed(std::uint16_t value) {
    return static_cast<std::int16_t>(value);
}

struct AluResult {
    std::uint16_t value = 0;
    bool carry = false;  // of operations that write C
};

AluResult compute(AluOp op, std::uint16_t a, std::uint16_t b, bool carry, bool test) {
    const auto sum = [&](int in) { return AluResult{word(a + b + in), a + b + in > 0xffff}; };
    const auto difference = [&](int in) { return AluResult{word(a - b - in), a - b - in < 0}; };
    switch (op) {
        case AluOp::mov:
            return {b};
        case AluOp::add:
        case AluOp::adds:
            return sum(0);
        case AluOp::adc:
            return sum(carry);
        case AluOp::sub:
        case AluOp::subs:
            return difference(0);
        case AluOp::sbc:
            return difference(carry);
        case AluOp::and_:
            return {word(a & b)};
        case AluOp::or_:
            return {word(a | b)};
        case AluOp::xor_:
            return {word(a ^ b)};
        case AluOp::andn:
            return {word(a & ~b)};
        case AluOp::shl:
            return {word(a << (b & 15))};
        case AluOp::shr:
            return {word(a >> (b & 15))};
        case AluOp::asr:
            return {word(as_signed(a) >> (b & 15))};
        default:
            return {word(test)};  // tget
    }
}

bool holds(AluOp op, std::uint16_t a, std::uint16_t b, bool carry) {
    switch (op) {
        case AluOp::teq:
            return a == b;
        case AluOp::tne:
            return a != b;
        case AluOp::tlt:
            return as_signed(a) < as_signed(b);
        case AluOp::tge:
            return as_signed(a) >= as_signed(b);
        case AluOp::tltu:
            return a < b;
        case AluOp::tgeu:
            return a >= b;
        case AluOp::tltb:
            return as_signed(a) - as_signed(b) - carry < 0;
        default:
            return as_signed(a) - as_signed(b) - carry >= 0;  // tgeb
    }
}

bool tested(TestMode mode, bool found, bool result) {
    switch (mode) {
        case TestMode::both:
            return found && result;
        case TestMode::either:
            return found || result;
        default:
            return result;
    }
}

std::uint16_t product(MulOp op, std::uint16_t a, std::uint16_t b, int pick) {
    const std::int64_t left = op == MulOp::mulu ? a : as_signed(a);
    const std::int64_t right = op == MulOp::mul ? as_signed(b) : b;
    return word(left * right >> pick);  // within 33 bits, so its sign goes on above
}

}  // namespace

std::uint16_t Interpreter::Lane::load(std::uint32_t address) const {
    const auto& bank = memory.at(address / kBankWords);
    const std::size_t index = address % kBankWords;
    return index < bank.size() ? bank[index] : std::uint16_t{0};
}

void Interpreter::Lane::store(std::uint32_t address, std::uint16_t value) {
    auto& bank = memory.at(address / kBankWords);
    const std::size_t index = address % kBankWords;
    if (index >= bank.size()) {
        bank.resize(index + 1);
    }
    bank[index] = value;
}

Interpreter::Interpreter(std::shared_ptr<const Program> program, std::int64_t lanes)
    : program_(std::move(program)), pc_(program_->entry) {
    if (lanes < 1) {
        throw std::invalid_argument(fmt::format("{} lanes; at least one is expected", lanes));
    }
    lanes_.resize(static_cast<std::size_t>(lanes));
}

void Interpreter::restart() {
    pc_ = 0;
    calls_.clear();
}

std::uint16_t Interpreter::reg(std::int64_t lane, int index) const {
    return at(lane).r.at(static_cast<std::size_t>(index));
}

void Interpreter::set_reg(std::int64_t lane, int index, std::uint16_t value) {
    lanes_.at(static_cast<std::size_t>(lane)).r.at(static_cast<std::size_t>(index)) =
        index == 0 ? std::uint16_t{0} : value;
}

std::uint16_t Interpreter::read(std::int64_t lane, std::uint32_t address) const {
    return at(lane).load(address);
}

void Interpreter::write(std::int64_t lane, std::uint32_t address,
                        std::span<const std::uint16_t> words) {
    for (const std::uint16_t word : words) {
        lanes_.at(static_cast<std::size_t>(lane)).store(address++, word);
    }
}

Interpreter::Stop Interpreter::run(std::int64_t bundles) {
    Stop all;
    for (std::int64_t i = 0; i < bundles && all.reason == Reason::budget; ++i) {
        const std::int64_t before = all.cycles;
        all = step();
        all.cycles += before;
    }
    return all;
}

Interpreter::Stop Interpreter::step() {
    if (pc_ >= program_->bundles.size()) {
        return {Reason::trap, 0, 0, fmt::format("no bundle at address {}", pc_)};
    }
    const Bundle& bundle = program_->bundles[pc_];
    if (std::string trap = trap_of(bundle); !trap.empty()) {
        return {Reason::trap, 0, 0, std::move(trap)};
    }
    wake(bundle.sleep);
    sequence(bundle.seq);
    const std::vector<std::uint16_t> x = moved(bundle.comm);
    const std::int64_t cycles = cycles_of(bundle);
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
        Lane& lane = lanes_[i];
        lane.x = x[i];
        if (!lane.asleep) {
            lane.awake_cycles += cycles;
            execute(bundle, lane);
        }
    }
    ++bundles_executed_;
    operations_executed_ += operations_in(bundle);
    switch (bundle.seq.op) {
        case SeqOp::halt:
            return {Reason::halt, cycles, 0, {}};
        case SeqOp::line:
            return {Reason::line, cycles, 0, {}};
        case SeqOp::frame:
            return {Reason::frame, cycles, 0, {}};
        case SeqOp::phase:
            return {Reason::phase, cycles, bundle.seq.target, {}};
        default:
            return {Reason::budget, cycles, 0, {}};
    }
}

std::string Interpreter::trap_of(const Bundle& bundle) const {
    const bool calls = bundle.seq.op == SeqOp::call || bundle.seq.op == SeqOp::callp;
    if (calls && calls_.size() == kCallDepth) {
        return "call stack is full";
    }
    return bundle.seq.op == SeqOp::ret && calls_.empty() ? "call stack is empty" : "";
}

void Interpreter::wake(SleepOp op) {
    for (Lane& lane : lanes_) {
        if (op == SleepOp::wake || op == SleepOp::wslt || op == SleepOp::wslf) {
            lane.asleep = false;
        } else if (op == SleepOp::toggle) {
            lane.asleep = !lane.asleep;
        }
    }
}

// Of a branch that looks at T.
bool Interpreter::condition(SeqOp op) const {
    const auto set = [](const Lane& lane) { return !lane.asleep && lane.test; };
    const auto clear = [](const Lane& lane) { return !lane.asleep && !lane.test; };
    switch (op) {
        case SeqOp::bt:
            return lanes_[0].test;
        case SeqOp::bf:
            return !lanes_[0].test;
        case SeqOp::bor:
            return std::ranges::any_of(lanes_, set);
        case SeqOp::bnor:
            return std::ranges::none_of(lanes_, set);
        case SeqOp::band:
            return std::ranges::none_of(lanes_, clear);
        default:
            return std::ranges::any_of(lanes_, clear);  // bnand
    }
}

void Interpreter::sequence(const Bundle::Sequencer& seq) {
    const std::uint16_t next = word(pc_ + 1);
    bool taken = false;
    switch (seq.op) {
        case SeqOp::jump:
            taken = true;
            break;
        case SeqOp::call:
        case SeqOp::callp:
            calls_.push_back(next);
            pc_ = seq.op == SeqOp::call ? seq.target : procedure_;
            return;
        case SeqOp::ret:
            pc_ = calls_.back();
            calls_.pop_back();
            return;
        case SeqOp::bt:
        case SeqOp::bf:
        case SeqOp::bor:
        case SeqOp::bnor:
        case SeqOp::band:
        case SeqOp::bnand:
            taken = condition(seq.op);
            break;
        case SeqOp::setc:
            counters_[seq.counter] = seq.target;
            break;
        case SeqOp::ldc:
            counters_[seq.counter] = lanes_[0].x;
            break;
        case SeqOp::dec:
            taken = --counters_[seq.counter] != 0;
            break;
        case SeqOp::setp:
            procedure_ = seq.target;
            break;
        case SeqOp::line:
            return restart();
        case SeqOp::none:
        case SeqOp::halt:
        case SeqOp::frame:
        case SeqOp::phase:
            break;
    }
    pc_ = taken ? seq.target : next;
}

// The communication registers after shifts and broadcasts, which move them on all lanes.
std::vector<std::uint16_t> Interpreter::moved(const Bundle::Communication& comm) const {
    const std::size_t n = lanes_.size();
    std::vector<std::uint16_t> x(n);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t places = comm.count % n;
        std::size_t from = i;
        if (comm.op == CommOp::right) {
            from = (i + n - places) % n;
        } else if (comm.op == CommOp::left) {
            from = (i + places) % n;
        } else if (comm.op == CommOp::cast) {
            // At most once around the ring: then there is nobody, and it comes from here.
            for (std::size_t steps = 0; steps < n && (lanes_[from].asleep || !lanes_[from].test);
                 ++steps) {
                from = (from + n - 1) % n;
            }
        }
        x[i] = lanes_[from].x;
    }
    return x;
}

// What a lane that is awake does: all slots read `found` and write `lane`.
void Interpreter::execute(const Bundle& bundle, Lane& lane) const {
    const auto& [seq, alu, mul, mem, comm, sleep, immediate] = bundle;
    const std::array<std::uint16_t, kRegisters> r = lane.r;
    const bool carry = lane.carry;
    const bool test = lane.test;
    const std::uint16_t x = lane.x;
    const auto set = [&](std::uint8_t reg, std::uint16_t value) {
        lane.r[reg] = reg == 0 ? std::uint16_t{0} : value;
    };

    if (alu.op != AluOp::none) {
        const std::uint16_t b = alu.immediate ? immediate : r[alu.b];
        if (is_test(alu.op)) {
            lane.test = tested(alu.mode, test, holds(alu.op, r[alu.a], b, carry));
        } else {
            const AluResult result = compute(alu.op, r[alu.a], b, carry, test);
            set(alu.dst, result.value);
            lane.carry = writes_carry(alu.op) ? result.carry : carry;
        }
    }
    if (mul.op != MulOp::none) {
        set(mul.dst, product(mul.op, r[mul.a], mul.immediate ? immediate : r[mul.b], mul.pick));
    }
    const std::uint16_t offset = word(r[mem.base] + mem.offset);
    const std::uint32_t address = is_slow(mem.op) ? slow_address(mem.bank, offset) : offset;
    if (is_load(mem.op)) {
        set(mem.reg, lane.load(address));
    } else if (is_store(mem.op)) {
        lane.store(address, r[mem.reg]);
    }
    switch (comm.op) {
        case CommOp::put:
            lane.x = r[comm.reg];
            break;
        case CommOp::get:
            set(comm.reg, x);
            break;
        case CommOp::vout:
            lane.video = r[comm.reg];
            break;
        case CommOp::aux:
            set(comm.reg, aux_);
            break;
        default:
            break;
    }
    const bool if_set = sleep == SleepOp::slt || sleep == SleepOp::wslt;
    const bool if_clear = sleep == SleepOp::slf || sleep == SleepOp::wslf;
    lane.asleep = (if_set && test) || (if_clear && !test);
}

}  // namespace rasterloom::isa::vliw
