// SPDX-License-Identifier: MIT
#include "machine/node/lockstep/lockstep_array.hpp"

#include "machine/node/lockstep/crew.hpp"
#include "machine/node/lockstep/kernels.hpp"
#include "machine/node/lockstep/lane_state.hpp"
#include "machine/node/lockstep/meeting.hpp"
#include "machine/node/lockstep/sequencer.hpp"
#include "machine/node/lockstep/transfer.hpp"
#include "machine/node/lockstep/translation.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom {
namespace {

constexpr std::int64_t kMaxLanes = 65'536;

LockstepArray::Settings checked(LockstepArray::Settings settings, const isa::vliw::Program& of) {
    if (settings.lanes < 1 || settings.lanes > kMaxLanes) {
        throw std::invalid_argument(
            fmt::format("a lock-step array has 1 to {} lanes, not {}", kMaxLanes, settings.lanes));
    }
    if (settings.threads < 1) {
        throw std::invalid_argument(
            fmt::format("a lock-step array needs a thread at least, not {}", settings.threads));
    }
    if (of.bundles.size() > std::size_t{std::numeric_limits<std::uint16_t>::max()} + 1) {
        throw std::invalid_argument(fmt::format(
            "a lock-step program has at most 65536 bundles, not {}", of.bundles.size()));
    }
    return settings;
}

}  // namespace

class LockstepArray::Engine {
  public:
    Engine(std::shared_ptr<const isa::vliw::Program> of, const Settings& settings)
        : program(std::move(of)),
          lanes(checked(settings, *program).lanes),
          transfers(lockstep::find_transfers(*program)),
          translation(*program, transfers, lockstep::LaneState::width_for(settings.lanes)),
          // A thread without a block would only be waited for.
          members(std::min(settings.threads, static_cast<int>(lanes.blocks.size()))),
          meeting(members),
          crew(members, [this](int member) { run_member(member); }) {
        lanes.flight.reserve(lanes.ring.size(), transfers);
        const auto count = static_cast<std::size_t>(members);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t first = lanes.blocks.size() * i / count;
            const std::size_t end = lanes.blocks.size() * (i + 1) / count;
            sequencers.emplace_back(*program, translation, lanes, meeting, static_cast<int>(i),
                                    std::span(lanes.blocks).subspan(first, end - first), transfers);
        }
    }

    Stop run(std::int64_t budget_cycles) {
        budget = budget_cycles;
        crew.work();
        return stop;
    }

    // Changes the state of all sequencers alike.
    template <class Change>
    void change(Change how) {
        for (auto& sequencer : sequencers) {
            how(sequencer.state());
        }
    }
    // With nothing of it anywhere else.
    lockstep::LaneMemory& memory() {
        for (lockstep::LaneBlock& block : lanes.blocks) {
            lockstep::land(block);
        }
        return lanes.memory;
    }
    const lockstep::SequencerState& state() const { return sequencers.front().state(); }
    std::size_t ring_place(std::int64_t lane) const {
        return (state().ring_offset + static_cast<std::size_t>(lane)) % lanes.ring.size();
    }

    std::shared_ptr<const isa::vliw::Program> program;
    lockstep::LaneState lanes;
    std::vector<lockstep::Transfer> transfers;
    lockstep::Translation translation;
    int members;
    lockstep::Meeting meeting;
    std::vector<lockstep::Sequencer> sequencers;

  private:
    void run_member(int member) {
        Stop member_stop = sequencers[static_cast<std::size_t>(member)].run(budget);
        if (member == 0) {
            stop = std::move(member_stop);
        }
    }

    std::int64_t budget = 0;
    Stop stop;
    lockstep::Crew crew;  // the last: its threads end before what they use
};

LockstepArray::LockstepArray(std::shared_ptr<const isa::vliw::Program> program,
                             const Settings& settings)
    : engine_(std::make_unique<Engine>(std::move(program), settings)) {}
LockstepArray::~LockstepArray() = default;

std::int64_t LockstepArray::lanes() const {
    return engine_->lanes.lanes();
}
LockstepArray::Stop LockstepArray::run(std::int64_t budget_cycles) {
    return engine_->run(budget_cycles);
}
void LockstepArray::restart() {
    engine_->change([](auto& state) {
        state.program_counter = 0;
        state.depth = 0;
    });
}
void LockstepArray::set_program_counter(std::uint16_t address) {
    engine_->change([address](auto& state) { state.program_counter = address; });
}
std::uint16_t LockstepArray::program_counter() const {
    return engine_->state().program_counter;
}
std::uint16_t LockstepArray::procedure() const {
    return engine_->state().procedure;
}
void LockstepArray::set_aux(std::uint16_t value) {
    engine_->lanes.parts.aux = value;
}

std::uint16_t LockstepArray::read(std::int64_t lane, std::uint32_t address) const {
    std::uint16_t value = 0;
    read(lane, address, std::span(&value, 1));
    return value;
}
void LockstepArray::read(std::int64_t lane, std::uint32_t address,
                         std::span<std::uint16_t> words) const {
    engine_->memory().read(lane, address, words);
}
void LockstepArray::write(std::int64_t lane, std::uint32_t address,
                          std::span<const std::uint16_t> words) {
    engine_->memory().write(lane, address, words);
}
void LockstepArray::write_all(std::uint32_t address, std::span<const std::uint16_t> words) {
    engine_->memory().write_all(address, words);
}
void LockstepArray::set_layout(std::uint32_t first, std::uint32_t words, LaneLayout layout) {
    engine_->memory().set_layout(first, words, layout);
}

std::uint16_t LockstepArray::reg(std::int64_t lane, int index) const {
    return engine_->lanes.block_of(lane).row(index)[engine_->lanes.place_of(lane)];
}
void LockstepArray::set_reg(std::int64_t lane, int index, std::uint16_t value) {
    if (index != 0) {
        engine_->lanes.block_of(lane).row(index)[engine_->lanes.place_of(lane)] = value;
    }
}
bool LockstepArray::carry(std::int64_t lane) const {
    return engine_->lanes.bit(engine_->lanes.block_of(lane).carry, lane);
}
bool LockstepArray::test(std::int64_t lane) const {
    return engine_->lanes.bit(engine_->lanes.block_of(lane).test, lane);
}
bool LockstepArray::asleep(std::int64_t lane) const {
    return !engine_->lanes.bit(engine_->lanes.block_of(lane).awake, lane);
}
std::uint16_t LockstepArray::communication(std::int64_t lane) const {
    return engine_->lanes.ring[engine_->ring_place(lane)];
}
std::uint16_t LockstepArray::video(std::int64_t lane) const {
    return reg(lane, lockstep::kVideoRow);
}
std::uint16_t LockstepArray::counter(int index) const {
    return engine_->state().counters[static_cast<std::size_t>(index)];
}

std::int64_t LockstepArray::bundles_executed() const {
    return engine_->state().bundles;
}
std::int64_t LockstepArray::operations_executed() const {
    return engine_->state().operations;
}
std::vector<std::int64_t> LockstepArray::profile() const {
    return engine_->sequencers.front().profile();
}
std::int64_t LockstepArray::awake_cycles(std::int64_t lane) const {
    const auto& lanes = engine_->lanes;
    return lockstep::awake_cycles(lanes.block_of(lane), lanes.place_of(lane),
                                  engine_->state().cycles);
}

std::vector<std::string> LockstepArray::paths() {
    return lockstep::kernel_paths();
}
void LockstepArray::use_path(std::string_view name) {
    lockstep::use_kernel_path(name);
}

}  // namespace rasterloom
