// SPDX-License-Identifier: MIT
// The sequencer of a lock-step machine, with its array and its video output, as a component: it
// gives the array's cycles their time (Eldridge 1995, chapter 2; docs/vliw.md).
//
// Line-locked, the machine is a video machine: a scanline has `line` cycles, a picture `lines`
// scanlines, of which the first `visible_lines` are seen. With each scanline the program counter
// goes back to 0, and the host's next integer stands at the auxiliary input. A program that has not
// come to `line` by then is in error. At the end of a visible scanline the lanes' video registers
// are its pixels. `frame` says that a new picture is complete: the video shows it from the next
// scanline 0 on. A machine that is not line-locked goes on at once after `line`, and has no video.
// The program starts in the last scanline before the first picture.
#pragma once

#include "isa/image.hpp"
#include "isa/vliw/program.hpp"
#include "machine/fabric/lockstep_books.hpp"
#include "machine/kernel/clock.hpp"
#include "machine/kernel/component.hpp"
#include "machine/kernel/probe.hpp"
#include "machine/node/lockstep/lockstep_array.hpp"
#include "machine/node/node_listener.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace rasterloom {

class LockstepMachine final : public Component {
  public:
    struct Settings {
        Clock clock = Clock::with_frequency(14'000'000);
        bool line_locked = true;
        std::int64_t line = 910;           // cycles; at least 1
        std::int64_t lines = 525;          // at least 1
        std::int64_t visible_lines = 512;  // 1 ... lines
        std::int64_t frames = 1;           // at least 1
        LockstepArray::Settings array;
        std::shared_ptr<const isa::vliw::Program> program;
        // Of the program: where its lines are, what its labels are called, the word `error` that
        // says on every lane why the program halted (0: it has ended), error_name_* = what that
        // means.
        std::shared_ptr<const isa::Image> image;
    };

    // Throws std::invalid_argument when a setting is out of range.
    LockstepMachine(std::string name, const Settings& settings);

    LockstepArray& array() { return array_; }
    const LockstepArray& array() const { return array_; }
    const Settings& settings() const { return settings_; }
    // What the host sends with each picture from now on, one integer a scanline from scanline 0 on;
    // where there is none, the auxiliary input is 0.
    void send(std::vector<std::uint16_t> integers) { sent_ = std::move(integers); }

    // Is asked when `ending` is over, before a bundle of the phase `next` is executed; what it
    // says is wrong makes the run fail. Not after the last frame, whose phases count no more.
    using Inspector = std::function<std::string(const PhaseRecord& ending, int next)>;
    void inspect(Inspector inspector) { inspector_ = std::move(inspector); }

    // In progress: the first is 0, after `phase` n it is n. The frame counts from 0.
    const PhaseRecord& phase() const { return books_.phase(); }
    // Line-locked: how many complete pictures the video has shown. The run pauses when it has shown
    // one, and at the end of each frame: before anything else happens.
    std::int64_t pictures_shown() const { return shown_; }
    // Of the picture shown last, from the top: the lanes' video registers.
    std::span<const std::uint16_t> video_line(std::int64_t line) const;

    // Lanes tell of a phase when it has ended, each as a node of its own: the time that it was
    // awake comes first, wherever in the phase it was. After the last frame nothing is told or
    // counted.
    Probe<NodeListener>& lane_probe() { return lane_probe_; }
    Probe<SupervisorListener>& probe() { return probe_; }
    // The sequencer: busy while it executes, blocked while a scanline waits for its end.
    PartProbe& part_probe() { return part_probe_; }

    // Of the phases that have ended.
    const LockstepStatistics& statistics() const { return books_.statistics(); }
    const NodeStatistics& lane_statistics(std::int64_t lane) const { return books_.lane(lane); }
    // For a person: what it is at.
    std::string activity() const;

    void start() override;
    void handle(const Event& event) override;

  private:
    using Reason = LockstepArray::Reason;

    void begin_line();
    void run();
    void enter(PartState state);
    bool goes_on();
    bool change_phase();
    bool end_line();
    bool show_line();
    bool end_frame();
    void pause();
    void end_phase(int next);
    void end_program();
    std::uint32_t stopped_at() const;
    bool fail(std::uint32_t program_counter, const std::string& what);
    bool fail_overrun();
    std::string error_of_lanes() const;

    Settings settings_;
    LockstepArray array_;
    LockstepBooks books_;
    LockstepArray::Stop stop_;             // how the array came to where it stands
    std::int64_t cycle_ = 0;               // of the clock, when it came there
    std::int64_t line_end_ = 0;            // of the scanline: cycle
    std::int64_t line_;                    // of the picture
    std::uint16_t procedure_ = 0;          // that the scanline began with
    std::vector<std::uint16_t> sent_;      // by the host, from the next picture on
    std::vector<std::uint16_t> arriving_;  // [line]: with this picture
    std::int64_t complete_ = 0;            // frames
    std::int64_t shown_ = 0;
    bool showing_ = false;              // a picture that has not been shown before
    std::vector<std::uint16_t> video_;  // [line x lanes + lane]
    Inspector inspector_;
    Probe<NodeListener> lane_probe_;
    Probe<SupervisorListener> probe_;
    PartProbe part_probe_;
};

}  // namespace rasterloom
