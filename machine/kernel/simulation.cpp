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

void Scheduler::report_event_in_the_past(const Event& event) const {
    const auto name = [this](ComponentId id) -> const std::string& {
        return (*components_)[static_cast<std::size_t>(id)]->name();
    };
    throw InvariantError(current_.time, name(event.source()),
                         "sends an event to " + name(event.target()) + " for " +
                             to_string(event.time()) + ", which is before what happens now");
}

void Scheduler::fail(std::shared_ptr<const Failure> failure) {
    if (failure_ == nullptr) {
        failure_ = std::move(failure);
    }
    stop_requested_ = true;
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
        components_[id]->scheduler_ = &scheduler_;
    }
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
        }
    }
    scheduler_.components_ = &components_;
    sealed_ = true;
}

void Simulation::start_components() {
    started_ = true;
    for (const auto& component : components_) {
        component->start();
    }
}

RunResult Simulation::run(Time limit) {
    if (!sealed_) {
        throw WiringError("run: the machine is not sealed yet");
    }
    scheduler_.bound_ = limit == Time::never() ? kNoEvent : EventKey{limit, 0};
    scheduler_.stop_requested_ = scheduler_.failure_ != nullptr;
    if (!started_) {
        start_components();
    }
    EventQueue& queue = scheduler_.queue_;
    while (!scheduler_.stop_requested_ && queue.next_key() < scheduler_.bound_) {
        const Event event = queue.pop();
        scheduler_.current_ = event.key;
        ++events_handled_;
        components_[static_cast<std::size_t>(event.target())]->handle(event);
    }
    return conclude(limit);
}

RunResult Simulation::conclude(Time limit) {
    if (scheduler_.failure_ != nullptr) {
        return {RunEnd::failed, now(), scheduler_.failure_};
    }
    if (scheduler_.stop_requested_) {
        return {RunEnd::stopped, now(), nullptr};
    }
    if (!scheduler_.queue_.empty()) {
        return {RunEnd::limit, limit, nullptr};
    }
    std::vector<Deadlock::Waiter> waiters;
    for (const auto& component : components_) {
        if (auto reason = component->waits_for()) {
            waiters.push_back({component->name(), std::move(*reason)});
        }
    }
    if (waiters.empty()) {
        return {RunEnd::finished, now(), nullptr};
    }
    scheduler_.failure_ = std::make_shared<Deadlock>(now(), std::move(waiters));
    return {RunEnd::failed, now(), scheduler_.failure_};
}

}  // namespace rasterloom
