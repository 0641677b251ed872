// SPDX-License-Identifier: MIT
#include "machine/fabric/lockstep_machine.hpp"

#include "machine/fabric/lockstep_error.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom {

namespace {

enum class LockstepEvent : EventKind { stopped, pause_over };

// Of a machine that is not line-locked: events often enough to show how far it has come.
constexpr std::int64_t kSlice = 100'000;  // cycles
// How far an overrun is followed to tell how long it is.
constexpr std::int64_t kOverrunLines = 1'000;

void require(bool holds, const std::string& what) {
    if (!holds) {
        throw std::invalid_argument(what);
    }
}

}  // namespace

LockstepMachine::LockstepMachine(std::string name, const Settings& settings)
    : Component(std::move(name)),
      settings_(settings),
      array_(settings.program, settings.array),
      books_(array_, settings.clock),
      line_(settings.lines - 1) {
    require(settings.line >= 1, "a scanline has at least 1 cycle");
    require(settings.visible_lines >= 1 && settings.visible_lines <= settings.lines,
            "a picture has at least 1 visible scanline, and no more than it has scanlines");
    require(settings.frames >= 1, "a run has at least 1 frame");
    if (settings.line_locked) {
        video_.resize(static_cast<std::size_t>(settings.visible_lines * settings.array.lanes));
    }
}

std::span<const std::uint16_t> LockstepMachine::video_line(std::int64_t line) const {
    const auto lanes = static_cast<std::size_t>(array_.lanes());
    return std::span(video_).subspan(static_cast<std::size_t>(line) * lanes, lanes);
}

std::string LockstepMachine::activity() const {
    return fmt::format("{} is in phase {} of frame {}, scanline {}, procedure {}", name(),
                       phase().phase, phase().frame, statistics().scanlines,
                       label_before(*settings_.image, array_.procedure()));
}

void LockstepMachine::start() {
    begin_line();
    run();
}

void LockstepMachine::begin_line() {
    books_.begin_scanline();
    line_end_ = cycle_ + settings_.line;
    procedure_ = array_.procedure();
    if (line_ == 0) {
        showing_ = complete_ > shown_;
        arriving_ = sent_;
    }
    const auto line = static_cast<std::size_t>(line_);
    array_.set_aux(line < arriving_.size() ? arriving_[line] : std::uint16_t{0});
}

// Up to the next thing that concerns the machine; what that is to have happened at its time.
void LockstepMachine::run() {
    enter(PartState::busy);
    stop_ = array_.run(settings_.line_locked ? line_end_ - cycle_ : kSlice);
    cycle_ += stop_.cycles;
    books_.executed(stop_.cycles);
    if (settings_.line_locked && stop_.reason == Reason::line && cycle_ < line_end_) {
        enter(PartState::blocked);
        books_.idle(line_end_ - std::exchange(cycle_, line_end_));
    }
    wake_at(std::max(settings_.clock.edge(Cycles(cycle_)), now()),
            static_cast<EventKind>(LockstepEvent::stopped));
}

// After the last frame it counts as idle, whatever the program does.
void LockstepMachine::enter(PartState state) {
    if (phase().frame == settings_.frames) {
        state = PartState::idle;
    }
    books_.enter(state, cycle_);
    part_probe_.enter(id(), state, settings_.clock.edge(Cycles(cycle_)));
}

void LockstepMachine::handle(const Event& event) {
    if (event.kind == static_cast<EventKind>(LockstepEvent::pause_over) || goes_on()) {
        run();
    }
}

// Does what the array has stopped for. Whether it runs on at once.
bool LockstepMachine::goes_on() {
    switch (stop_.reason) {
        case Reason::budget:
            return !settings_.line_locked || fail_overrun();
        case Reason::line:
            return end_line();
        case Reason::phase:
            return stop_.phase == phase().phase || change_phase();
        case Reason::frame:
            return end_frame();
        case Reason::halt:
            end_program();
            return false;
        case Reason::trap:
            return fail(array_.program_counter(), stop_.trap);
    }
    return false;
}

bool LockstepMachine::change_phase() {
    if (inspector_ && phase().frame < settings_.frames) {
        if (const std::string wrong = inspector_(phase(), stop_.phase); !wrong.empty()) {
            return fail(stopped_at(), fmt::format("frame {}: {}", phase().frame, wrong));
        }
    }
    end_phase(stop_.phase);
    return true;
}

bool LockstepMachine::end_line() {
    if (settings_.line_locked && cycle_ > line_end_) {
        return fail_overrun();
    }
    const bool whole = settings_.line_locked && show_line();
    line_ = (line_ + 1) % settings_.lines;
    if (whole && shown_ == settings_.frames) {
        return false;
    }
    begin_line();
    if (whole) {
        pause();
    }
    return !whole;
}

// Whether the video has now shown the whole of a new picture.
bool LockstepMachine::show_line() {
    if (!showing_ || line_ >= settings_.visible_lines) {
        return false;
    }
    const std::int64_t lanes = array_.lanes();
    for (std::int64_t lane = 0; lane < lanes; ++lane) {
        video_[static_cast<std::size_t>(line_ * lanes + lane)] = array_.video(lane);
    }
    if (line_ + 1 < settings_.visible_lines) {
        return false;
    }
    showing_ = false;
    ++shown_;
    return true;
}

bool LockstepMachine::end_frame() {
    if (settings_.line_locked && complete_ > shown_) {
        return fail(stopped_at(),
                    fmt::format("picture {} is complete, but the video has not shown all of "
                                "picture {} yet",
                                complete_, complete_ - 1));
    }
    ++complete_;
    if (phase().frame == settings_.frames) {
        return true;  // only to show it
    }
    end_phase(phase().phase);
    books_.end_frame();
    enter(PartState::busy);
    probe_.tell([this](SupervisorListener& listener) {
        listener.frame_ended(static_cast<int>(complete_ - 1), now());
    });
    if (!settings_.line_locked && complete_ == settings_.frames) {
        return false;
    }
    pause();
    return false;
}

// So that the machine can be looked at as it is now.
void LockstepMachine::pause() {
    const Time later = now() + Duration::tick();
    scheduler().pause_before(later);
    wake_at(later, static_cast<EventKind>(LockstepEvent::pause_over));
}

void LockstepMachine::end_phase(int next) {
    if (phase().frame == settings_.frames) {
        return;
    }
    const PhaseRecord ended = books_.next_phase(next, cycle_, scheduler().handling(), lane_probe_);
    probe_.tell([&](SupervisorListener& listener) { listener.phase_ended(ended); });
}

void LockstepMachine::end_program() {
    if (const std::string error = error_of_lanes(); !error.empty()) {
        fail(stopped_at(), error);
        return;
    }
    if (complete_ == 0) {
        end_phase(phase().phase);
        books_.end_frame();
        probe_.tell([this](SupervisorListener& listener) { listener.frame_ended(0, now()); });
    }
    enter(PartState::idle);
}

// The first lane whose word `error` is not 0.
std::string LockstepMachine::error_of_lanes() const {
    const isa::Image& image = *settings_.image;
    const auto word = image.symbol("error");
    if (!word || image.labels.contains("error")) {
        return {};
    }
    for (std::int64_t lane = 0; lane < array_.lanes(); ++lane) {
        const std::uint16_t error = array_.read(lane, *word);
        if (error == 0) {
            continue;
        }
        std::string meaning = fmt::format("error {}", error);
        constexpr std::string_view kPrefix = "error_name_";
        for (const auto& [symbol, value] : image.symbols) {
            if (symbol.starts_with(kPrefix) && value == error) {
                meaning = symbol.substr(kPrefix.size());
                std::replace(meaning.begin(), meaning.end(), '_', ' ');
            }
        }
        return fmt::format("the program has halted: lane {}: {}", lane, meaning);
    }
    return {};
}

// The bundle that has been executed last, where that is a `halt` or a `frame`.
std::uint32_t LockstepMachine::stopped_at() const {
    return std::uint32_t{array_.program_counter()} - 1;
}

bool LockstepMachine::fail(std::uint32_t program_counter, const std::string& what) {
    LockstepError::Details details;
    details.cycle = cycle_;
    details.scanline = statistics().scanlines - 1;
    details.program_counter = program_counter;
    if (const isa::SourceLocation* source = settings_.image->source_of(program_counter)) {
        details.source = *source;
    }
    details.what = what;
    scheduler().fail(std::make_shared<LockstepError>(now(), name(), std::move(details)));
    return false;
}

bool LockstepMachine::fail_overrun() {
    const std::int64_t most = kOverrunLines * settings_.line;
    std::int64_t cycles = cycle_ - (line_end_ - settings_.line);
    Reason reason = stop_.reason;
    while (reason != Reason::line && reason != Reason::halt && reason != Reason::trap &&
           cycles < most) {
        const LockstepArray::Stop further = array_.run(most - cycles);
        cycles += further.cycles;
        reason = further.reason;
    }
    const std::string takes =
        reason == Reason::line
            ? fmt::format("takes {} cycles, {} more than a scanline has", cycles,
                          cycles - settings_.line)
            : fmt::format("has not come to `line` after {} cycles; a scanline has {}", cycles,
                          settings_.line);
    return fail(procedure_, fmt::format("overrun: with procedure {} the program {}",
                                        label_before(*settings_.image, procedure_), takes));
}

}  // namespace rasterloom
