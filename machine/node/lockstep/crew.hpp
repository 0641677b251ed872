// SPDX-License-Identifier: MIT
// Threads of the host that stand by to do one job together, again and again.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace rasterloom::lockstep {

class Crew {
  public:
    using Job = std::function<void(int member)>;

    // The calling thread is member 0 and the only one where `members` is 1.
    Crew(int members, Job job);
    ~Crew();
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    // Returns when member 0 is done with the job; by then the others must have nothing left to do
    // in it that anybody waits for.
    void work();

  private:
    void stand_by(int member);

    Job job_;
    std::atomic<std::uint32_t> jobs_{0};
    std::atomic<bool> ended_{false};
    std::vector<std::thread> others_;
};

}  // namespace rasterloom::lockstep
