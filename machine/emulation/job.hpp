// SPDX-License-Identifier: MIT
// What the host computer does for the program on the nodes: it fills their memories before the run
// and reads the picture out of them after each frame.
#pragma once

#include "isa/image.hpp"
#include "machine/config/description.hpp"
#include "machine/host/picture.hpp"
#include "machine/node/processor.hpp"
#include "topologies/topology.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rasterloom::emulation {

class HostJob {
  public:
    virtual ~HostJob() = default;
    // Before the first event.
    virtual void load(const std::vector<Processor*>& processors) = 0;
    // At the end of a frame, when every program has done its work.
    virtual host::Picture collect(const std::vector<Processor*>& processors) const = 0;
    // What the reference renderer draws of the same object at frame `frame`, from 0.
    virtual host::Picture reference(std::int64_t frame) const = 0;
    // What a person should know about how the object was prepared; may be empty.
    virtual std::string remarks() const = 0;
};

// The references given to make_job must outlive the job. The job that the description's scene asks
// for; none without a scene. Throws ConfigError for a scene that cannot be drawn on this machine, a
// mesh that cannot be read, a program that has no room for the object.
std::unique_ptr<HostJob> make_job(const config::MachineDescription& description,
                                  const topology::Topology& topology, const isa::Image& image);

}  // namespace rasterloom::emulation
