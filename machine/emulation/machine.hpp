// SPDX-License-Identifier: MIT
// The whole machine, built from its description: a processor at every node, a link in either
// direction of every edge, and Strothotte's supervisor. A single node without a scene is a bare
// processor and has none.
#pragma once

#include "isa/isa.hpp"
#include "machine/config/description.hpp"
#include "machine/fabric/network.hpp"
#include "machine/fabric/supervisor.hpp"
#include "machine/kernel/simulation.hpp"
#include "machine/node/processor.hpp"
#include "topologies/topology.hpp"

#include <memory>
#include <vector>

namespace rasterloom::emulation {

class Machine {
  public:
    // Builds and seals. All references need to live only as long as the call, but for `isa`, which
    // the cores need. Throws ConfigError when the description asks for what cannot be built.
    Machine(const config::MachineDescription& description, const topology::Topology& topology,
            const isa::Isa& isa, std::shared_ptr<const isa::Image> image);

    Simulation& simulation() { return simulation_; }
    const std::vector<Processor*>& processors() const { return processors_; }  // by node
    const std::vector<NetworkLink>& links() const {
        return links_;
    }                                                       // by node, then port of the sender
    Supervisor* supervisor() const { return supervisor_; }  // null: a bare processor
    std::int64_t phases_per_frame() const { return phases_per_frame_; }

  private:
    void add_processors(const config::MachineDescription& description,
                        const topology::Topology& topology, const isa::Isa& isa,
                        const std::shared_ptr<const isa::Image>& image);
    void add_links(const config::MachineDescription& description,
                   const topology::Topology& topology);
    void add_supervisor(const config::MachineDescription& description);

    Simulation simulation_;
    std::vector<Processor*> processors_;
    std::vector<NetworkLink> links_;
    Supervisor* supervisor_ = nullptr;
    std::int64_t phases_per_frame_ = 1;
};

}  // namespace rasterloom::emulation
