// SPDX-License-Identifier: MIT
// What the host computer does for the program on the nodes: it fills their memories before the run,
// may send them polygons while they run, and reads the picture out of them after each frame.
#pragma once

#include "machine/emulation/blueprint.hpp"
#include "machine/emulation/host_frames.hpp"
#include "machine/emulation/machine.hpp"
#include "machine/host/picture.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rasterloom::emulation {

class HostJob {
  public:
    virtual ~HostJob() = default;
    // Before the first event.
    virtual void load(Machine& machine) = 0;
    // That from now on each communication between the nodes is checked when it has ended: a fault
    // makes the run fail. For jobs that can.
    virtual void check_communication(Machine& /*machine*/) {}
    // What the host sends; nothing where the nodes have all they need from the start.
    virtual HostFrames frames() const { return {}; }
    // At the end of frame `frame`, from 0, before anything of the next one happens: what the host
    // tells the machine then.
    virtual void frame_ended(Machine& /*machine*/, std::int64_t /*frame*/) {}
    // Whether the machine itself shows frames, on its video output.
    virtual bool has_video(const Machine& /*machine*/) const { return false; }
    // When a frame can be seen: at its end, when every program has done its work, or once the
    // video has shown it.
    virtual host::Picture collect(const Machine& machine) const = 0;
    // The same moment on the video output, where there is one.
    virtual std::optional<host::Picture> video(const Machine& /*machine*/) const { return {}; }
    // What the reference renderer draws of the same object at frame `frame`, from 0.
    virtual host::Picture reference(std::int64_t frame) const = 0;
    // Grey level, or level of all colours, of a pixel on which nothing is drawn.
    virtual int background() const = 0;
    // What a person should know about how the object was prepared; may be empty.
    virtual std::string remarks() const = 0;
};

// For programs/pdp11/strothotte.s: object initialisation on the host, one facet to each processor.
std::unique_ptr<HostJob> make_strothotte_job(const Blueprint& blueprint);

// For programs/pdp11/tiler.s: polygons to processors that each own a grid of pixels.
std::unique_ptr<HostJob> make_tile_job(const Blueprint& blueprint);

// For bucket tilers: triangles to rasterizers, hardware or programs/pdp11/bucket.s, tile by tile.
std::unique_ptr<HostJob> make_bucket_job(const Blueprint& blueprint);

// For the renderers of programs/vliw: polygons to the lanes of a lock-step array.
std::unique_ptr<HostJob> make_princeton_job(const Blueprint& blueprint);

// The job that the blueprint's scene asks for; none without a scene. The blueprint must outlive the
// job. Throws ConfigError for a scene that cannot be drawn on this machine, a mesh that cannot be
// read, a program that has no room for the object.
std::unique_ptr<HostJob> make_job(const Blueprint& blueprint);

}  // namespace rasterloom::emulation
