// SPDX-License-Identifier: MIT
// A file of bounding boxes on the lanes: the same in every frame.
#include "machine/emulation/princeton_boxes.hpp"
#include "machine/emulation/princeton_job.hpp"
#include "machine/emulation/princeton_loader.hpp"
#include "machine/emulation/princeton_scene.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace rasterloom::emulation {

namespace {

class PrincetonBoxJob final : public PrincetonJob {
  public:
    explicit PrincetonBoxJob(const Blueprint& blueprint)
        : PrincetonJob(blueprint), boxes_(princeton_boxes(blueprint)) {}

    void load(Machine& machine) override {
        LockstepArray& array = machine.lockstep()->array();
        try {
            load_princeton_boxes(array, image(), boxes_, columns());
        } catch (const std::invalid_argument& problem) {
            throw description().error("scene.object", {}, problem.what());
        }
        send(*machine.lockstep(), 0, {});
    }

    void frame_ended(Machine& machine, std::int64_t) override {
        load_boxes(machine.lockstep()->array(), image(), boxes_);
    }

    host::Picture reference(std::int64_t) const override {
        return picture_of_boxes(boxes_, static_cast<int>(description().screen.width),
                                static_cast<int>(description().screen.height));
    }

    std::string remarks() const override {
        return fmt::format("Boxes           {} polygons, {} of them visible", boxes_.size(),
                           std::ranges::count_if(boxes_, &host::BoundingBox::is_visible));
    }

  private:
    std::vector<host::BoundingBox> boxes_;
};

}  // namespace

std::unique_ptr<HostJob> make_princeton_box_job(const Blueprint& blueprint) {
    return std::make_unique<PrincetonBoxJob>(blueprint);
}

}  // namespace rasterloom::emulation
