// SPDX-License-Identifier: MIT
// Listens to messages and phases while the machine runs and sums them up. A message belongs to the
// phase in which it is consumed: a phase ends when all its messages are.
#pragma once

#include "machine/fabric/supervisor.hpp"
#include "machine/node/node_listener.hpp"
#include "machine/observe/run_report.hpp"

#include <optional>
#include <vector>

namespace rasterloom::observe {

class PhaseLog final : public NodeListener, public SupervisorListener {
  public:
    // `round`: the time every message takes, above zero, when it is the same for all.
    explicit PhaseLog(std::optional<Duration> round) : round_(round) {}

    void message_consumed(const MessageRecord& message) override;
    void phase_ended(const PhaseRecord& phase) override;
    void frame_ended(int frame, Time at) override;

    const std::vector<Time>& frame_ends() const { return frame_ends_; }
    // All phases; without a supervisor the whole run is one. To be called once, at the end of the
    // run.
    std::vector<PhaseReport> finish(Time at);

  private:
    struct Sender {
        Time started;
        NodeIndex node;
    };

    RoundsReport count_rounds(Time began);

    std::optional<Duration> round_;
    PhaseReport current_;
    std::vector<Sender> senders_;  // of the current phase
    std::vector<PhaseReport> finished_;
    std::vector<Time> frame_ends_;
};

}  // namespace rasterloom::observe
