// SPDX-License-Identifier: MIT
// A topology as tables and as a drawing, for `rasterloom describe --csv` and `--svg`.
#pragma once

#include "topologies/screen_map.hpp"
#include "topologies/topology.hpp"

#include <ostream>

namespace rasterloom::topology {

// node,name,phi_degrees,theta_degrees,x,y,z,ports: one row a node.
void write_nodes_csv(std::ostream& out, const Topology& topology);

// link,node_a,port_a,node_b,port_b: one row a link, node_a < node_b.
void write_links_csv(std::ostream& out, const Topology& topology);

// Nodes and links. A geodesic: the two hemispheres, the left one as the viewer sees it (phi 180 in
// its middle), the right one from behind; nodes of degree 5 stand out. Grids: in the (phi, theta)
// plane. Other graphs: in a circle, in node order. Every node bears its name as a tooltip.
void write_svg(std::ostream& out, const Topology& topology);

// Which node owns which part of the screen (Strothotte 1981, figure 12).
void write_screen_map_svg(std::ostream& out, const Topology& topology, const ScreenMap& map);

}  // namespace rasterloom::topology
