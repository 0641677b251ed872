// SPDX-License-Identifier: MIT
#include "machine/emulation/machine.hpp"

#include "isa/syntax.hpp"
#include "machine/emulation/array_settings.hpp"
#include "machine/emulation/bucket_settings.hpp"
#include "machine/emulation/fabric_settings.hpp"
#include "machine/emulation/programs.hpp"
#include "machine/node/registers.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

namespace rasterloom::emulation {

using config::MachineDescription;
using topology::NodeIndex;
using topology::Topology;

namespace {

// Bytes of a half-digested polygon, the longest message on machines that deal out the screen: 5
// words and, for each of at most kMaxCutVertices + 2 vertices on its two sides, 10 words.
constexpr int kMaxDigest = 10 + (kMaxCutVertices + 2) * 20;

void check_ports(const MachineDescription& description, const Topology& topology) {
    for (std::size_t node = 0; node < topology.nodes.size(); ++node) {
        if (topology.ports[node].size() > static_cast<std::size_t>(kMaxPorts)) {
            throw description.error(
                "topology", {},
                fmt::format("node {} has {} neighbours", topology.nodes[node].name,
                            topology.ports[node].size()),
                fmt::format("at most {}, a node's ports", kMaxPorts));
        }
    }
}

void check_memory(const MachineDescription& description, const isa::Isa& isa) {
    if (description.nodes.memory > static_cast<std::int64_t>(isa.private_bytes())) {
        throw description.error(
            "nodes.memory", std::to_string(description.nodes.memory), "too large",
            fmt::format("at most {} bytes, what {} addresses below its I/O page",
                        isa.private_bytes(), isa.name()));
    }
}

std::int64_t count_phases(const MachineDescription& description, const isa::Image& image) {
    if (description.nodes.phases_per_frame) {
        return *description.nodes.phases_per_frame;
    }
    return std::max<std::int64_t>(1, image.symbol("phases_per_frame").value_or(1));
}

Processor::Settings processor_settings(const Blueprint& blueprint) {
    const MachineDescription& description = blueprint.description;
    const isa::Isa& isa = blueprint.isa;
    Processor::Settings settings;
    settings.clock = description.nodes.clock.clock();
    settings.ports.output_queue = static_cast<int>(description.links.output_queue);
    settings.ports.input_queue = static_cast<int>(description.links.input_queue);
    settings.ports.send = description.links.send;
    settings.max_message = static_cast<int>(description.links.max_message);
    settings.supervised = description.scene.has_value() || blueprint.topology.nodes.size() > 1;
    settings.image = blueprint.image;
    settings.register_names.assign(isa.register_names().begin(), isa.register_names().end());
    settings.radix = isa.syntax().default_radix() == 16 ? 16 : 8;
    return settings;
}

}  // namespace

Machine::Machine(const Blueprint& blueprint, HostFrames frames) {
    const MachineDescription& description = blueprint.description;
    if (blueprint.is_lockstep()) {
        build_array(blueprint);
        simulation_.seal();
        return;
    }
    check_ports(description, blueprint.topology);
    check_memory(description, blueprint.isa);
    phases_per_frame_ = count_phases(description, *blueprint.image);
    if (blueprint.distribution) {
        build_fabric(blueprint, std::move(frames.polygons));
    } else if (blueprint.tiles) {
        build_buckets(blueprint, frames.triangles);
    } else {
        build_graph(blueprint);
    }
    simulation_.seal();
    if (buckets_) {
        name_units();
    }
}

Probe<SupervisorListener>* Machine::frame_probe() const {
    if (lockstep_ != nullptr) {
        return &lockstep_->probe();
    }
    return supervisor_ != nullptr ? &supervisor_->probe() : nullptr;
}

void Machine::build_buckets(const Blueprint& blueprint,
                            const std::vector<std::vector<host::ScreenTriangle>>& triangles) {
    const MachineDescription& description = blueprint.description;
    if (phases_per_frame_ != 1) {
        throw description.error("nodes.phases_per_frame", std::to_string(phases_per_frame_),
                                "tiles are drawn in one phase a frame", "1, or a program of one");
    }
    buckets_.emplace();
    try {
        buckets_->sorter = &simulation_.add<TileSorter>("sorter", sorter_settings(blueprint));
        if (description.has_program()) {
            build_feeders(blueprint, triangles);
        } else {
            build_rasterizers(blueprint);
        }
        add_supervisor(description, 1);
        buckets_->sorter->load(sort_frames(triangles, *blueprint.tiles, description.sorter.rule));
    } catch (const std::invalid_argument& problem) {
        throw description.error("rasterizer", {}, problem.what());
    }
    supervisor_->connect(simulation_, static_cast<int>(processors_.size()), *buckets_->sorter,
                         buckets_->sorter->supervisor_port());
}

void Machine::build_rasterizers(const Blueprint& blueprint) {
    for (std::size_t node = 0; node < blueprint.topology.nodes.size(); ++node) {
        RasterizerSettings settings = rasterizer_settings(blueprint.description);
        settings.node = static_cast<NodeIndex>(node);
        buckets_->rasterizers.push_back(
            &simulation_.add<Rasterizer>("node/" + blueprint.topology.nodes[node].name, settings));
        buckets_->sorter->connect(simulation_, static_cast<int>(node),
                                  *buckets_->rasterizers.back());
    }
}

void Machine::build_feeders(const Blueprint& blueprint,
                            const std::vector<std::vector<host::ScreenTriangle>>& triangles) {
    const config::MachineDescription& description = blueprint.description;
    add_processors(blueprint, [&](std::size_t) {
        Processor::Settings settings = processor_settings(blueprint);
        set_tile_ports(settings, blueprint);
        return settings;
    });
    const auto scene = tile_scene(*blueprint.tiles, triangles);
    for (std::size_t node = 0; node < processors_.size(); ++node) {
        TileFeeder& feeder = simulation_.add<TileFeeder>(
            "feeder/" + blueprint.topology.nodes[node].name,
            feeder_settings(description, static_cast<NodeIndex>(processors_.size() + node)));
        feeder.connect(simulation_, *processors_[node], Processor::receive_port(0));
        feeder.load(scene);
        buckets_->sorter->connect(simulation_, static_cast<int>(node), feeder);
        buckets_->feeders.push_back(&feeder);
    }
}

// Units of rasterizers are no components: they have numbers above all of those.
void Machine::name_units() {
    std::size_t next = simulation_.components().size();
    for (Rasterizer* rasterizer : buckets_->rasterizers) {
        rasterizer->name_units(static_cast<ComponentId>(next), static_cast<ComponentId>(next + 1));
        next += 2;
    }
}

std::vector<ComponentId> Machine::node_ids() const {
    std::vector<ComponentId> ids;
    for (const Processor* processor : processors_) {
        ids.push_back(processor->id());
    }
    if (buckets_) {
        for (const Rasterizer* rasterizer : buckets_->rasterizers) {
            ids.push_back(rasterizer->id());
        }
    }
    if (lockstep_ != nullptr) {
        const std::size_t first = simulation_.components().size();
        for (std::int64_t lane = 0; lane < lockstep_->array().lanes(); ++lane) {
            ids.push_back(static_cast<ComponentId>(first + static_cast<std::size_t>(lane)));
        }
    }
    return ids;
}

void Machine::build_array(const Blueprint& blueprint) {
    const LockstepMachine::Settings settings = lockstep_settings(blueprint);
    for (const isa::vliw::Bundle& bundle : settings.program->bundles) {
        if (bundle.seq.op == isa::vliw::SeqOp::phase) {
            phases_per_frame_ = std::max<std::int64_t>(phases_per_frame_, bundle.seq.target + 1);
        }
    }
    lockstep_ = &simulation_.add<LockstepMachine>("sequencer", settings);
}

void Machine::build_graph(const Blueprint& blueprint) {
    const MachineDescription& description = blueprint.description;
    add_processors(blueprint, [&](std::size_t node) {
        Processor::Settings settings = processor_settings(blueprint);
        settings.ports.ports = static_cast<int>(blueprint.topology.ports[node].size());
        return settings;
    });
    try {
        const LinkSettings settings{description.links.time_per_message,
                                    description.links.time_per_byte, description.links.latency,
                                    static_cast<int>(description.links.input_queue)};
        links_ = connect_network(simulation_, blueprint.topology, processors_, settings);
        if (description.scene || processors_.size() > 1) {
            add_supervisor(description, 0);
        }
    } catch (const std::invalid_argument& problem) {
        throw description.error("links", {}, problem.what());
    }
}

void Machine::build_fabric(const Blueprint& blueprint, std::vector<std::vector<Polygon>> polygons) {
    const MachineDescription& description = blueprint.description;
    const PolygonFabricSettings fabric =
        fabric_settings(description, *blueprint.image, phases_per_frame_);
    add_processors(blueprint, [&](std::size_t node) {
        Processor::Settings settings = processor_settings(blueprint);
        settings.supervised = true;
        settings.max_message = kMaxDigest;
        set_polygon_ports(settings, fabric, blueprint.distribution->grids[node]);
        return settings;
    });
    try {
        fabric_ =
            connect_polygon_network(simulation_, *blueprint.distribution, processors_, fabric);
        add_supervisor(description, 1);
        fabric_->source->load(std::move(polygons));
    } catch (const std::invalid_argument& problem) {
        throw description.error("fabric", {}, problem.what());
    }
    supervisor_->connect(simulation_, static_cast<int>(processors_.size()), *fabric_->source,
                         PolygonSource::kSupervisor);
}

void Machine::add_processors(const Blueprint& blueprint,
                             const std::function<Processor::Settings(std::size_t)>& settings_of) {
    const MachineDescription& description = blueprint.description;
    const auto program = prepare_program(blueprint.isa, *blueprint.image, description);
    const isa::CoreOptions options{static_cast<std::uint32_t>(description.nodes.memory),
                                   isa::TrapPolicy::report_unhandled};
    for (std::size_t node = 0; node < blueprint.topology.nodes.size(); ++node) {
        Processor::Settings settings = settings_of(node);
        settings.node = static_cast<NodeIndex>(node);
        try {
            processors_.push_back(
                &simulation_.add<Processor>("node/" + blueprint.topology.nodes[node].name,
                                            blueprint.isa.make_core(program, options), settings));
        } catch (const std::invalid_argument& problem) {
            throw description.error("nodes", {}, problem.what());
        }
    }
}

// `others`: what else takes part in its phases.
void Machine::add_supervisor(const MachineDescription& description, int others) {
    Supervisor::Settings settings;
    settings.latency = description.supervisor.latency;
    settings.phases_per_frame = static_cast<int>(phases_per_frame_);
    settings.frames = static_cast<int>(description.run.frames);
    settings.nodes = static_cast<int>(processors_.size()) + others;
    settings.pause_after_frame = true;
    supervisor_ = &simulation_.add<Supervisor>("supervisor", settings);
    for (std::size_t node = 0; node < processors_.size(); ++node) {
        supervisor_->connect(simulation_, static_cast<int>(node), *processors_[node]);
    }
}

}  // namespace rasterloom::emulation
