// SPDX-License-Identifier: MIT
// Fills each node's memory for programs/pdp11/strothotte.s: constants, routing records, rows of the
// screen, its facet. This is the thesis' preliminary set-up (5.1.1) and object initialisation
// (5.1.2); everything that happens in a frame is the program's own work.
#pragma once

#include "isa/image.hpp"
#include "machine/emulation/strothotte_facets.hpp"
#include "machine/emulation/strothotte_scene.hpp"
#include "topologies/routing.hpp"
#include "topologies/walk.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace rasterloom {

class NodeMemory;

class StrothotteLoader {
  public:
    // Throws std::invalid_argument, naming the cause, when image, machine and scene do not fit each
    // other: a program without the expected symbols, a topology without positions, a screen above
    // 256 x 256, a view the program's numbers cannot hold, a facet larger than max_message.
    StrothotteLoader(const isa::Image& image, const StrothotteMachine& machine,
                     const StrothotteScene& scene);

    // What to write over the program in node n's memory. Throws std::invalid_argument, naming the
    // node, when it does not fit.
    std::vector<isa::Segment> memory_of(topology::NodeIndex node) const;

  private:
    void check_machine() const;
    std::uint32_t largest_facet() const;
    void add_route(NodeMemory& memory, const std::string& name,
                   const topology::RoutingNode& node) const;
    void add_screen(NodeMemory& memory, topology::NodeIndex node) const;
    void add_pool(NodeMemory& memory, topology::NodeIndex node) const;

    const isa::Image& image_;
    StrothotteMachine machine_;
    StrothotteScene scene_;
    topology::VirtualFrame frame_;
    topology::RoutingTable virtual_routes_;
    topology::RoutingTable screen_routes_;
    topology::WalkTable walks_;
    std::vector<std::vector<OwnedTriangle>> triangles_;
    double reach_ = 0;              // greatest radius of a crossing
    std::uint32_t block_size_ = 0;  // of the message pool
};

// Phases of a frame, as the program says. Throws std::invalid_argument when the image does not.
int strothotte_phases_per_frame(const isa::Image& image);

}  // namespace rasterloom
