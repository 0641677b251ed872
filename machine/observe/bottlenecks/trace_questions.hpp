// SPDX-License-Identifier: MIT
// The questions that the search for bottlenecks asks of a trace, each one or a few statements of
// SQL. They throw DatabaseError when the file is damaged.
#pragma once

#include "machine/observe/bottlenecks/bottlenecks.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace rasterloom::observe {

std::vector<PathQuestions> path_questions(const Database& trace);

std::vector<Use> busiest_components(const Database& trace);
std::vector<Contention> contention(const Database& trace);
std::vector<Balance> balance_by_phase(const Database& trace);
Duration idle_time(const Database& trace);
std::vector<IdleCause> idle_causes(const Database& trace);

// Fills in the queue in front of `component`: messages in its input queues, or for a link those
// that wait for it at its sender.
void describe_queue(const Database& trace, std::int64_t component, Duration run, HotSpot& spot);
std::vector<std::pair<std::string, Duration>> who_waited_for(const Database& trace,
                                                             std::int64_t component);

}  // namespace rasterloom::observe
