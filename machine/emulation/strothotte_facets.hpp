// SPDX-License-Identifier: MIT
// Facets as the FACET messages of programs/pdp11/strothotte (layout.s).
#pragma once

#include "machine/host/facet_model.hpp"
#include "topologies/routing.hpp"
#include "topologies/topology.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace rasterloom {

// A triangle as the facet that is responsible for it holds it: that facet's crossing first.
using OwnedTriangle = std::array<host::FacetModel::Corner, 3>;

// result[facet]: the triangles it assembles. Each triangle goes to that of its facets which has the
// fewest so far.
std::vector<std::vector<OwnedTriangle>> share_triangles(const host::FacetModel& model);

// The FACET message, little-endian words. `direction` is the facet's before any rotation.
std::vector<std::uint8_t> make_facet(std::uint32_t facet,
                                     const std::vector<host::Crossing>& crossings,
                                     const std::vector<OwnedTriangle>& triangles,
                                     const topology::Vec3& direction,
                                     const topology::VirtualFrame& frame);

// Its size in bytes.
std::size_t facet_bytes(std::size_t crossings, std::size_t triangles);

}  // namespace rasterloom
