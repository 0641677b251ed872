// SPDX-License-Identifier: MIT
#include "machine/emulation/scene_kind.hpp"

#include "machine/host/polygon_scenes.hpp"

namespace rasterloom::emulation {

SceneKind scene_kind(const config::MachineDescription& machine) {
    const config::SceneDescription& scene = *machine.scene;
    if (scene.mesh) {
        const auto extension = scene.mesh->extension();
        return extension == ".polygons" ? SceneKind::polygon_file
               : extension == ".boxes"  ? SceneKind::boxes
                                        : SceneKind::object;
    }
    return host::find_polygon_scene(scene.object) != nullptr ? SceneKind::polygon_scene
                                                             : SceneKind::object;
}

}  // namespace rasterloom::emulation
