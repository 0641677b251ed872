// SPDX-License-Identifier: MIT
// Records that pointers lead to, and their transport from lane to lane: the array does as the
// interpreter does.
#include "machine/node/lockstep/transfer.hpp"
#include "tests/isa/vliw_random_programs.hpp"
#include "tests/node/lockstep/agreement.hpp"

#include <array>
#include <functional>
#include <random>

#include <gtest/gtest.h>

namespace rasterloom {
namespace {

using isa::vliw::AluOp;
using isa::vliw::Bundle;
using isa::vliw::CommOp;
using isa::vliw::Interpreter;
using isa::vliw::MemOp;
using isa::vliw::MulOp;
using isa::vliw::SeqOp;
using isa::vliw::SleepOp;
using isa::vliw::testing::kWindow;
using testing::kMuch;
using testing::memory;
using testing::OnPath;

// Records read and written by pointers r8, r9, r10: equal on some lanes, some words or far apart on
// others, changed now and then, with sleeping lanes and transport by the ring in between.
class RecordProgram {
  public:
    explicit RecordProgram(std::uint64_t seed) : random_(seed) {
        // Pointers into the window, in both halves of it.
        for (std::uint8_t pointer = 8; pointer < 11; ++pointer) {
            add_pointer_change(pointer);
        }
        for (int i = 0; i < 120; ++i) {
            add();
        }
        bundles_.emplace_back().seq.op = SeqOp::halt;
    }
    const std::vector<Bundle>& bundles() const { return bundles_; }

  private:
    std::uint8_t below(int bound) {
        return static_cast<std::uint8_t>(random_() % static_cast<std::uint64_t>(bound));
    }
    std::uint8_t reg(int first, int count) {
        return static_cast<std::uint8_t>(first + below(count));
    }

    void add_pointer_change(std::uint8_t pointer) {
        Bundle& masked = bundles_.emplace_back();
        masked.alu = {.op = AluOp::and_, .dst = pointer, .a = reg(1, 7), .immediate = true};
        masked.immediate = below(3) == 0 ? 1 : below(2) == 0 ? 31 : 0;
        Bundle& far = bundles_.emplace_back();
        far.mul = {MulOp::mulu, pointer, pointer, 0, below(2), true};
        far.immediate = static_cast<std::uint16_t>(below(2) == 0 ? 1 : 200);
    }
    void add() {
        const int kind = below(20);
        Bundle bundle;
        if (kind < 14) {
            const MemOp op = kind < 8 ? (kind < 6 ? MemOp::ld : MemOp::lds)
                                      : (kind < 13 ? MemOp::st : MemOp::sts);
            const auto offset = static_cast<std::uint16_t>(kWindow + below(24));
            bundle.mem = {op, 0, reg(11, 12), kind == 3 ? std::uint8_t{0} : reg(8, 3), offset};
            bundle.alu = {.op = AluOp::xor_, .dst = reg(1, 7), .a = reg(11, 12), .b = reg(1, 7)};
        } else if (kind == 14) {
            bundle.sleep = SleepOp::slt;
        } else if (kind < 17) {
            bundle.sleep = SleepOp::wake;
            bundle.alu = {.op = AluOp::tltu, .a = reg(1, 7), .b = reg(1, 7)};
        } else if (kind < 19) {
            bundle.comm = {kind == 17 ? CommOp::put : CommOp::get, reg(11, 12), 0};
        } else {
            return add_pointer_change(reg(8, 3));
        }
        bundles_.push_back(bundle);
    }

    std::mt19937_64 random_;
    std::vector<Bundle> bundles_;
};

TEST(LockstepArrayRecords, AreReadAndWrittenAsByTheInterpreter) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const auto program = testing::program_of(RecordProgram(seed).bundles());
        Interpreter interpreter(program, 290);
        isa::vliw::testing::randomize(interpreter, seed);
        testing::run(interpreter, kMuch);
        const auto paths = LockstepArray::paths();
        const OnPath on_path(paths[seed % paths.size()]);
        for (const LaneLayout layout :
             {LaneLayout::across, LaneLayout::along, LaneLayout::shared}) {
            LockstepArray array(program, {.lanes = 290, .threads = 2});
            array.set_layout(fast_word(kWindow), 512, layout);
            array.set_layout(slow_word(0, kWindow), 60, layout);  // not all that is accessed
            isa::vliw::testing::randomize(array, seed);
            array.run(kMuch);
            ASSERT_EQ(testing::difference(array, interpreter), "")
                << "seed " << seed << " on " << LockstepArray::paths().front();
        }
    }
}

// Words handed on from the record at r8 to the neighbour's record at r9, in the order of a program
// that was packed: a word is loaded, put and shifted while the one before is got and stored.
std::vector<Bundle> hand_on(int words, CommOp direction, int places) {
    std::vector<Bundle> bundles;
    const auto reg = [](int first, int word) {
        return static_cast<std::uint8_t>(first + word % 3);
    };
    for (int word = 0; word < words; ++word) {
        const auto offset = static_cast<std::uint16_t>(kWindow + word);
        Bundle& put = bundles.emplace_back();
        put.comm = {CommOp::put, reg(12, word), 0};
        if (word > 0) {
            put.mem = memory(MemOp::st, 0, reg(16, word - 1), 9, offset - 1);
        }
        Bundle& shift = bundles.emplace_back();
        shift.comm = {direction, 0, static_cast<std::uint16_t>(places)};
        if (word + 1 < words) {
            shift.mem = memory(MemOp::ld, 0, reg(12, word + 1), 8, offset + 1);
        }
        bundles.emplace_back().comm = {CommOp::get, reg(16, word), 0};
    }
    bundles.emplace_back().mem = memory(MemOp::st, 0, reg(16, words - 1), 9, kWindow + words - 1);
    bundles.emplace_back().comm = {CommOp::put, 20, 0};
    bundles.emplace_back().comm = {CommOp::get, 21, 0};
    return bundles;
}

TEST(LockstepTransfers, TakeWorkBehindTheRecordOnlySoFar) {
    auto bundles = hand_on(20, CommOp::right, 1);
    bundles.pop_back();  // a word that has not been shifted ends the piece
    Bundle add;
    add.alu = {.op = AluOp::add, .dst = 25, .a = 25, .b = 26};
    bundles.insert(bundles.end(), 2 * lockstep::kMostTransferBundles, add);
    bundles.emplace_back().seq.op = SeqOp::halt;
    const auto transfers = lockstep::find_transfers(*testing::program_of(bundles));
    ASSERT_EQ(transfers.size(), 1U);
    EXPECT_EQ(transfers.front().words, 20);
    EXPECT_EQ(transfers.front().end_bundle, lockstep::kMostTransferBundles);
}

// How the pointers r8 and r9 lie: apart, equal on some lanes, so near that words overlap.
void point(const std::function<void(std::int64_t, int, std::uint16_t)>& set_reg, std::int64_t lanes,
           int kind) {
    for (std::int64_t lane = 0; lane < lanes; ++lane) {
        const auto from = static_cast<std::uint16_t>(lane % 5);
        const auto apart = kind == 0 ? 30 : kind == 1 ? (lane % 3 == 0 ? 0 : 25) : lane % 8;
        set_reg(lane, 8, from);
        set_reg(lane, 9, static_cast<std::uint16_t>(from + apart));
    }
}

// ALU and multiplier work between the moves, now and then with registers that words move through;
// one word is handed on from a register of which nothing was loaded.
void add_work(std::vector<Bundle>& bundles, std::mt19937_64& random) {
    const auto below = [&random](std::uint64_t n) { return random() % n; };
    const auto some_reg = [&] {
        return static_cast<std::uint8_t>(below(12) == 0 ? 8 + below(14) : 22 + below(6));
    };
    for (Bundle& bundle : bundles) {
        if (below(8) == 0 && bundle.comm.op == CommOp::put) {
            bundle.comm.reg = 28;
        }
        Bundle worked = bundle;
        if (below(4) == 0) {
            const auto op = static_cast<AluOp>(1 + below(isa::vliw::kAluOps - 1));
            worked.alu = {.op = op, .dst = some_reg(), .a = some_reg(), .b = some_reg()};
        }
        if (below(8) == 0) {
            worked.mul = {.op = MulOp::mul, .dst = some_reg(), .a = some_reg(), .immediate = true};
            worked.immediate = static_cast<std::uint16_t>(random());
        }
        worked = without_unused_fields(worked);
        if (!conflict(worked)) {
            bundle = worked;
        }
    }
}

TEST(LockstepArrayRecords, AreHandedOnAsByTheInterpreter) {
    const auto paths = LockstepArray::paths();
    for (int kind = 0; kind < 60; ++kind) {
        const std::int64_t lanes =
            std::array{1, 3, 100, 290, 512}[static_cast<std::size_t>(kind % 5)];
        auto bundles =
            hand_on(20, kind % 4 == 3 ? CommOp::left : CommOp::right, 1 + kind * 7 % 170);
        bundles.front().sleep = kind % 7 == 6 ? SleepOp::slf : SleepOp::none;  // all fall asleep
        std::mt19937_64 random(static_cast<std::uint64_t>(kind));
        if (kind % 4 != 0) {
            add_work(bundles, random);
        }
        bundles.emplace_back().seq.op = SeqOp::halt;
        const auto program = testing::program_of(bundles);
        if (kind % 4 == 0 && kind % 7 != 6) {  // not word by word without need
            ASSERT_EQ(lockstep::find_transfers(*program).size(), 1U);
        }
        Interpreter interpreter(program, lanes);
        isa::vliw::testing::randomize(interpreter, 5);
        point([&](auto... values) { interpreter.set_reg(values...); }, lanes, kind % 3);
        testing::run(interpreter, kMuch);
        const OnPath on_path(paths[static_cast<std::size_t>(kind) % paths.size()]);
        for (const std::int64_t budget : {std::int64_t{50}, kMuch}) {
            LockstepArray array(program, {.lanes = lanes, .threads = 2});
            array.set_layout(fast_word(kWindow), 64, LaneLayout::along);
            isa::vliw::testing::randomize(array, 5);
            point([&](auto... values) { array.set_reg(values...); }, lanes, kind % 3);
            while (array.run(budget).reason == LockstepArray::Reason::budget) {
            }
            ASSERT_EQ(testing::difference(array, interpreter), "") << kind << ", budget " << budget;
        }
    }
}

// Rounds of a loop in which records are handed on again and again, as by passes: what has come is
// what is passed on next, some lanes keep it and take the next one behind it, some put in one of
// their own; now and then words are read and written, in records that are on their way, too.
class PassProgram {
  public:
    explicit PassProgram(std::uint64_t seed) : random_(seed) {
        bundles_.emplace_back().seq = {SeqOp::setc, 0, 6};
        change_pointer(8);
        change_pointer(9);
        const auto loop = static_cast<std::uint16_t>(bundles_.size());
        const auto times = 1 + below(2);
        for (int i = 0; i < times; ++i) {
            const int places = 1 + below(7);
            const auto direction = below(4) == 0 ? CommOp::left : CommOp::right;
            for (const Bundle& bundle : hand_on(kRecord, direction, places)) {
                bundles_.push_back(bundle);
                if (bundle.comm.op == CommOp::get && below(8) == 0) {
                    bundles_.back().mem =
                        memory(MemOp::sts, below(2), 22 + below(3), 0, kWindow + below(40));
                }
            }
            pass_on();
            for (int something = below(4); something > 0; --something) {
                do_something();
            }
        }
        bundles_.emplace_back().sleep = SleepOp::wake;
        if (below(3) == 0) {  // with new records on their way the next hand-on fails on lane 0
            change_records();
            sleep_on_lane_0();
        }
        bundles_.emplace_back();
        bundles_.back().seq = {SeqOp::dec, 0, loop};
        bundles_.emplace_back().seq.op = SeqOp::halt;
    }
    const std::vector<Bundle>& bundles() const { return bundles_; }

  private:
    static constexpr int kRecord = 10;

    std::uint8_t below(int bound) {
        return static_cast<std::uint8_t>(random_() % static_cast<std::uint64_t>(bound));
    }
    void some_lanes(SleepOp sleep) {
        bundles_.emplace_back().alu = {.op = AluOp::tltu,
                                       .a = static_cast<std::uint8_t>(1 + below(7)),
                                       .b = static_cast<std::uint8_t>(16 + below(3))};
        bundles_.emplace_back().sleep = sleep;
    }
    // To one of the five records in the window.
    void change_pointer(std::uint8_t pointer) {
        for (const AluOp op : {AluOp::and_, AluOp::add}) {
            Bundle& change = bundles_.emplace_back();
            change.alu = {.op = op, .dst = pointer, .a = pointer, .immediate = true};
            change.immediate = op == AluOp::and_ ? 3 : 1;
        }
        Bundle& scale = bundles_.emplace_back();
        scale.mul = {MulOp::mulu, pointer, pointer, 0, 0, true};
        scale.immediate = kRecord;
    }
    void pass_on() {
        bundles_.emplace_back().alu = {.op = AluOp::mov, .dst = 8, .b = 9};
        if (below(3) != 0) {
            some_lanes(SleepOp::slf);
            bundles_.emplace_back().alu = {.op = AluOp::add, .dst = 9, .a = 9, .immediate = true};
            bundles_.back().immediate = kRecord;
            bundles_.emplace_back().alu = {.op = AluOp::tltu, .a = 9, .immediate = true};
            bundles_.back().immediate = 5 * kRecord;
            bundles_.emplace_back().sleep = SleepOp::slt;
            bundles_.emplace_back().alu = {.op = AluOp::mov, .dst = 9};
            bundles_.emplace_back().sleep = SleepOp::wake;
        }
    }
    void change_records() {
        some_lanes(SleepOp::slf);
        bundles_.emplace_back().alu = {
            .op = AluOp::mov, .dst = 8, .b = static_cast<std::uint8_t>(1 + below(7))};
        change_pointer(8);
        bundles_.emplace_back().sleep = SleepOp::wake;
    }
    void sleep_on_lane_0() {  // where r27 is not 0
        bundles_.emplace_back().alu = {.op = AluOp::tne, .a = 27};
        bundles_.emplace_back().sleep = SleepOp::slt;
    }
    void do_something() {
        const int kind = below(9);
        if (kind < 2) {
            change_records();
        } else if (kind == 2) {
            some_lanes(SleepOp::slt);  // until something wakes them
        } else if (kind == 3) {
            sleep_on_lane_0();
        } else {
            const MemOp op = kind < 7 ? MemOp::ld : MemOp::st;
            const auto base = static_cast<std::uint8_t>(below(3) == 0 ? 0 : 8 + below(2));
            bundles_.emplace_back().mem =
                memory(op, 0, 22 + below(3), base, kWindow + below(base == 0 ? 64 : 12));
        }
    }

    std::mt19937_64 random_;
    std::vector<Bundle> bundles_;
};

TEST(LockstepArrayRecords, FlyFromLaneToLaneAsByTheInterpreter) {
    const auto paths = LockstepArray::paths();
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
        const std::int64_t lanes = std::array{9, 64, 290, 600}[seed % 4];
        const auto program = testing::program_of(PassProgram(seed).bundles());
        ASSERT_GE(lockstep::find_transfers(*program).size(), 1U);
        Interpreter interpreter(program, lanes);
        const auto prepare = [seed](auto& machine) {
            isa::vliw::testing::randomize(machine, seed);
            for (std::int64_t lane = 0; lane < machine.lanes(); ++lane) {
                machine.set_reg(lane, 27, lane == 0 ? 1 : 0);
            }
        };
        prepare(interpreter);
        testing::run(interpreter, kMuch);
        const OnPath on_path(paths[seed % paths.size()]);
        LockstepArray array(program, {.lanes = lanes, .threads = 2});
        array.set_layout(fast_word(kWindow), 64, LaneLayout::along);
        prepare(array);
        const std::int64_t budget = seed % 3 == 0 ? 77 : kMuch;
        while (array.run(budget).reason == LockstepArray::Reason::budget) {
        }
        ASSERT_EQ(testing::difference(array, interpreter), "") << "seed " << seed;
    }
}

}  // namespace
}  // namespace rasterloom
