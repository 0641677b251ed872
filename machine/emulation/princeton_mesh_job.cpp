// SPDX-License-Identifier: MIT
// An object as integer triangles on the lanes, and its place in every frame.
#include "machine/emulation/princeton_job.hpp"
#include "machine/emulation/princeton_loader.hpp"
#include "machine/emulation/princeton_scene.hpp"
#include "machine/host/triangle_renderer.hpp"

#include <string>

#include <fmt/format.h>

namespace rasterloom::emulation {

namespace {

class PrincetonMeshJob final : public PrincetonJob {
  public:
    explicit PrincetonMeshJob(const Blueprint& blueprint)
        : PrincetonJob(blueprint),
          scene_(make_princeton_scene(description())),
          lights_(host::make_lights(description().scene->light)),
          view_(program_view(image())),
          distance_(host::fitting_distance(scene_, description().scene->rotate.axis, view_)) {}

    void load(Machine& machine) override {
        LockstepMachine& lockstep = *machine.lockstep();
        by_symbols([&] {
            load_princeton(lockstep.array(), image(), scene_, view_at(0), lights_, columns());
        });
        send(lockstep, 1, view_at(1).matrix);
    }

    // Line-locked, a matrix comes while the picture before is drawn; else when that is complete.
    void frame_ended(Machine& machine, std::int64_t frame) override {
        LockstepMachine& lockstep = *machine.lockstep();
        if (lockstep.settings().line_locked) {
            send(lockstep, frame + 2, view_at(frame + 2).matrix);
        } else {
            load_matrix(lockstep.array(), image(), view_at(frame + 1).matrix);
        }
    }

    host::Picture reference(std::int64_t frame) const override {
        return on_screen(host::render_triangles(scene_, view_at(frame), lights_).picture);
    }

    std::string remarks() const override {
        const std::size_t visible = host::render_triangles(scene_, view_at(0), lights_).visible;
        return fmt::format("Object          {} triangles, {} of them visible in the first frame",
                           scene_.triangles.size(), visible);
    }

  private:
    host::TriangleView view_at(std::int64_t frame) const {
        host::TriangleView view = view_;
        view.matrix = make_princeton_view(description(), distance_, frame).matrix;
        return view;
    }

    host::TriangleScene scene_;
    host::TriangleLights lights_;
    host::TriangleView view_;  // without a matrix
    int distance_;
};

}  // namespace

std::unique_ptr<HostJob> make_princeton_mesh_job(const Blueprint& blueprint) {
    return std::make_unique<PrincetonMeshJob>(blueprint);
}

}  // namespace rasterloom::emulation
