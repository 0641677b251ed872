// SPDX-License-Identifier: MIT
// What the program programs/pdp11/strothotte.s is to draw, and the machine it runs on.
#pragma once

#include "machine/host/facet_model.hpp"
#include "machine/host/view.hpp"
#include "topologies/screen_map.hpp"
#include "topologies/topology.hpp"

#include <cstdint>

namespace rasterloom {

struct StrothotteScene {
    host::View view;               // its `degrees` is not used: the object turns as said here
    double first_degrees = 0;      // turn of the first frame, right-handed about view.axis
    double degrees_per_frame = 0;  // turn of each later frame
    bool great_circle = false;     // else small-circle routing
};

// Borrowed: all must outlive their user.
struct StrothotteMachine {
    const topology::Topology& topology;
    const topology::ScreenMap& screen;
    const host::FacetModel& facets;
    int max_message = 256;               // bytes
    std::uint32_t memory_bytes = 57344;  // of a node
};

}  // namespace rasterloom
