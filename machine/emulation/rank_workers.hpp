// SPDX-License-Identifier: MIT
// Workers on many hosts: the ranks of an MPI job (RASTERLOOM_MPI). Each rank has workers of its
// own; the first rank hands the points to all of them.
#pragma once

#include "machine/emulation/point_workers.hpp"

#include <functional>

namespace rasterloom::emulation {

bool has_mpi();  // whether this build does

// To be called by every rank of the job. The first one does `work` with the workers of all ranks;
// the others lend theirs, `own`, and return when it has ended, by an exception or not. A rank that
// cannot take part calls it without workers: then nobody works, and of those ranks one gets true
// and is to say why. Without has_mpi() the process is alone.
bool run_on_ranks(PointWorkers* own, const std::function<void(PointWorkers& all)>& work);

}  // namespace rasterloom::emulation
