// SPDX-License-Identifier: MIT
// Object initialisation (Strothotte 1981, 5.1.2): from a mesh to what the facets hold.
#pragma once

#include "machine/host/facet_model.hpp"
#include "machine/host/mesh.hpp"
#include "machine/host/sectors.hpp"
#include "machine/host/surface.hpp"
#include "topologies/topology.hpp"

namespace rasterloom::host {

struct FacetOptions {
    NormalStyle normals = NormalStyle::smooth;
    double crease_cosine = 0.766044443118978;  // of 40 degrees: sharper edges stay sharp
    int max_crossings = kMaxCrossings;         // 1 to kMaxCrossings; the outermost are kept
};

struct FacetStatistics {
    std::size_t crossings = 0;       // kept
    std::size_t cut_edges = 0;       // of the mesh, where no winding fits both sides
    std::size_t most_on_a_line = 0;  // before the limit
    LinkStatistics links;
};

// `mesh` in world axes, all vertices inside the unit sphere (fit_to_sphere), the sphere's centre
// anywhere. Facets are the nodes of the geodesic. Throws std::invalid_argument, naming the mesh,
// when a vertex lies outside, when the topology has no triangles, when the surface is flat and
// passes through the centre, when no radial line meets the surface, or for an option out of range.
FacetModel sample_facets(const topology::Topology& geodesic, const Mesh& mesh,
                         const FacetOptions& options = {}, FacetStatistics* statistics = nullptr);

}  // namespace rasterloom::host
