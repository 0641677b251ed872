// SPDX-License-Identifier: MIT
// A probe: where a component tells what it does to whoever observes. Without a listener a report
// costs one test of a pointer, and its arguments are not even built. Listeners must not act on the
// machine.
#pragma once

#include <vector>

namespace rasterloom {

template <class Listener>
class Probe {
  public:
    // Listeners are told in the order in which they came; they must outlive the run.
    void attach(Listener& listener) { listeners_.push_back(&listener); }
    bool observed() const { return !listeners_.empty(); }

    // Calls `report(listener)` for each listener.
    template <class Report>
    void tell(Report&& report) const {
        for (Listener* listener : listeners_) {
            report(*listener);
        }
    }

  private:
    std::vector<Listener*> listeners_;
};

}  // namespace rasterloom
