// SPDX-License-Identifier: MIT
// Of a build without MPI.
#include "machine/emulation/rank_workers.hpp"

namespace rasterloom::emulation {

bool has_mpi() {
    return false;
}

bool is_first_rank() {
    return true;
}

void run_on_ranks(PointWorkers& own, const std::function<void(PointWorkers& all)>& work) {
    work(own);
}

}  // namespace rasterloom::emulation
