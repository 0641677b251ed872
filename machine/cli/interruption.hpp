// SPDX-License-Identifier: MIT
// What becomes of a run that the user stops: Ctrl-C, a closed terminal, a polite kill.
#pragma once

#include <atomic>
#include <csignal>
#include <functional>
#include <thread>

namespace rasterloom::cli {

// While it lives, SIGINT, SIGTERM and SIGHUP end the process only after `clean_up`, and then by the
// signal itself, so that a shell sees what happened (status 130, 143, 129). A thread waits for
// them: whatever the program is busy with, it ends at once, and `clean_up` may do what a signal
// handler may not. Signals that are ignored from outside (nohup) stay ignored.
class Interruption {
  public:
    // Calls `prepare` at once, which makes what there will be to clean up; a signal that comes
    // meanwhile waits. `clean_up` is called on another thread and must not throw.
    Interruption(const std::function<void()>& prepare, std::function<void()> clean_up);
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;
    ~Interruption();

  private:
    void watch();

    std::function<void()> clean_up_;
    sigset_t awaited_{};
    sigset_t mask_before_{};
    std::atomic<bool> over_{false};
    std::thread watcher_;  // last: it uses all of the above
};

}  // namespace rasterloom::cli
