// SPDX-License-Identifier: MIT
// A whole machine that runs programs/pdp11/strothotte.s, for tests.
#pragma once

#include "isa/image.hpp"
#include "machine/emulation/strothotte_scene.hpp"
#include "machine/fabric/supervisor.hpp"
#include "machine/host/picture.hpp"
#include "machine/node/node_statistics.hpp"

#include <memory>
#include <string>
#include <vector>

namespace rasterloom::test {

// An object sampled for a geodesic machine.
struct SampledObject {
    topology::Topology topology;
    topology::ScreenMap screen;
    host::FacetModel facets;
};

// `object`: a name of host::scene_objects(); it stands turned by `degrees` about `axis` when it is
// sampled.
SampledObject sample_object(int b, int c, const std::string& object, const host::View& view,
                            double degrees = 0);

struct StrothotteRun {
    std::vector<host::Picture> pictures;  // one a frame
    std::vector<PhaseRecord> phases;
    std::string failure;  // empty for a run that ended as it should
    std::int64_t instructions = 0;
    std::int64_t messages = 0;
    std::vector<NodeStatistics> nodes;
};

struct StrothotteOptions {
    int frames = 1;
    int output_queue = 2;
    int input_queue = 4;
    std::uint32_t memory_bytes = 57344;  // of a node: what the tables leave is its message pool
};

// The assembled program. Throws isa::AssemblyError.
const isa::Image& strothotte_image();

StrothotteRun run_strothotte(const SampledObject& object, const StrothotteScene& scene,
                             const StrothotteOptions& options = {});

// What the reference renderer draws of the same facets, turned by `degrees`.
host::Picture reference_picture(const SampledObject& object, const host::View& view,
                                double degrees);

}  // namespace rasterloom::test
