// SPDX-License-Identifier: MIT
// Keeps the causes of events while the machine runs, one after the other by partition, which costs
// the run least. What it has kept goes to the log from time to time, also while the machine goes
// on.
#pragma once

#include "machine/kernel/cause.hpp"
#include "machine/observe/bottlenecks/cause_log.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace rasterloom::observe {

class CauseKeeper {
  public:
    explicit CauseKeeper(std::size_t partitions);
    ~CauseKeeper();
    CauseKeeper(const CauseKeeper&) = delete;
    CauseKeeper& operator=(const CauseKeeper&) = delete;

    // To be told what this partition sends.
    CauseListener& for_partition(std::size_t partition);

    // Takes over what has been told; while the machine stands still. What was taken before has gone
    // to the log.
    void take();
    // Moves what was taken to the log; on any thread, while the machine runs.
    void move_to(CauseLog& log);

  private:
    class Keeper;

    std::vector<std::unique_ptr<Keeper>> keepers_;  // [partition]
};

}  // namespace rasterloom::observe
