// SPDX-License-Identifier: MIT
#include "machine/emulation/scene_kind.hpp"

#include "machine/host/polygon_scenes.hpp"

namespace rasterloom::emulation {

void refuse_screen_triangles(const config::MachineDescription& machine) {
    throw machine.error("scene.object", machine.scene->object,
                        "screen triangles are drawn by bucket tiles only",
                        "another scene, or topology.kind: bucket_tiles");
}

SceneKind scene_kind(const config::MachineDescription& machine) {
    const config::SceneDescription& scene = *machine.scene;
    if (scene.mesh) {
        const auto extension = scene.mesh->extension();
        return extension == ".polygons"    ? SceneKind::polygon_file
               : extension == ".boxes"     ? SceneKind::boxes
               : extension == ".triangles" ? SceneKind::triangle_file
                                           : SceneKind::object;
    }
    if (scene.object == kRandomTriangles) {
        return SceneKind::random_triangles;
    }
    return host::find_polygon_scene(scene.object) != nullptr ? SceneKind::polygon_scene
                                                             : SceneKind::object;
}

}  // namespace rasterloom::emulation
