// SPDX-License-Identifier: MIT
#include "machine/emulation/job.hpp"

#include "machine/emulation/scene_kind.hpp"

#include <stdexcept>

namespace rasterloom::emulation {

std::unique_ptr<HostJob> make_job(const Blueprint& blueprint) {
    const config::MachineDescription& description = blueprint.description;
    if (!description.scene) {
        return nullptr;
    }
    try {
        if (blueprint.tiles) {
            return make_bucket_job(blueprint);
        }
        const SceneKind kind = scene_kind(description);
        if (is_screen_triangles(kind)) {
            refuse_screen_triangles(description);
        }
        if (blueprint.is_lockstep()) {
            return make_princeton_job(blueprint);
        }
        if (blueprint.distribution) {
            return make_tile_job(blueprint);
        }
        if (kind != SceneKind::object) {
            throw description.error("scene.object", description.scene->object,
                                    kind == SceneKind::boxes ? "is made of bounding boxes"
                                                             : "is made of screen polygons",
                                    "an object or a mesh, or a topology that deals out the screen");
        }
        if (blueprint.topology.triangles.empty()) {
            throw description.error("topology.kind", description.topology.kind,
                                    "cannot hold a scene's object",
                                    "geodesic or one that deals out the screen, or no scene");
        }
        return make_strothotte_job(blueprint);
    } catch (const config::ConfigError&) {
        throw;
    } catch (const std::invalid_argument& problem) {
        throw description.error("scene", {}, problem.what());
    }
}

}  // namespace rasterloom::emulation
