// SPDX-License-Identifier: MIT
// Strothotte's processor supervisor: counts the work outstanding, and announces the next phase to
// all nodes when there is none.
//
// At the start of a phase the count is the number of nodes. CREDIT adds to it; at zero the phase is
// over, and every node sees the next one `latency` after the write that made it zero. (Half of the
// latency is on the way up, half on the way down; so two writes are counted in the order in which
// they were made.)
#pragma once

#include "machine/kernel/probe.hpp"
#include "machine/kernel/simulation.hpp"
#include "machine/node/processor.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rasterloom {

struct PhaseRecord {
    std::int64_t number = 0;  // counted from 0 through the whole run
    int frame = 0;
    int phase = 0;                // within its frame
    Time began;                   // the nodes saw it
    Time ended;                   // the count was zero
    EventId ended_by = kNoCause;  // the credit that made it so
};

// A node that runs no program gave a credit that the count does not allow: so some program gave
// back more than it had.
class CreditError final : public Failure {
  public:
    CreditError(Time time, std::string component, std::string what)
        : Failure(time, std::move(component)), what_(std::move(what)) {}
    std::string message() const override;

  private:
    std::string what_;
};

class SupervisorListener {
  public:
    virtual ~SupervisorListener() = default;
    virtual void phase_ended(const PhaseRecord&) {}
    // After phase_ended of the frame's last phase: every program has done its work. (Its memory can
    // be looked at only while the simulation does not run: Supervisor::Settings.)
    virtual void frame_ended(int /*frame*/, Time) {}
};

class Supervisor final : public Component {
  public:
    struct Settings {
        Duration latency = Duration::microseconds(1);  // at least 2 ticks
        int phases_per_frame = 1;                      // at least 1
        int frames = 1;                                // at least 1
        int nodes = 1;                                 // at least 1
        // Simulation::run() comes back at the end of each frame, before any node can see the next
        // phase: so the machine can be looked at as the frame left it.
        bool pause_after_frame = false;
    };

    // Throws std::invalid_argument when a setting is out of range.
    Supervisor(std::string name, const Settings& settings);

    // Lays the wire to node number `index`, 0 to nodes - 1: a processor...
    void connect(Simulation& simulation, int index, Processor& node);
    // ...or another component that keeps the protocol of SupervisorEvent at one of its ports.
    void connect(Simulation& simulation, int index, Component& node, PortIndex port);

    bool over() const { return over_; }
    const PhaseRecord& phase() const { return current_; }  // in progress
    std::int64_t outstanding() const { return outstanding_; }
    Probe<SupervisorListener>& probe() { return probe_; }

    void handle(const Event& event) override;
    std::optional<std::string> waits_for() const override;
    bool stands_apart() const override { return true; }

  private:
    void end_phase();
    Duration up() const;
    void fail_count(const Event& event, const std::string& what);

    Settings settings_;
    std::vector<const Component*> nodes_;       // by port
    std::vector<const Processor*> processors_;  // likewise; null for another component
    std::int64_t outstanding_;
    bool over_ = false;
    PhaseRecord current_;
    Probe<SupervisorListener> probe_;
};

}  // namespace rasterloom
