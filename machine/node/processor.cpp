// SPDX-License-Identifier: MIT
#include "machine/node/processor.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom {

namespace {

// A core runs on to the next multiple of so many cycles without coming back: far enough to cost
// nothing, near enough for a progress bar.
constexpr std::int64_t kSlice = 65'536;
// Accesses to the I/O page in a row without the event queue, likewise.
constexpr int kMaxAdvances = 4'096;
// Where a cost model makes instructions free, a program may loop for ever at one time.
constexpr int kMaxStepsInNoTime = 1'000'000;
// Cycles of a slice put off that are executed at a time: few at first, so that the next access is
// soon known; then more, so that the way to and fro costs nothing.
constexpr std::int64_t kFirstPart = 128;
constexpr std::int64_t kLargestPart = 4'096;

}  // namespace

Processor::Processor(std::string name, std::unique_ptr<isa::Core> core, const Settings& settings)
    : Component(std::move(name)),
      settings_(settings),
      core_(std::move(core)),
      ports_(settings.node, settings.ports),
      port_states_(static_cast<std::size_t>(settings.ports.ports)),
      meter_(settings.node) {
    if (settings.max_message < 1) {
        throw std::invalid_argument(fmt::format("{}: max_message is at least 1 byte, not {}",
                                                this->name(), settings.max_message));
    }
    for (int port = 0; port < settings.ports.ports; ++port) {
        add_port(fmt::format("transmit {}", port), !ports_.transmits(port));
        add_port(fmt::format("receive {}", port), !ports_.receives(port));
    }
    if (settings.supervised) {
        add_port("supervisor");
    }
    if (settings.frame_buffer) {
        add_frame_buffer(*settings.frame_buffer);
    }
}

void Processor::start() {
    wake_at(Time::zero(), 0);
}

void Processor::handle(const Event& event) {
    if (event.phase() == EventPhase::arrival) {
        handle_arrival(event);
    } else {
        proceed();
    }
}

// Executes until control has to go back to the event queue.
void Processor::proceed() {
    advances_ = 0;
    execute();
}

void Processor::execute() {
    const ActsFor program(*this, bound_by_);
    bool going = true;
    while (going) {
        switch (next_) {
            case Next::run:
                going = run_private_instructions();
                break;
            case Next::step:
                going = step_io_instruction();
                break;
            case Next::wait:
                going = finish_wait();
                break;
            case Next::halt:
                meter_.halt(local_time_, executed());
                next_ = Next::nothing;
                going = false;
                break;
            case Next::fail:
                fail();
                going = false;
                break;
            case Next::nothing:
                going = false;
                break;
        }
    }
}

bool Processor::put_off_slice() {
    slice_put_off_ = true;
    scheduler().put_off(own_key(local_time_));
    return false;
}

void Processor::work_ahead(bool to_the_end) {
    if (to_the_end) {
        finish_slice();
        return;
    }
    if (std::exchange(slice_put_off_, false)) {
        works_ahead_ = true;
        execute();
        works_ahead_ = false;
    }
}

void Processor::finish_slice() {
    if (slice_put_off_) {
        part_ = kSlice;
        work_ahead(false);
    }
}

int Processor::weight() const {
    return 100;  // next to a link
}

// Lets everything that happens before the processor's own time happen. True when nothing does; else
// the processor has to give up control, and will be given it back at that time.
bool Processor::reach_local_time() {
    if (!works_ahead_) {
        if (now() == local_time_ || (settings_.run_ahead && ++advances_ < kMaxAdvances &&
                                     scheduler().advance_to(own_key(local_time_)))) {
            return true;
        }
    }
    wake_at(local_time_, 0);
    return false;
}

std::int64_t Processor::slice_end(std::int64_t cycle) {
    return (cycle / kSlice + 1) * kSlice;
}

std::int64_t Processor::budget() const {
    if (!settings_.run_ahead) {
        return 1;
    }
    if (enabled_interrupts_ == 0) {
        const std::int64_t slice = slice_end(cycle_) - cycle_;
        return works_ahead_ ? std::min(part_, slice) : slice;
    }
    // The next event anywhere can reach this node one tick later at the earliest; one that reaches
    // it now has come already.
    const Time horizon = scheduler().horizon().time;
    if (horizon == Time::never()) {
        return kSlice;
    }
    return std::clamp<std::int64_t>(settings_.clock.edge_at_or_after(horizon).count() - cycle_, 1,
                                    kSlice);
}

void Processor::spend(std::int64_t cycles) {
    if (cycles > 0) {
        cycle_ += cycles;
        cycles_executed_ += cycles;
        local_time_ = settings_.clock.edge(Cycles(cycle_));
        steps_in_no_time_ = 0;
    }
}

bool Processor::run_private_instructions() {
    if (enabled_interrupts_ > 0 && !reach_local_time()) {
        return false;
    }
    if (!works_ahead_ && enabled_interrupts_ == 0 && settings_.run_ahead &&
        scheduler().puts_work_off()) {
        part_ = kFirstPart;
        return put_off_slice();
    }
    interrupt_requested_ = false;
    const std::int64_t end = slice_end(cycle_);
    isa::Stop stop = runs_freely() ? core_->run_with(prompt_, budget()) : core_->run(budget());
    stop.cycles -= std::exchange(spent_of_run_, 0);
    if (foreseen_stall_ != Stall::none) {
        spend(stop.cycles);
        stall_ = std::exchange(foreseen_stall_, Stall::none);
        return false;
    }
    if (works_ahead_ && stop.reason == isa::StopReason::budget && cycle_ + stop.cycles < end) {
        spend(stop.cycles);
        part_ = std::min(2 * part_, kLargestPart);
        return put_off_slice();
    }
    return settle(stop);
}

bool Processor::step_io_instruction() {
    if (enabled_interrupts_ > 0 && !reach_local_time()) {
        return false;
    }
    must_catch_up_ = false;
    stall_ = Stall::none;
    accesses_ = 0;
    step_at_ = core_->program_counter();
    interrupt_requested_ = false;
    const isa::Stop stop = core_->step(*this);
    if (!error_.empty()) {
        return report_guest_error(std::move(error_), core_->program_counter());
    }
    if (stop.reason != isa::StopReason::retry) {
        if (++steps_in_no_time_ == kMaxStepsInNoTime) {
            return report_guest_error(
                "the program loops for ever in no time: its instructions cost nothing",
                core_->program_counter());
        }
        return settle(stop);
    }
    return false;
}

// What follows from the core's coming back.
bool Processor::settle(const isa::Stop& stop) {
    spend(stop.cycles);
    switch (stop.reason) {
        case isa::StopReason::io:
            next_ = Next::step;
            return true;
        case isa::StopReason::wait:
            next_ = Next::wait;
            break;
        case isa::StopReason::halt:
            next_ = Next::halt;
            break;
        case isa::StopReason::trap:
            return report_guest_error(fmt::format("{} {}", stop.trap->what,
                                                  format_word(stop.trap->address, settings_.radix)),
                                      stop.trap->pc);
        case isa::StopReason::budget:
            if (next_ == Next::step) {  // an access, not a slice: private instructions follow
                next_ = Next::run;
                return true;
            }
            break;
        case isa::StopReason::tap:
            return tell_tap();
        case isa::StopReason::retry:
            throw InvariantError(now(), name(), "the core answers retry where none was given");
    }
    return reach_local_time();
}

// The core passes over the tap when it runs on; the others need not catch up for that.
bool Processor::tell_tap() {
    if (++steps_in_no_time_ == kMaxStepsInNoTime) {
        return report_guest_error(
            "the program loops for ever in no time: its instructions cost nothing",
            core_->program_counter());
    }
    meter_.probe().tell([&](NodeListener& listener) {
        listener.tapped(
            {settings_.node, core_->program_counter(), cycles_executed_, local_time_, *core_});
    });
    return ++advances_ < kMaxAdvances || reach_local_time();
}

// A wait-for-interrupt instruction is over at once when a request came while the others caught up.
bool Processor::finish_wait() {
    next_ = Next::run;
    if (interrupt_requested_) {
        return true;
    }
    stall_ = Stall::interrupt;
    return false;
}

// Nobody may fail at an earlier time and be overlooked: so the error waits until everybody has
// caught up.
bool Processor::report_guest_error(std::string what, std::uint32_t program_counter) {
    next_ = Next::fail;
    error_ = std::move(what);
    error_at_ = program_counter;
    return reach_local_time();
}

void Processor::fail() {
    next_ = Next::nothing;
    meter_.halt(local_time_, executed());
    GuestError::Details found = details(cycle_, error_at_, error_);
    for (std::size_t i = 0; i < settings_.register_names.size(); ++i) {
        found.registers.emplace_back(settings_.register_names[i], core_->reg(static_cast<int>(i)));
    }
    scheduler().fail(std::make_shared<GuestError>(local_time_, name(), std::move(found)));
}

void Processor::close_books(Time end) {
    begin_stall_before(end);
    meter_.close(kind_of_stall(), std::max(end, local_time_), executed());
}

}  // namespace rasterloom
