// SPDX-License-Identifier: MIT
#include "machine/fabric/supervisor.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom {

Supervisor::Supervisor(std::string name, const Settings& settings)
    : Component(std::move(name)), settings_(settings), outstanding_(settings.nodes) {
    const auto require = [this](bool holds, const char* what) {
        if (!holds) {
            throw std::invalid_argument(fmt::format("{}: {}", this->name(), what));
        }
    };
    require(settings.latency >= 2 * Duration::tick(), "the latency is at least 2 ps");
    require(settings.phases_per_frame >= 1, "a frame has at least 1 phase");
    require(settings.frames >= 1, "a run has at least 1 frame");
    require(settings.nodes >= 1, "a supervisor has at least 1 node");
    nodes_.resize(static_cast<std::size_t>(settings.nodes));
    processors_.resize(nodes_.size());
    for (int node = 0; node < settings.nodes; ++node) {
        add_port(fmt::format("node {}", node));
    }
}

Duration Supervisor::up() const {
    return Duration::picoseconds(settings_.latency.picoseconds() / 2);
}

void Supervisor::connect(Simulation& simulation, int index, Processor& node) {
    processors_[static_cast<std::size_t>(index)] = &node;
    connect(simulation, index, node, node.supervisor_port());
}

void Supervisor::connect(Simulation& simulation, int index, Component& node, PortIndex port) {
    nodes_[static_cast<std::size_t>(index)] = &node;
    // A wire takes the same time either way; the odd tick is added to the announcement.
    simulation.connect(*this, static_cast<PortIndex>(index), node, port, up());
}

void Supervisor::handle(const Event& event) {
    const std::int64_t change = credit_of(event.payload).change;
    if (change == 0) {
        return;
    }
    if (over_ || now() - up() < current_.began) {
        fail_count(event, fmt::format("CREDIT {} after the phase had ended", change));
        return;
    }
    outstanding_ += change;
    if (outstanding_ < 0) {
        fail_count(event, fmt::format("CREDIT {} takes away more than is outstanding ({})", change,
                                      outstanding_ - change));
        return;
    }
    if (outstanding_ == 0) {
        end_phase();
    }
}

void Supervisor::fail_count(const Event& event, const std::string& what) {
    const auto node = static_cast<std::size_t>(event.port);
    const std::string where =
        fmt::format("{}, in phase {} of frame {}", what, current_.phase, current_.frame);
    if (processors_[node] == nullptr) {
        scheduler().fail(std::make_shared<CreditError>(now() - up(), nodes_[node]->name(), where));
        return;
    }
    scheduler().fail(
        processors_[node]->mistake(now() - up(), credit_of(event.payload).program_counter, where));
}

std::string CreditError::message() const {
    return fmt::format(
        "at {}: {}: {}; this node runs no program, so another has given back more than it had",
        to_string(time()), component(), what_);
}

void Supervisor::end_phase() {
    current_.ended = now();
    current_.ended_by = scheduler().handling();
    probe_.tell([this](SupervisorListener& listener) { listener.phase_ended(current_); });
    const bool frame_over = current_.phase + 1 == settings_.phases_per_frame;
    if (frame_over) {
        probe_.tell(
            [this](SupervisorListener& listener) { listener.frame_ended(current_.frame, now()); });
        if (settings_.pause_after_frame) {
            scheduler().pause_before(now() + up());
        }
    }
    over_ = frame_over && current_.frame + 1 == settings_.frames;
    const Duration down = settings_.latency - up();
    ++current_.number;
    current_.phase = frame_over ? 0 : current_.phase + 1;
    current_.frame += frame_over ? 1 : 0;
    current_.began = now() + down;
    outstanding_ = settings_.nodes;
    // PHASE counts on through the frames; it never shows the mark of the end before the end.
    const std::uint64_t shown =
        over_ ? kRunOver : static_cast<std::uint64_t>(current_.number % kRunOver);
    for (int node = 0; node < settings_.nodes; ++node) {
        send(static_cast<PortIndex>(node), static_cast<EventKind>(SupervisorEvent::phase), shown,
             current_.began - up());
    }
}

std::optional<std::string> Supervisor::waits_for() const {
    if (over_) {
        return std::nullopt;
    }
    return fmt::format("the end of phase {} of frame {}: {} of work outstanding", current_.phase,
                       current_.frame, outstanding_);
}

}  // namespace rasterloom
