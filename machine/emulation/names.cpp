// SPDX-License-Identifier: MIT
#include "machine/emulation/names.hpp"

#include "machine/emulation/bucket_settings.hpp"

#include <fmt/format.h>

namespace rasterloom::emulation {

namespace {

// Components are named by their path in the machine: "splitter/3" is a splitter.
observe::ComponentLabel label_by_path(const std::string& path) {
    const std::size_t slash = path.find('/');
    return {path.substr(0, slash), slash == std::string::npos ? path : path.substr(slash + 1)};
}

}  // namespace

std::vector<std::string> names_from_symbols(const isa::Image& image, std::string_view prefix,
                                            std::uint32_t count) {
    std::vector<std::string> names(count);
    for (const auto& [symbol, value] : image.symbols) {
        if (symbol.starts_with(prefix) && value < count) {
            names[value] = symbol.substr(prefix.size());
        }
    }
    return names;
}

std::vector<std::string> activity_names(const Blueprint& blueprint) {
    if (!blueprint.description.has_program()) {
        return {"set_up", "pixels"};  // by Rasterizer::kSetUp, kPixels
    }
    return names_from_symbols(*blueprint.image, "mark_", kActivities);
}

std::vector<std::string> phase_names(const Blueprint& blueprint, const Machine& machine) {
    if (!blueprint.description.has_program()) {
        return {"draw"};
    }
    return names_from_symbols(*blueprint.image, "phase_name_",
                              static_cast<std::uint32_t>(machine.phases_per_frame()));
}

observe::MachineNames machine_names(const Blueprint& blueprint, const Machine& machine) {
    const config::MachineDescription& description = blueprint.description;
    observe::MachineNames names;
    names.machine = description.machine.empty() ? "machine" : description.machine;
    for (const auto& component : machine.simulation().components()) {
        names.components.push_back(label_by_path(component->name()));
    }
    names.nodes = machine.node_ids();
    if (machine.lockstep() != nullptr) {
        for (const topology::Node& node : blueprint.topology.nodes) {
            names.components.push_back({"lane", node.name});
        }
        names.parts.push_back(machine.lockstep()->id());
    }
    if (const BucketNetwork* buckets = machine.buckets()) {
        for (const topology::Node& node : blueprint.topology.nodes) {
            if (!buckets->rasterizers.empty()) {
                names.components.push_back({"triangle_unit", node.name});
                names.components.push_back({"pixel_unit", node.name});
            }
        }
        buckets->for_each_part([&](const Component&, ComponentId part, const PartProbe&) {
            names.parts.push_back(part);
        });
    }
    for (const NetworkLink& wire : machine.links()) {
        names.links.push_back({wire.link->id(), wire.from, wire.to});
        names.components[static_cast<std::size_t>(wire.link->id())].name =
            fmt::format("{} > {}", names.label(names.nodes[wire.from]).name,
                        names.label(names.nodes[wire.to]).name);
    }
    if (machine.fabric() != nullptr) {
        machine.fabric()->for_each_part(
            [&](const auto& part) { names.parts.push_back(part.id()); });
    }
    names.activities = activity_names(blueprint);
    names.phases = phase_names(blueprint, machine);
    if (machine.buckets() != nullptr) {
        names.latency = feeder_settings(description, 0).latency;
    } else if (machine.fabric() == nullptr) {
        names.latency = description.links.latency;
    } else {
        names.latency = description.fabric.ideal ? Duration::tick() : description.fabric.latency;
    }
    names.cycle = description.nodes.clock.clock().nominal_period();
    return names;
}

}  // namespace rasterloom::emulation
