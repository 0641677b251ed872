// SPDX-License-Identifier: MIT
// The whole machine, built from its blueprint: a processor at every node, Strothotte's supervisor,
// and either a link in either direction of every edge or, where the screen is dealt out, the host's
// sending end with splitters and buses; of a bucket tiler the tile sorter with its rasterizers, be
// they processors or not. A single node without links or scene is a bare processor
// and has no supervisor. A lock-step machine has none of these, but a sequencer with its array.
#pragma once

#include "machine/emulation/blueprint.hpp"
#include "machine/emulation/host_frames.hpp"
#include "machine/fabric/bucket_network.hpp"
#include "machine/fabric/lockstep_machine.hpp"
#include "machine/fabric/network.hpp"
#include "machine/fabric/polygon_network.hpp"
#include "machine/fabric/supervisor.hpp"
#include "machine/kernel/simulation.hpp"
#include "machine/node/processor.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace rasterloom::emulation {

class Machine {
  public:
    // Builds and seals. The blueprint needs to live only as long as the call, but for its ISA,
    // which the cores need. `frames`: what the host sends; nothing to a graph. Throws ConfigError
    // when the description asks for what cannot be built.
    Machine(const Blueprint& blueprint, HostFrames frames);

    Simulation& simulation() { return simulation_; }
    const Simulation& simulation() const { return simulation_; }
    const std::vector<Processor*>& processors() const { return processors_; }  // by node
    // By node, then port of the sender.
    const std::vector<NetworkLink>& links() const { return links_; }
    // Null but for Parks' machines.
    const PolygonNetwork* fabric() const { return fabric_ ? &*fabric_ : nullptr; }
    // Null but for bucket tilers.
    const BucketNetwork* buckets() const { return buckets_ ? &*buckets_ : nullptr; }
    Supervisor* supervisor() const { return supervisor_; }   // null: a bare processor, an array
    LockstepMachine* lockstep() const { return lockstep_; }  // null: there are processors
    // What tells of phases and frames; null: a bare processor, which has none.
    Probe<SupervisorListener>* frame_probe() const;
    // By node: a processor's component; a lane has a number of its own, above all components'.
    std::vector<ComponentId> node_ids() const;
    std::int64_t phases_per_frame() const { return phases_per_frame_; }

  private:
    void build_graph(const Blueprint& blueprint);
    void build_array(const Blueprint& blueprint);
    void build_fabric(const Blueprint& blueprint, std::vector<std::vector<Polygon>> polygons);
    void build_buckets(const Blueprint& blueprint,
                       const std::vector<std::vector<host::ScreenTriangle>>& triangles);
    void add_processors(const Blueprint& blueprint,
                        const std::function<Processor::Settings(std::size_t)>& settings_of);
    void build_feeders(const Blueprint& blueprint,
                       const std::vector<std::vector<host::ScreenTriangle>>& triangles);
    void build_rasterizers(const Blueprint& blueprint);
    void name_units();
    void add_supervisor(const config::MachineDescription& description, int others);

    Simulation simulation_;
    std::vector<Processor*> processors_;
    std::vector<NetworkLink> links_;
    std::optional<PolygonNetwork> fabric_;
    std::optional<BucketNetwork> buckets_;
    Supervisor* supervisor_ = nullptr;
    LockstepMachine* lockstep_ = nullptr;
    std::int64_t phases_per_frame_ = 1;
};

}  // namespace rasterloom::emulation
