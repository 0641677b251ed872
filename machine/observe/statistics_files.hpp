// SPDX-License-Identifier: MIT
// A run's numbers for programs: statistics.json, nodes.csv, links.csv. Units are part of every
// name: ps picoseconds, u cycles of the nodes' clock, bytes. docs/statistics.md describes the
// columns.
#pragma once

#include "machine/observe/run_report.hpp"

#include <string>

namespace rasterloom::observe {

std::string statistics_json(const RunReport& report);
std::string nodes_csv(const RunReport& report);  // one row a node
std::string links_csv(const RunReport& report);  // one row a direction of an edge

}  // namespace rasterloom::observe
