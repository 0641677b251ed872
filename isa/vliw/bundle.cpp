// SPDX-License-Identifier: MIT
#include "isa/vliw/bundle.hpp"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

namespace rasterloom::isa::vliw {
namespace {

constexpr bool reads_a(AluOp op) {
    return op != AluOp::none && op != AluOp::mov && op != AluOp::tget;
}
constexpr bool reads_b(const Bundle::Alu& alu) {
    return alu.op != AluOp::none && alu.op != AluOp::tget && !alu.immediate;
}
constexpr bool comm_reads(CommOp op) {
    return op == CommOp::put || op == CommOp::vout;
}
constexpr bool comm_writes(CommOp op) {
    return op == CommOp::get || op == CommOp::aux;
}

std::uint16_t word(std::uint32_t value) {
    return static_cast<std::uint16_t>(value);
}
std::uint32_t field(std::uint32_t value, int shift) {
    return value << shift;
}
template <typename Enum>
std::uint32_t code(Enum value) {
    return static_cast<std::uint32_t>(value);
}
std::uint32_t bits(std::uint16_t value, int low, int width) {
    return (value >> low) & ((1U << width) - 1);
}
std::uint8_t small(std::uint16_t value, int low, int width) {
    return static_cast<std::uint8_t>(bits(value, low, width));
}

}  // namespace

BundleWords encode(const Bundle& bundle) {
    const auto& [seq, alu, mul, mem, comm, sleep, immediate] = bundle;
    return {
        word(field(code(seq.op), 11) | field(seq.counter, 8) | field(code(sleep), 5) | comm.reg),
        seq.target,
        word(field(code(alu.op), 11) | field(alu.dst, 6) | field(alu.a, 1) |
             (alu.immediate ? 1U : 0U)),
        word(field(alu.b, 11) | field(code(mul.op), 9) | (mul.immediate ? 0x100U : 0U) |
             field(mul.pick, 3) | field(code(alu.mode), 1)),
        word(field(mul.dst, 11) | field(mul.a, 6) | field(mul.b, 1)),
        immediate,
        word(field(code(mem.op), 13) | field(mem.bank, 11) | field(mem.reg, 6) |
             field(mem.base, 1)),
        mem.offset,
        word(field(code(comm.op), 12) | comm.count)};
}

std::optional<Bundle> decode(std::span<const std::uint16_t, kWordsPerBundle> w) {
    const bool exists = bits(w[0], 11, 5) < kSeqOps && bits(w[0], 5, 3) < kSleepOps &&
                        bits(w[2], 11, 5) < kAluOps && bits(w[3], 1, 2) < 3 &&
                        bits(w[6], 13, 3) < 5 && bits(w[8], 12, 4) < kCommOps;
    const bool zeros = bits(w[3], 0, 1) == 0 && bits(w[4], 0, 1) == 0 && bits(w[6], 0, 1) == 0 &&
                       bits(w[8], 10, 2) == 0;
    if (!exists || !zeros) {
        return std::nullopt;
    }
    Bundle bundle;
    bundle.seq = {static_cast<SeqOp>(bits(w[0], 11, 5)), small(w[0], 8, 3), w[1]};
    bundle.sleep = static_cast<SleepOp>(bits(w[0], 5, 3));
    bundle.alu = {.op = static_cast<AluOp>(bits(w[2], 11, 5)),
                  .mode = static_cast<TestMode>(bits(w[3], 1, 2)),
                  .dst = small(w[2], 6, 5),
                  .a = small(w[2], 1, 5),
                  .b = small(w[3], 11, 5),
                  .immediate = bits(w[2], 0, 1) != 0};
    bundle.mul = {.op = static_cast<MulOp>(bits(w[3], 9, 2)),
                  .dst = small(w[4], 11, 5),
                  .a = small(w[4], 6, 5),
                  .b = small(w[4], 1, 5),
                  .pick = small(w[3], 3, 5),
                  .immediate = bits(w[3], 8, 1) != 0};
    bundle.immediate = w[5];
    bundle.mem = {static_cast<MemOp>(bits(w[6], 13, 3)), small(w[6], 11, 2), small(w[6], 6, 5),
                  small(w[6], 1, 5), w[7]};
    bundle.comm = {static_cast<CommOp>(bits(w[8], 12, 4)), small(w[0], 0, 5),
                   static_cast<std::uint16_t>(bits(w[8], 0, 10))};
    return bundle == without_unused_fields(bundle) ? std::optional(bundle) : std::nullopt;
}

std::uint32_t registers_read(const Bundle& bundle) {
    const auto& [seq, alu, mul, mem, comm, sleep, immediate] = bundle;
    std::uint32_t read = 0;
    const auto add = [&read](bool reads, std::uint8_t reg) { read |= reads ? 1U << reg : 0U; };
    add(reads_a(alu.op), alu.a);
    add(reads_b(alu), alu.b);
    add(mul.op != MulOp::none, mul.a);
    add(mul.op != MulOp::none && !mul.immediate, mul.b);
    add(mem.op != MemOp::none, mem.base);
    add(is_store(mem.op), mem.reg);
    add(comm_reads(comm.op), comm.reg);
    return read & ~1U;
}

std::uint32_t registers_written(const Bundle& bundle) {
    const auto& [seq, alu, mul, mem, comm, sleep, immediate] = bundle;
    std::uint32_t written = 0;
    const auto add = [&written](bool writes, std::uint8_t reg) {
        written |= writes ? 1U << reg : 0U;
    };
    add(alu.op != AluOp::none && !is_test(alu.op), alu.dst);
    add(mul.op != MulOp::none, mul.dst);
    add(is_load(mem.op), mem.reg);
    add(comm_writes(comm.op), comm.reg);
    return written & ~1U;
}

std::optional<std::string> conflict(const Bundle& bundle) {
    const auto& [seq, alu, mul, mem, comm, sleep, immediate] = bundle;
    const int reads = std::popcount(registers_read(bundle));
    if (reads > kReadPorts) {
        return fmt::format("reads {} registers; the register file has {} read ports", reads,
                           kReadPorts);
    }
    std::array<int, kRegisters> writes{};
    const auto add = [&writes](bool active, std::uint8_t reg) { writes[reg] += active ? 1 : 0; };
    add(alu.op != AluOp::none && !is_test(alu.op), alu.dst);
    add(mul.op != MulOp::none, mul.dst);
    add(is_load(mem.op), mem.reg);
    add(comm_writes(comm.op), comm.reg);
    int results = 0;
    for (std::size_t reg = 1; reg < writes.size(); ++reg) {
        if (writes[reg] > 1) {
            return fmt::format("writes r{} twice", reg);
        }
        results += writes[reg];
    }
    if (results > kWritePorts) {
        return fmt::format("writes {} registers; the register file has {} write ports", results,
                           kWritePorts);
    }
    if (is_shift(comm.op) && comm.count == 0) {
        return "shifts by no place";
    }
    return std::nullopt;
}

Bundle without_unused_fields(const Bundle& bundle) {
    const auto& [seq, alu, mul, mem, comm, sleep, immediate] = bundle;
    Bundle tidy;
    tidy.sleep = sleep;
    tidy.seq.op = seq.op;
    tidy.seq.counter = has_counter(seq.op) ? seq.counter : std::uint8_t{0};
    if (has_address(seq.op) || seq.op == SeqOp::setc || seq.op == SeqOp::phase) {
        tidy.seq.target = seq.target;
    }
    if (alu.op != AluOp::none) {
        tidy.alu = {alu.op,
                    is_test(alu.op) ? alu.mode : TestMode::set,
                    is_test(alu.op) ? std::uint8_t{0} : alu.dst,
                    reads_a(alu.op) ? alu.a : std::uint8_t{0},
                    reads_b(alu) ? alu.b : std::uint8_t{0},
                    alu.immediate && alu.op != AluOp::tget};
    }
    if (mul.op != MulOp::none) {
        tidy.mul = mul;
        tidy.mul.b = mul.immediate ? std::uint8_t{0} : mul.b;
    }
    if (mem.op != MemOp::none) {
        tidy.mem = mem;
        tidy.mem.bank = is_slow(mem.op) ? mem.bank : std::uint8_t{0};
    }
    tidy.comm.op = comm.op;
    tidy.comm.reg = comm_reads(comm.op) || comm_writes(comm.op) ? comm.reg : std::uint8_t{0};
    tidy.comm.count = is_shift(comm.op) ? comm.count : std::uint16_t{0};
    tidy.immediate = tidy.alu.immediate || tidy.mul.immediate ? immediate : std::uint16_t{0};
    return tidy;
}

std::int64_t cycles_of(const Bundle& bundle) {
    std::int64_t cycles = is_slow(bundle.mem.op) ? kSlowCycles : 1;
    if (is_shift(bundle.comm.op)) {
        cycles = std::max<std::int64_t>(cycles, bundle.comm.count);
    } else if (bundle.comm.op == CommOp::cast) {
        cycles = std::max<std::int64_t>(cycles, kCastCycles);
    }
    return cycles;
}

int operations_in(const Bundle& bundle) {
    return static_cast<int>(bundle.seq.op != SeqOp::none) +
           static_cast<int>(bundle.alu.op != AluOp::none) +
           static_cast<int>(bundle.mul.op != MulOp::none) +
           static_cast<int>(bundle.mem.op != MemOp::none) +
           static_cast<int>(bundle.comm.op != CommOp::none) +
           static_cast<int>(bundle.sleep != SleepOp::none);
}

}  // namespace rasterloom::isa::vliw
