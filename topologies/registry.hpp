// SPDX-License-Identifier: MIT
// The topologies that a machine's description can name. To add one: write its pair of files, add
// one row to the table in registry.cpp.
#pragma once

#include "topologies/topology.hpp"

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace rasterloom::topology {

using Parameters = std::map<std::string, std::string>;

struct ParameterInfo {
    std::string name;
    std::string summary;
    std::optional<std::string> fallback;  // none: must be given
};

struct TopologyKind {
    std::string name;
    std::string summary;
    std::vector<ParameterInfo> parameters;
    std::function<Topology(const Parameters&)> make;  // gets every parameter of the list
};

// what() says what is wrong, the value, and what was expected; parameter() names the key, empty for
// the kind itself.
class TopologyError : public std::invalid_argument {
  public:
    TopologyError(std::string parameter, const std::string& message)
        : std::invalid_argument(message), parameter_(std::move(parameter)) {}
    const std::string& parameter() const { return parameter_; }

  private:
    std::string parameter_;
};

// In alphabetical order.
std::vector<TopologyKind> topology_kinds();

// Throws TopologyError for an unknown kind or parameter, a missing or malformed parameter or one
// out of range, GraphFileError for what is wrong inside a graph's file. A relative path is taken
// from the working directory.
Topology make_topology(const std::string& kind, const Parameters& parameters);

}  // namespace rasterloom::topology
