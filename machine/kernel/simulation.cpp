// SPDX-License-Identifier: MIT
#include "machine/kernel/simulation.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace rasterloom {

namespace {

std::string describe(const Component& component, PortIndex port) {
    const auto index = static_cast<std::size_t>(port);
    return component.name() + " port " + std::to_string(index) +
           (index < component.ports().size() ? " (" + component.ports()[index].name() + ")" : "");
}

}  // namespace

PortIndex Component::add_port(std::string port_name, bool may_stay_open) {
    if (scheduler_ != nullptr) {
        throw WiringError(name_ + ": port " + port_name + " added after the machine was sealed");
    }
    if (ports_.size() > std::numeric_limits<std::uint16_t>::max()) {
        throw WiringError(name_ + ": has 65536 ports already");
    }
    ports_.emplace_back(std::move(port_name), may_stay_open);
    return static_cast<PortIndex>(ports_.size() - 1);
}

Simulation::Simulation() {
    schedulers_.push_back(std::make_unique<Scheduler>());
    schedulers_[0]->components_ = &components_;
}

void Simulation::require_open(const std::string& action) const {
    if (sealed_) {
        throw WiringError(action + ": the machine is sealed already");
    }
}

void Simulation::adopt(std::unique_ptr<Component> component) {
    require_open("add component " + component->name());
    components_.push_back(std::move(component));
}

void Simulation::check_end(const Component& component, PortIndex port) const {
    const auto index = static_cast<std::size_t>(port);
    if (index >= component.ports_.size()) {
        throw WiringError("connect " + describe(component, port) + ": it has " +
                          std::to_string(component.ports_.size()) + " ports, counted from 0");
    }
    if (component.ports_[index].connected()) {
        throw WiringError("connect " + describe(component, port) + ": it has a wire already");
    }
}

void Simulation::connect(Component& a, PortIndex port_a, Component& b, PortIndex port_b,
                         Duration latency) {
    require_open("connect " + describe(a, port_a));
    check_end(a, port_a);
    check_end(b, port_b);
    const std::string both = "connect " + describe(a, port_a) + " with " + describe(b, port_b);
    if (&a == &b && port_a == port_b) {
        throw WiringError(both + ": a wire has two ends");
    }
    if (latency < Duration::tick()) {
        throw WiringError(both + ": the latency is at least 1 ps, not " + to_string(latency));
    }
    a.ports_[static_cast<std::size_t>(port_a)].latency_ = latency;
    b.ports_[static_cast<std::size_t>(port_b)].latency_ = latency;
    wires_.push_back({{&a, &b}, {port_a, port_b}});
}

void Simulation::check_ports_connected() const {
    for (const auto& component : components_) {
        for (std::size_t port = 0; port < component->ports_.size(); ++port) {
            if (!component->ports_[port].connected() && !component->ports_[port].may_stay_open()) {
                throw WiringError("seal: " + describe(*component, static_cast<PortIndex>(port)) +
                                  " has no wire");
            }
        }
    }
}

void Simulation::seal() {
    require_open("seal");
    if (components_.size() > kMaxComponents) {
        throw WiringError("seal: more than " + std::to_string(kMaxComponents) + " components");
    }
    check_ports_connected();
    std::sort(components_.begin(), components_.end(),
              [](const auto& a, const auto& b) { return a->name_ < b->name_; });
    const auto twin =
        std::adjacent_find(components_.begin(), components_.end(),
                           [](const auto& a, const auto& b) { return a->name_ == b->name_; });
    if (twin != components_.end()) {
        throw WiringError("seal: two components are named " + (*twin)->name_);
    }
    for (std::size_t id = 0; id < components_.size(); ++id) {
        components_[id]->id_ = static_cast<ComponentId>(id);
        components_[id]->scheduler_ = schedulers_[0].get();
    }
    join_wires();
    sealed_ = true;
}

void Simulation::join_wires() {
    for (const Wire& wire : wires_) {
        for (std::size_t here = 0; here < 2; ++here) {
            const std::size_t there = 1 - here;
            Port& port = wire.end[here]->ports_[static_cast<std::size_t>(wire.port[here])];
            if (wire.end[there]->scheduler_ == nullptr) {
                throw WiringError("seal: " + wire.end[here]->name_ + " is wired to " +
                                  wire.end[there]->name_ + ", which is not part of the machine");
            }
            port.peer_ = wire.end[there]->id_;
            port.peer_port_ = wire.port[there];
            port.peer_keeps_ =
                wire.end[there]->ports_[static_cast<std::size_t>(wire.port[there])].kept_.get();
        }
    }
}

void Simulation::listen_to_causes(CauseListener& listener) {
    for (std::size_t partition = 0; partition < schedulers_.size(); ++partition) {
        listen_to_causes(partition, listener);
    }
}

void Simulation::listen_to_causes(std::size_t partition, CauseListener& listener) {
    schedulers_[partition]->cause_listener_ = &listener;
}

void Simulation::start_components() {
    started_ = true;
    for (const auto& component : components_) {
        component->start();
    }
}

Time Simulation::now() const {
    Time now;
    for (const auto& scheduler : schedulers_) {
        now = std::max(now, scheduler->now());
    }
    return now;
}

std::uint64_t Simulation::events_handled() const {
    std::uint64_t sum = 0;
    for (const auto& scheduler : schedulers_) {
        sum += scheduler->events_handled_;
    }
    return sum;
}

RunResult Simulation::run(Time limit) {
    if (!sealed_) {
        throw WiringError("run: the machine is not sealed yet");
    }
    const EventKey limit_key = limit == Time::never() ? kNoEvent : EventKey{limit, 0};
    for (const auto& scheduler : schedulers_) {
        scheduler->begin_run(limit_key);
    }
    if (!started_) {
        start_components();
    }
    if (failed_) {
        return *failed_;
    }
    if (rounds_) {
        rounds_->run();
    } else {
        schedulers_[0]->run_alone();
    }
    const RunResult result = conclude(limit_key);
    if (result.end == RunEnd::failed) {
        failed_ = result;
    }
    return result;
}

// The run has ended because somebody asked for it. Of several, what comes first counts: it would
// have kept the others from happening.
RunResult Simulation::ended_early(EventKey limit) const {
    const Scheduler* first = nullptr;
    for (const auto& scheduler : schedulers_) {
        if (scheduler->stop_requested_ &&
            (first == nullptr || scheduler->stopped_at_ < first->stopped_at_)) {
            first = scheduler.get();
        }
    }
    if (first != nullptr) {
        return {first->failure_ != nullptr ? RunEnd::failed : RunEnd::stopped,
                first->stopped_at_.time, first->failure_};
    }
    EventKey end = limit;
    for (const auto& scheduler : schedulers_) {
        end = std::min(end, scheduler->limit_);
    }
    return {end < limit ? RunEnd::paused : RunEnd::limit, end.time, nullptr};
}

RunResult Simulation::conclude(EventKey limit) {
    bool stopped = false;
    bool empty = !rounds_ || !rounds_->has_mail();
    for (const auto& scheduler : schedulers_) {
        stopped = stopped || scheduler->stop_requested_;
        empty = empty && scheduler->next_key() == kNoEvent;
    }
    if (stopped || !empty) {
        return ended_early(limit);
    }
    std::vector<Deadlock::Waiter> waiters;
    Time end = now();
    for (const auto& component : components_) {
        end = std::max(end, component->reached());
        if (auto reason = component->waits_for()) {
            waiters.push_back({component->name(), std::move(*reason)});
        }
    }
    if (waiters.empty()) {
        return {RunEnd::finished, end, nullptr};
    }
    return {RunEnd::failed, end, std::make_shared<Deadlock>(end, std::move(waiters))};
}

}  // namespace rasterloom
