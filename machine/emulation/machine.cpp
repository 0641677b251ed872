// SPDX-License-Identifier: MIT
#include "machine/emulation/machine.hpp"

#include "isa/syntax.hpp"
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

Processor::Settings processor_settings(const MachineDescription& description, const isa::Isa& isa,
                                       const std::shared_ptr<const isa::Image>& image) {
    Processor::Settings settings;
    settings.clock = description.nodes.clock.clock();
    settings.ports.output_queue = static_cast<int>(description.links.output_queue);
    settings.ports.input_queue = static_cast<int>(description.links.input_queue);
    settings.ports.send = description.links.send;
    settings.max_message = static_cast<int>(description.links.max_message);
    settings.image = image;
    settings.register_names.assign(isa.register_names().begin(), isa.register_names().end());
    settings.radix = isa.syntax().default_radix() == 16 ? 16 : 8;
    return settings;
}

}  // namespace

Machine::Machine(const MachineDescription& description, const Topology& topology,
                 const isa::Isa& isa, std::shared_ptr<const isa::Image> image) {
    check_ports(description, topology);
    check_memory(description, isa);
    phases_per_frame_ = count_phases(description, *image);
    add_processors(description, topology, isa, image);
    try {
        add_links(description, topology);
        if (description.scene || topology.nodes.size() > 1) {
            add_supervisor(description);
        }
    } catch (const std::invalid_argument& problem) {
        throw description.error("links", {}, problem.what());
    }
    simulation_.seal();
}

void Machine::add_processors(const MachineDescription& description, const Topology& topology,
                             const isa::Isa& isa, const std::shared_ptr<const isa::Image>& image) {
    const auto program = prepare_program(isa, *image, description);
    const isa::CoreOptions options{static_cast<std::uint32_t>(description.nodes.memory),
                                   isa::TrapPolicy::report_unhandled};
    Processor::Settings settings = processor_settings(description, isa, image);
    settings.supervised = description.scene.has_value() || topology.nodes.size() > 1;
    for (std::size_t node = 0; node < topology.nodes.size(); ++node) {
        settings.node = static_cast<NodeIndex>(node);
        settings.ports.ports = static_cast<int>(topology.ports[node].size());
        processors_.push_back(&simulation_.add<Processor>(
            "node/" + topology.nodes[node].name, isa.make_core(program, options), settings));
    }
}

void Machine::add_links(const MachineDescription& description, const Topology& topology) {
    const LinkSettings settings{description.links.time_per_message, description.links.time_per_byte,
                                description.links.latency,
                                static_cast<int>(description.links.input_queue)};
    links_ = connect_network(simulation_, topology, processors_, settings);
}

void Machine::add_supervisor(const MachineDescription& description) {
    Supervisor::Settings settings;
    settings.latency = description.supervisor.latency;
    settings.phases_per_frame = static_cast<int>(phases_per_frame_);
    settings.frames = static_cast<int>(description.run.frames);
    settings.nodes = static_cast<int>(processors_.size());
    supervisor_ = &simulation_.add<Supervisor>("supervisor", settings);
    for (std::size_t node = 0; node < processors_.size(); ++node) {
        supervisor_->connect(simulation_, static_cast<int>(node), *processors_[node]);
    }
}

}  // namespace rasterloom::emulation
