// SPDX-License-Identifier: MIT
// How a run can end badly. A failure of the emulated machine (deadlock, guest error) is a value
// that the run returns; misuse of the kernel and broken invariants are exceptions.
#pragma once

#include "machine/kernel/time.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace rasterloom {

// The emulated machine cannot go on.
class Failure {
  public:
    Failure(Time time, std::string component) : time_(time), component_(std::move(component)) {}
    virtual ~Failure() = default;

    Time time() const { return time_; }
    const std::string& component() const {
        return component_;
    }                                         // its name; empty when it is not one alone
    virtual std::string message() const = 0;  // one or more lines, for a person

  private:
    Time time_;
    std::string component_;
};

// No event is left, and components still wait.
class Deadlock final : public Failure {
  public:
    struct Waiter {
        std::string component;
        std::string waits_for;
    };
    Deadlock(Time time, std::vector<Waiter> waiters)
        : Failure(time, ""), waiters_(std::move(waiters)) {}

    const std::vector<Waiter>& waiters() const { return waiters_; }
    std::string message() const override;

  private:
    std::vector<Waiter> waiters_;  // in the order of component ids
};

// A machine wired wrongly, or a kernel call at the wrong time: says which component or port, and
// what was expected.
class WiringError : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

// What must never happen did: names time and component.
class InvariantError : public std::logic_error {
  public:
    InvariantError(Time time, const std::string& component, const std::string& what);
};

// "12.345678 ms": the time with the unit that suits it, digits exact.
std::string to_string(Time time);
std::string to_string(Duration duration);

}  // namespace rasterloom
