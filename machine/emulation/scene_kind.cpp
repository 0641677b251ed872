// SPDX-License-Identifier: MIT
#include "machine/emulation/scene_kind.hpp"

namespace rasterloom::emulation {

SceneKind scene_kind(const config::MachineDescription& machine) {
    const config::SceneDescription& scene = *machine.scene;
    if (scene.mesh) {
        return scene.mesh->extension() == ".polygons" ? SceneKind::polygon_file : SceneKind::object;
    }
    return SceneKind::object;
}

}  // namespace rasterloom::emulation
