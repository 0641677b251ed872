// SPDX-License-Identifier: MIT
// Of a build without MPI.
#include "machine/emulation/rank_workers.hpp"

namespace rasterloom::emulation {

bool has_mpi() {
    return false;
}

bool run_on_ranks(PointWorkers* own, const std::function<void(PointWorkers& all)>& work) {
    if (own == nullptr) {
        return true;
    }
    work(*own);
    return false;
}

}  // namespace rasterloom::emulation
