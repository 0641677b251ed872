// SPDX-License-Identifier: MIT
#include "machine/emulation/idle_keys.hpp"

#include "machine/config/field.hpp"
#include "machine/emulation/scene_kind.hpp"
#include "machine/emulation/wiring.hpp"
#include "machine/host/polygon_scenes.hpp"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace rasterloom::emulation {

namespace {

using config::MachineDescription;

// Keys, or beginnings of keys, without a use, and where they have one.
class IdleKeys {
  public:
    IdleKeys(const MachineDescription& machine, const topology::Topology& topology);

    // Where the key has a use; null when it has one here.
    const std::string_view* useful_at(const std::string& key) const {
        const auto found = std::find_if(idle_.begin(), idle_.end(), [&](const Idle& idle) {
            return idle.beginning.ends_with('.') ? key.starts_with(idle.beginning)
                                                 : key == idle.beginning;
        });
        return found == idle_.end() ? nullptr : &found->useful;
    }

  private:
    struct Idle {
        std::string_view beginning;
        std::string_view useful;
    };

    void add(std::string_view useful, std::initializer_list<std::string_view> beginnings) {
        for (const std::string_view beginning : beginnings) {
            idle_.push_back({beginning, useful});
        }
    }
    void add_of_array();
    void add_of_bucket_tiler();
    void add_of_fabric();
    void add_of_scene(SceneKind kind);
    void add_of_camera(SceneKind kind);
    void add_of_polygon_scene(SceneKind kind);

    const MachineDescription& machine_;
    bool lockstep_;
    bool buckets_;
    std::vector<Idle> idle_;
};

IdleKeys::IdleKeys(const MachineDescription& machine, const topology::Topology& topology)
    : machine_(machine), lockstep_(is_lockstep(machine)), buckets_(machine.is_bucket_tiler()) {
    if (!buckets_) {
        add("a bucket tiler: topology.kind: bucket_tiles", {"sorter.", "rasterizer."});
    }
    if (lockstep_) {
        add_of_array();
    } else {
        add("a lock-step array: nodes.isa: vliw", {"array.", "nodes.pack"});
    }
    if (buckets_) {
        add_of_bucket_tiler();
    } else if (topology.tiling && !lockstep_) {
        add_of_fabric();
    } else if (!lockstep_) {
        add("a machine that deals out the screen: here links.* says what lies between",
            {"fabric.", "host."});
    }
    if (machine.scene) {
        const SceneKind kind = scene_kind(machine);
        add_of_scene(kind);
        add_of_camera(kind);
        add_of_polygon_scene(kind);
    }
}

// Neither links nor a fabric.
void IdleKeys::add_of_array() {
    add("a machine of processors: here the nodes are lanes of one array",
        {"links.", "fabric.", "host.", "supervisor.", "nodes.cost", "nodes.memory",
         "nodes.load_address", "nodes.entry", "nodes.phases_per_frame", "scene.routing"});
    if (!machine_.array.line_locked) {
        add("array.line_locked: true", {"array.line", "array.lines", "array.visible_lines"});
    }
}

void IdleKeys::add_of_bucket_tiler() {
    add("another machine: here sorter.* and rasterizer.* say what lies between",
        {"links.", "fabric.", "host.time_per_polygon", "host.time_per_vertex", "scene.routing"});
    if (machine_.has_program()) {
        add("rasterizer.kind: hardware",
            {"rasterizer.cycles_per_triangle", "rasterizer.cycles_per_pixel", "rasterizer.fifo"});
    } else {
        add("a machine of processors: rasterizer.kind: software",
            {"nodes.isa", "nodes.plugin", "nodes.cost", "nodes.memory", "nodes.program",
             "nodes.symbols", "nodes.load_address", "nodes.entry", "nodes.phases_per_frame",
             "rasterizer.input_fifo", "sorter.time_per_word"});
    }
    if (machine_.sorter.assignment != TileAssignment::largest_first) {
        add("sorter.assignment: largest_first", {"sorter.largest_by"});
    }
}

void IdleKeys::add_of_fabric() {
    add("a machine that is a graph: here fabric.* says what lies between",
        {"links.", "scene.routing"});
    if (!machine_.fabric.half_digested) {
        add("fabric.half_digested: true", {"fabric.digest_fifo"});
    }
}

void IdleKeys::add_of_scene(SceneKind kind) {
    if (lockstep_) {
        add("another machine: here the object fills the screen",
            {"scene.size", "scene.scale", "scene.translate", "scene.vanishing_distance",
             "scene.ambient", "scene.background"});
    } else {
        add("a lock-step array", {"screen.map"});
        if (!buckets_) {
            add("a lock-step array or bucket tiles", {"scene.texture"});
        }
    }
    if (kind != SceneKind::object) {
        add("an object or mesh as the scene",
            {"scene.size", "scene.normals", "scene.rotate.", "scene.routing", "scene.scale",
             "scene.translate", "scene.vanishing_distance", "scene.light", "scene.ambient"});
    }
    if (kind == SceneKind::boxes) {
        add("an object or mesh as the scene", {"scene.texture", "scene.up", "scene.front"});
    }
    if (!machine_.scene->mesh && !machine_.scene->model) {
        add("a mesh file", {"scene.up", "scene.front"});
    }
}

void IdleKeys::add_of_camera(SceneKind kind) {
    if (!buckets_ || kind != SceneKind::object) {
        add("an object or mesh on bucket tiles", {"scene.camera."});
    } else if (machine_.scene->camera.eye) {
        add("a scene without scene.camera.eye",
            {"scene.scale", "scene.translate", "scene.vanishing_distance"});
    } else {
        add("a scene with scene.camera.eye", {"scene.camera."});
    }
}

void IdleKeys::add_of_polygon_scene(SceneKind kind) {
    const host::PolygonScene* scene = kind == SceneKind::polygon_scene
                                          ? host::find_polygon_scene(machine_.scene->object)
                                          : nullptr;
    if (scene == nullptr || !scene->takes_model) {
        add("a polygon scene with a model of its own", {"scene.model"});
    }
    if (kind != SceneKind::random_triangles) {
        add("the scene random-triangles", {"scene.triangles."});
    }
    if (scene == nullptr || !scene->is_random) {
        if (kind != SceneKind::random_triangles) {
            add("a random scene", {"scene.seed"});
        }
        if (!lockstep_ || kind == SceneKind::boxes) {
            add("a random scene", {"scene.polygons"});
        }
    }
}

}  // namespace

void check_keys_matter(const MachineDescription& machine, const topology::Topology& topology) {
    if (machine.sorter.assignment == TileAssignment::largest_first &&
        machine.sorter.largest_by == config::TileMeasure::work && machine.has_program()) {
        throw machine.error("sorter.largest_by", "work", "is not known of a program",
                            "triangles or pixels");
    }
    const IdleKeys idle(machine, topology);
    MachineDescription defaults;
    defaults.scene.emplace();
    for (const config::Field& field : config::machine_fields()) {
        const std::string_view* useful = idle.useful_at(field.path);
        if (useful == nullptr || !machine.written.contains(field.path)) {
            continue;
        }
        if (const std::string value = field.write(machine); value != field.write(defaults)) {
            throw machine.error(field.path, value, "has no effect here",
                                fmt::format("the default, or {}", *useful));
        }
    }
}

}  // namespace rasterloom::emulation
