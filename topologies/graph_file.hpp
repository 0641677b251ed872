// SPDX-License-Identifier: MIT
// Graphs from files.
//
// Edge list: plain text, one fact a line, fields separated by blanks, '#' begins a comment.
//     a b            a link between nodes a and b, which gets the next free port of each
//     a              a node (needed only to fix its number or for a node without links)
//     a 30.5 122     a node and its place: phi (0 to 360) and theta (0 to 180) in degrees
// Nodes are numbered in order of appearance; but if their names are exactly 0, 1, ... n - 1, the
// name is the number.
//
// GraphML: nodes and edges of the first <graph>; node data whose key has attr.name "phi" and
// "theta" give the place. Of a directed graph both directions of an edge make one link.
//
// Names are kept. A node without a place has phi = theta = 0 and the zero direction.
#pragma once

#include "topologies/topology.hpp"

#include <istream>
#include <stdexcept>
#include <string>

namespace rasterloom::topology {

// what() is "file:line: what is wrong, what was expected".
class GraphFileError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// Throw GraphFileError for a file that cannot be read, a malformed line, a link from a node to
// itself, a second link between the same two nodes, or no node at all. `name` stands for the file
// in messages.
Topology read_edge_list(std::istream& in, const std::string& name);
Topology read_graphml(std::istream& in, const std::string& name);
Topology edge_list_file(const std::string& path);
Topology graphml_file(const std::string& path);

}  // namespace rasterloom::topology
