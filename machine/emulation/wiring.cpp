// SPDX-License-Identifier: MIT
#include "machine/emulation/wiring.hpp"

#include "machine/config/field.hpp"
#include "machine/emulation/scene_kind.hpp"
#include "machine/host/polygon_scenes.hpp"
#include "topologies/registry.hpp"

#include <algorithm>
#include <exception>
#include <functional>

#include <fmt/format.h>

namespace rasterloom::emulation {

namespace {

using config::MachineDescription;

// A key, or the beginning of keys, without a use here, and where it has one.
struct Idle {
    std::string_view beginning;
    std::string_view useful;
};

bool matches(const std::string& path, std::string_view beginning) {
    return beginning.ends_with('.') ? path.starts_with(beginning) : path == beginning;
}

using AddIdle = std::function<void(std::string_view, std::initializer_list<std::string_view>)>;

void add_idle_of_tiler(const MachineDescription& machine, const AddIdle& add) {
    add("another machine: here sorter.* and rasterizer.* say what lies between",
        {"links.", "fabric.", "host.time_per_polygon", "host.time_per_vertex", "scene.routing"});
    if (machine.has_program()) {
        add("rasterizer.kind: hardware",
            {"rasterizer.cycles_per_triangle", "rasterizer.cycles_per_pixel", "rasterizer.fifo"});
    } else {
        add("a machine of processors: rasterizer.kind: software",
            {"nodes.isa", "nodes.plugin", "nodes.cost", "nodes.memory", "nodes.program",
             "nodes.symbols", "nodes.load_address", "nodes.entry", "nodes.phases_per_frame",
             "rasterizer.input_fifo", "sorter.time_per_word"});
    }
    if (machine.sorter.assignment != TileAssignment::largest_first) {
        add("sorter.assignment: largest_first", {"sorter.largest_by"});
    } else if (machine.sorter.largest_by == config::TileMeasure::work && machine.has_program()) {
        throw machine.error("sorter.largest_by", "work", "is not known of a program",
                            "triangles or pixels");
    }
}

std::vector<Idle> idle_keys(const MachineDescription& machine, const topology::Topology& topology) {
    const bool lockstep = is_lockstep(machine);
    std::vector<Idle> idle;
    const AddIdle add = [&idle](std::string_view useful,
                                std::initializer_list<std::string_view> beginnings) {
        for (const std::string_view beginning : beginnings) {
            idle.push_back({beginning, useful});
        }
    };
    if (!machine.is_bucket_tiler()) {
        add("a bucket tiler: topology.kind: bucket_tiles", {"sorter.", "rasterizer."});
    }
    if (lockstep) {  // neither links nor a fabric
        add("a machine of processors: here the nodes are lanes of one array",
            {"links.", "fabric.", "host.", "supervisor.", "nodes.cost", "nodes.memory",
             "nodes.load_address", "nodes.entry", "nodes.phases_per_frame", "scene.routing"});
        if (!machine.array.line_locked) {
            add("array.line_locked: true", {"array.line", "array.lines", "array.visible_lines"});
        }
    } else {
        add("a lock-step array: nodes.isa: vliw", {"array.", "nodes.pack"});
    }
    if (machine.is_bucket_tiler()) {
        add_idle_of_tiler(machine, add);
    } else if (topology.tiling && !lockstep) {
        add("a machine that is a graph: here fabric.* says what lies between",
            {"links.", "scene.routing"});
        if (!machine.fabric.half_digested) {
            add("fabric.half_digested: true", {"fabric.digest_fifo"});
        }
    } else if (!lockstep) {
        add("a machine that deals out the screen: here links.* says what lies between",
            {"fabric.", "host."});
    }
    if (!machine.scene) {
        return idle;
    }
    const SceneKind kind = scene_kind(machine);
    const bool buckets = machine.topology.kind == "bucket_tiles";
    if (lockstep) {
        add("another machine: here the object fills the screen",
            {"scene.size", "scene.scale", "scene.translate", "scene.vanishing_distance",
             "scene.ambient", "scene.background"});
    } else {
        add("a lock-step array", {"screen.map"});
        if (!buckets) {
            add("a lock-step array or bucket tiles", {"scene.texture"});
        }
    }
    if (kind != SceneKind::object) {
        add("an object or mesh as the scene",
            {"scene.size", "scene.normals", "scene.rotate.", "scene.routing", "scene.scale",
             "scene.translate", "scene.vanishing_distance", "scene.light", "scene.ambient"});
    }
    if (!buckets || kind != SceneKind::object) {
        add("an object or mesh on bucket tiles", {"scene.camera."});
    } else if (machine.scene->camera.eye) {
        add("a scene without scene.camera.eye",
            {"scene.scale", "scene.translate", "scene.vanishing_distance"});
    } else {
        add("a scene with scene.camera.eye", {"scene.camera."});
    }
    if (kind != SceneKind::random_triangles) {
        add("the scene random-triangles", {"scene.triangles."});
    }
    const host::PolygonScene* scene = kind == SceneKind::polygon_scene
                                          ? host::find_polygon_scene(machine.scene->object)
                                          : nullptr;
    if (scene == nullptr || !scene->takes_model) {
        add("a polygon scene with a model of its own", {"scene.model"});
    }
    if (scene == nullptr || !scene->is_random) {
        if (kind != SceneKind::random_triangles) {
            add("a random scene", {"scene.seed"});
        }
        if (!lockstep || kind == SceneKind::boxes) {
            add("a random scene", {"scene.polygons"});
        }
    }
    if (kind == SceneKind::boxes) {
        add("an object or mesh as the scene", {"scene.texture", "scene.up", "scene.front"});
    }
    if (!machine.scene->mesh && !machine.scene->model) {
        add("a mesh file", {"scene.up", "scene.front"});
    }
    return idle;
}

}  // namespace

bool is_lockstep(const MachineDescription& machine) {
    return machine.nodes.isa == "vliw";
}

topology::Topology make_wiring(const config::MachineDescription& machine) {
    const auto& wanted = machine.topology;
    try {
        return topology::make_topology(wanted.kind, wanted.parameters);
    } catch (const topology::TopologyError& problem) {
        const std::string key =
            "topology." + (problem.parameter().empty() ? "kind" : problem.parameter());
        throw machine.error(machine.written.contains(key) ? key : "topology", {}, problem.what());
    } catch (
        const std::exception& problem) {  // what is wrong inside a graph's file, place included
        throw machine.error("topology.file", {}, problem.what());
    }
}

topology::Distribution make_distribution(const MachineDescription& machine,
                                         const topology::Topology& topology) {
    try {
        return topology::distribute(*topology.tiling, static_cast<int>(machine.screen.width),
                                    static_cast<int>(machine.screen.height));
    } catch (const topology::TilingError& problem) {
        const bool is_x = problem.axis() == topology::CutAxis::x;
        const std::string key = is_x ? "topology.columns" : "topology.rows";
        throw machine.error(machine.written.contains(key) ? key : "topology", {}, problem.what());
    }
}

topology::BucketTiles make_tiles(const MachineDescription& machine,
                                 const topology::Topology& topology) {
    try {
        return {static_cast<int>(machine.screen.width), static_cast<int>(machine.screen.height),
                *topology.tile};
    } catch (const std::invalid_argument& problem) {
        throw machine.error("topology.tile", {}, problem.what());
    }
}

void check_keys_matter(const MachineDescription& machine, const topology::Topology& topology) {
    const std::vector<Idle> idle = idle_keys(machine, topology);
    MachineDescription defaults;
    defaults.scene.emplace();
    for (const config::Field& field : config::machine_fields()) {
        if (!machine.written.contains(field.path)) {
            continue;
        }
        const auto found = std::find_if(idle.begin(), idle.end(), [&](const Idle& key) {
            return matches(field.path, key.beginning);
        });
        if (found == idle.end()) {
            continue;
        }
        if (const std::string value = field.write(machine); value != field.write(defaults)) {
            throw machine.error(field.path, value, "has no effect here",
                                fmt::format("the default, or {}", found->useful));
        }
    }
}

}  // namespace rasterloom::emulation
