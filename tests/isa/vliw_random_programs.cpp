// SPDX-License-Identifier: MIT
#include "tests/isa/vliw_random_programs.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace rasterloom::isa::vliw::testing {
namespace {

constexpr int kLevels = 3;       // of calls
constexpr int kLoopsInside = 2;  // of one another, on a level: so six counters are taken
constexpr int kFirstFreeCounter = kLevels * kLoopsInside;
constexpr int kUniform = 28;  // 0 to 31
constexpr int kOwn = 29;      // 0 to 31, each lane its own
constexpr int kHigh = 30;     // kHighBase to kHighBase + 31, and kHigh + 1
constexpr std::uint16_t kHighBase = 0xc000;

class Generator {
  public:
    Generator(std::uint64_t seed, const RandomProgramOptions& options)
        : random_(seed), options_(options) {}

    RandomProgram program() {
        RandomProgram result;
        emit_sequencer(SeqOp::callp);
        emit_sequencer(SeqOp::line);
        result.entry = here();
        for (int reg = kHigh; reg < kRegisters; ++reg) {
            Bundle bundle;
            bundle.alu = {AluOp::mov, TestMode::set, static_cast<std::uint8_t>(reg), 0, 0, true};
            bundle.immediate = kHighBase;
            bundles_.push_back(bundle);
        }
        std::size_t next = emit_sequencer(SeqOp::setp);
        emit_sequencer(SeqOp::line);
        for (int i = 0; i < options_.procedures; ++i) {
            bundles_[next].seq.target = here();
            block(0, 0, options_.length);
            next = emit_sequencer(i + 1 == options_.procedures ? SeqOp::halt : SeqOp::setp);
            emit_sequencer(SeqOp::ret);
        }
        subroutines();
        for (const Bundle& bundle : bundles_) {
            result.bundles.push_back(without_unused_fields(bundle));
        }
        return result;
    }

  private:
    struct Call {
        std::size_t from;  // the bundle whose target is the subroutine
        int level;
    };

    int below(int bound) { return static_cast<int>(random_() % static_cast<std::uint64_t>(bound)); }
    bool percent(int chance) { return below(100) < chance; }
    template <typename T>
    T pick(std::initializer_list<T> choices) {
        return choices.begin()[below(static_cast<int>(choices.size()))];
    }
    std::uint8_t source() { return static_cast<std::uint8_t>(below(kRegisters)); }
    std::uint8_t destination() { return static_cast<std::uint8_t>(below(kUniform)); }
    std::uint16_t here() const { return static_cast<std::uint16_t>(bundles_.size()); }
    // Mostly small, so that addresses meet.
    int few(int bound) { return below(percent(70) ? 4 : bound); }
    std::uint16_t number() {
        return percent(50) ? static_cast<std::uint16_t>(random_())
                           : pick<std::uint16_t>({0, 1, 2, 15, 0x7fff, 0x8000, 0xffff});
    }

    // A sequencer's operation, sometimes others beside it.
    std::size_t emit_sequencer(SeqOp op, int counter = 0, std::uint16_t target = 0) {
        Bundle bundle = percent(options_.crowd) ? work() : Bundle{};
        bundle.seq = {op, static_cast<std::uint8_t>(counter), target};
        bundles_.push_back(bundle);
        return bundles_.size() - 1;
    }

    void block(int level, int loops, int length) {
        for (int i = 0; i < length; ++i) {
            statement(level, loops, length);
        }
    }

    void statement(int level, int loops, int length) {
        const int kind = below(100);
        if (kind < 8 && loops < kLoopsInside) {
            const int counter = level * kLoopsInside + loops;
            emit_sequencer(SeqOp::setc, counter, static_cast<std::uint16_t>(1 + below(3)));
            const std::uint16_t start = here();
            block(level, loops + 1, length / 3 + 1);
            emit_sequencer(SeqOp::dec, counter, start);
        } else if (kind < 18) {
            const std::size_t branch = emit_branch();
            block(level, loops, below(4));
            bundles_[branch].seq.target = here();
        } else if (kind < 22 && level + 1 < kLevels) {
            const bool by_pointer = level > 0 && percent(30);
            calls_.push_back({emit_sequencer(by_pointer ? SeqOp::setp : SeqOp::call), level + 1});
            if (by_pointer) {
                emit_sequencer(SeqOp::callp);
            }
        } else if (kind < 28) {
            setting();
        } else {
            straight_line();
        }
    }

    void straight_line() {
        for (int more = 1 + below(8); more > 0; --more) {
            if (percent(15)) {
                address_register();
            }
            bundles_.push_back(work());
        }
    }

    std::size_t emit_branch() {
        const SeqOp op = pick({SeqOp::jump, SeqOp::bt, SeqOp::bf, SeqOp::bor, SeqOp::bnor,
                               SeqOp::band, SeqOp::bnand, SeqOp::dec});
        return emit_sequencer(op, free_counter());
    }

    int free_counter() { return kFirstFreeCounter + below(kCounters - kFirstFreeCounter); }

    void setting() {
        const SeqOp op = pick({SeqOp::setc, SeqOp::ldc, SeqOp::phase, SeqOp::frame});
        const auto target = static_cast<std::uint16_t>(below(4));
        emit_sequencer(op, free_counter(),
                       op == SeqOp::setc || op == SeqOp::phase ? target : std::uint16_t{0});
    }

    // Subroutines called so far, and what these call; one body may serve several calls.
    void subroutines() {
        std::array<std::uint16_t, kLevels> start{};
        while (!calls_.empty()) {
            const Call call = calls_.back();
            calls_.pop_back();
            std::uint16_t& address = start[static_cast<std::size_t>(call.level)];
            const bool reuse = address != 0 && percent(60);
            if (!reuse) {
                address = here();
            }
            bundles_[call.from].seq.target = address;
            if (!reuse) {
                block(call.level, 0, 1 + below(options_.length / 2 + 1));
                emit_sequencer(SeqOp::ret);
            }
        }
    }

    void address_register() {
        Bundle bundle;
        if (percent(30)) {
            bundle.alu = {AluOp::mov, TestMode::set, kUniform, 0, 0, true};
            bundle.immediate = static_cast<std::uint16_t>(few(32));
        } else if (percent(50)) {
            bundle.alu = {AluOp::and_, TestMode::set, kOwn, source(), 0, true};
            bundle.immediate = pick<std::uint16_t>({3, 3, 31});
        } else {
            bundle.alu = {AluOp::add,
                          TestMode::set,
                          static_cast<std::uint8_t>(kHigh + below(2)),
                          pick<std::uint8_t>({kUniform, kOwn}),
                          0,
                          true};
            bundle.immediate = kHighBase;
        }
        bundles_.push_back(bundle);
    }

    // One operation or several, none of the sequencer's, that fit into a bundle.
    Bundle work() {
        Bundle bundle;
        bundle.immediate = number();
        for (int more = percent(options_.crowd) ? 2 + below(4) : 1; more > 0; --more) {
            const Bundle before = bundle;
            add_operation(bundle);
            if (conflict(bundle)) {
                bundle = before;
            }
        }
        return bundle;
    }

    void add_operation(Bundle& bundle) {
        const int kind = below(100);
        if (kind < 42) {
            bundle.alu = {percent(30) ? pick({AluOp::adds, AluOp::adc, AluOp::sbc, AluOp::tltb})
                                      : static_cast<AluOp>(1 + below(kAluOps - 1)),
                          pick({TestMode::set, TestMode::both, TestMode::either}),
                          destination(),
                          source(),
                          source(),
                          percent(30)};
        } else if (kind < 52) {
            bundle.mul = {
                pick({MulOp::mul, MulOp::mulu, MulOp::mulsu}), destination(), source(), source(),
                static_cast<std::uint8_t>(below(32)),          percent(30)};
        } else if (kind < 76) {
            bundle.mem = memory();
        } else if (kind < 86) {
            bundle.comm = communication();
        } else {
            bundle.sleep =
                percent(40) ? SleepOp::wake : static_cast<SleepOp>(1 + below(kSleepOps - 1));
        }
    }

    Bundle::Memory memory() {
        const auto op = pick({MemOp::ld, MemOp::ld, MemOp::st, MemOp::lds, MemOp::sts});
        const auto base = pick<std::uint8_t>({0, 0, kUniform, kOwn, kOwn, kHigh, kHigh + 1});
        const std::uint16_t start =
            base >= kHigh ? static_cast<std::uint16_t>(kWindow - kHighBase) : kWindow;
        return {op, static_cast<std::uint8_t>(below(percent(70) ? 1 : kSlowBanks)),
                is_load(op) ? destination() : source(), base,
                static_cast<std::uint16_t>(start + few(kWindowWords - 31))};
    }

    Bundle::Communication communication() {
        const auto op = static_cast<CommOp>(1 + below(kCommOps - 1));
        const int places = percent(80) ? 1 + below(4) : 1 + below(kMaxShift);
        return {op, op == CommOp::get || op == CommOp::aux ? destination() : source(),
                static_cast<std::uint16_t>(places)};
    }

    std::mt19937_64 random_;
    RandomProgramOptions options_;
    std::vector<Bundle> bundles_;
    std::vector<Call> calls_;
};

}  // namespace

Image RandomProgram::image() const {
    Image image;
    image.name = "random.s";
    image.entry = entry;
    Segment& segment = image.segments.emplace_back();
    for (std::size_t i = 0; i < bundles.size(); ++i) {
        for (const std::uint16_t word : encode(bundles[i])) {
            segment.bytes.push_back(static_cast<std::uint8_t>(word & 0xff));
            segment.bytes.push_back(static_cast<std::uint8_t>(word >> 8));
        }
        const auto address = static_cast<std::uint32_t>(i);
        image.lines.emplace(address, SourceLocation{image.name, static_cast<int>(i) + 1, 1});
        if (has_address(bundles[i].seq.op)) {
            const std::string label = fmt::format("l{}", bundles[i].seq.target);
            image.symbols.emplace(label, bundles[i].seq.target);
            image.labels.insert(label);
        }
    }
    return image;
}

RandomProgram random_program(std::uint64_t seed, const RandomProgramOptions& options) {
    return Generator(seed, options).program();
}

}  // namespace rasterloom::isa::vliw::testing
