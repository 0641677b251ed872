// SPDX-License-Identifier: MIT
// rasterloom describe: what a machine is like, without running it.
#include "machine/cli/command.hpp"
#include "machine/cli/config_options.hpp"
#include "machine/cli/describe_buckets.hpp"
#include "machine/cli/describe_tiling.hpp"
#include "machine/config/export.hpp"
#include "machine/config/units.hpp"
#include "machine/emulation/idle_keys.hpp"
#include "machine/emulation/wiring.hpp"
#include "machine/observe/output_folder.hpp"
#include "topologies/bucket_tiles_export.hpp"
#include "topologies/export.hpp"
#include "topologies/metrics.hpp"
#include "topologies/screen_map.hpp"
#include "topologies/tiling_export.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <sstream>

#include <fmt/format.h>

namespace rasterloom::cli {

namespace {

using topology::Topology;

struct DescribeOptions {
    ConfigOptions config;
    bool effective = false;
    std::string svg;
    std::string csv;
    std::string node;
};

std::string degrees(const topology::Metrics& metrics) {
    std::string text;
    for (const auto& [degree, nodes] : metrics.degrees) {
        text += fmt::format("{}{} of degree {}", text.empty() ? "" : ", ", nodes, degree);
    }
    return text;
}

std::string topology_line(const config::TopologyDescription& topology) {
    std::string text = topology.kind;
    for (const auto& [name, value] : topology.parameters) {
        text += fmt::format(", {} {}", name, value);
    }
    return text;
}

void print_title(const config::MachineDescription& machine) {
    fmt::print("{}: {}\n", machine.machine.empty() ? "machine" : machine.machine,
               topology_line(machine.topology));
}

void print_graph(const Topology& topology) {
    const topology::Metrics metrics = topology::measure(topology);
    fmt::print("Nodes       {}: {}\n", metrics.nodes, degrees(metrics));
    fmt::print("Edges       {} ({} links, one in either direction)\n", metrics.links,
               2 * metrics.links);
    if (metrics.distances) {
        fmt::print("Distances   diameter {}, radius {}, mean {:.3f} hops\n",
                   metrics.distances->diameter, metrics.distances->radius, metrics.distances->mean);
    } else {
        fmt::print("Distances   none: the graph has {} parts\n", metrics.components);
    }
    fmt::print("Planar      {}\n", metrics.is_planar ? "yes" : "no");
}

void print_processor(const config::MachineDescription& machine) {
    fmt::print("Processor   {}, {} a cycle, {} bytes, {}\n", machine.nodes.isa,
               config::format_clock(machine.nodes.clock), machine.nodes.memory,
               machine.nodes.program.text);
}

void print_link(const config::MachineDescription& machine) {
    fmt::print("Link        {} a message and {} a byte, latency {}, queues of {} in, {} out\n",
               config::format_duration(machine.links.time_per_message),
               config::format_duration(machine.links.time_per_byte),
               config::format_duration(machine.links.latency), machine.links.input_queue,
               machine.links.output_queue);
}

void print_screen(const config::MachineDescription& machine, const Topology& topology) {
    const auto width = static_cast<int>(machine.screen.width);
    const auto height = static_cast<int>(machine.screen.height);
    const topology::ScreenMap map = topology::nearest_pixel_map(topology, width, height);
    std::vector<std::size_t> pixels(topology.nodes.size());
    for (const topology::NodeIndex owner : map.owner) {
        ++pixels[owner];
    }
    const auto [least, most] = std::minmax_element(pixels.begin(), pixels.end());
    fmt::print("Screen      {} x {}: {} to {} pixels a node, mean {:.1f}\n", width, height, *least,
               *most, static_cast<double>(map.owner.size()) / static_cast<double>(pixels.size()));
}

void print_array(const config::MachineDescription& machine) {
    fmt::print("Lanes       in lock-step, {}, {} a cycle, {}\n", machine.nodes.isa,
               config::format_clock(machine.nodes.clock), machine.nodes.program.text);
    if (machine.array.line_locked) {
        fmt::print("Video       {} scanlines of {} cycles, {} of them visible\n",
                   machine.array.lines, machine.array.line, machine.array.visible_lines);
    }
    if (machine.scene) {
        fmt::print("Screen      {} x {}\n", machine.screen.width, machine.screen.height);
    }
}

std::size_t find_node(const Topology& topology, const std::string& name) {
    const auto found = std::find_if(topology.nodes.begin(), topology.nodes.end(),
                                    [&](const topology::Node& node) { return node.name == name; });
    if (found == topology.nodes.end()) {
        std::vector<std::string> names;
        for (const topology::Node& node : topology.nodes) {
            names.push_back(node.name);
        }
        config::refuse({"--node", 0, 0}, {}, name, "no such node", {},
                       config::nearest_name(name, names));
    }
    return static_cast<std::size_t>(found - topology.nodes.begin());
}

void print_node(const Topology& topology, const std::string& name) {
    const std::size_t index = find_node(topology, name);
    fmt::print("{} is node {}: phi {:.3f}, theta {:.3f} degrees\n", name, index,
               topology.nodes[index].phi, topology.nodes[index].theta);
    for (std::size_t port = 0; port < topology.ports[index].size(); ++port) {
        const topology::NodeIndex neighbour = topology.ports[index][port];
        const topology::Node& node = topology.nodes[neighbour];
        fmt::print("  port {} to {}, node {}: phi {:.3f}, theta {:.3f}\n", port, node.name,
                   neighbour, node.phi, node.theta);
    }
}

void write_tables(const Topology& topology, const std::string& folder) {
    std::ostringstream nodes;
    topology::write_nodes_csv(nodes, topology);
    std::ostringstream links;
    topology::write_links_csv(links, topology);
    observe::OutputFolder output(folder);
    observe::write_file_whole(output.file("nodes.csv"), nodes.str());
    observe::write_file_whole(output.file("links.csv"), links.str());
    output.commit();
}

void describe_graph(const DescribeOptions& options, const config::MachineDescription& machine,
                    const Topology& topology) {
    if (!options.svg.empty()) {
        std::ostringstream drawing;
        topology::write_svg(drawing, topology);
        observe::write_file_whole(options.svg, drawing.str());
    }
    if (!options.csv.empty()) {
        write_tables(topology, options.csv);
    }
    if (!options.node.empty()) {
        print_node(topology, options.node);
        return;
    }
    print_title(machine);
    print_graph(topology);
    if (emulation::is_lockstep(machine)) {
        print_array(machine);
        return;
    }
    print_processor(machine);
    print_link(machine);
    if (machine.scene) {
        print_screen(machine, topology);
    }
}

void describe_tiling(const DescribeOptions& options, const config::MachineDescription& machine,
                     const Topology& topology) {
    const topology::Distribution distribution = emulation::make_distribution(machine, topology);
    if (!options.svg.empty()) {
        std::ostringstream drawing;
        topology::write_tiling_svg(drawing, *topology.tiling, distribution);
        observe::write_file_whole(options.svg, drawing.str());
    }
    if (!options.csv.empty()) {
        write_tiling_tables(distribution, options.csv);
    }
    if (!options.node.empty()) {
        print_share(distribution, find_node(topology, options.node), options.node);
        return;
    }
    print_title(machine);
    print_tiling(*topology.tiling, distribution);
    print_processor(machine);
    print_fabric(machine);
}

void describe_buckets(const DescribeOptions& options, const config::MachineDescription& machine,
                      const Topology& topology) {
    const topology::BucketTiles tiles = emulation::make_tiles(machine, topology);
    const std::size_t rasterizers = topology.nodes.size();
    const std::vector<std::size_t> owners = tile_owners(machine, tiles, rasterizers);
    if (!options.svg.empty()) {
        std::ostringstream drawing;
        topology::write_tiles_svg(drawing, tiles, owners);
        observe::write_file_whole(options.svg, drawing.str());
    }
    if (!options.csv.empty()) {
        std::ostringstream table;
        topology::write_tiles_csv(table, tiles, owners);
        observe::OutputFolder output(options.csv);
        observe::write_file_whole(output.file("tiles.csv"), table.str());
        output.commit();
    }
    if (!options.node.empty()) {
        print_tiles_of(tiles, owners, find_node(topology, options.node), options.node);
        return;
    }
    print_title(machine);
    print_buckets(machine, tiles, rasterizers);
}

void describe(const DescribeOptions& options, const Session& session) {
    const config::MachineDescription machine = load(options.config, session);
    if (options.effective) {
        fmt::print("{}", config::export_machine(machine));
        return;
    }
    const Topology topology = emulation::make_wiring(machine);
    emulation::check_keys_matter(machine, topology);
    if (topology.tile) {
        describe_buckets(options, machine, topology);
    } else if (topology.tiling) {
        describe_tiling(options, machine, topology);
    } else {
        describe_graph(options, machine, topology);
    }
}

}  // namespace

void add_describe_command(CLI::App& app, Session& session) {
    auto options = std::make_shared<DescribeOptions>();
    CLI::App* command = app.add_subcommand("describe",
                                           "Describe a machine: its graph (nodes, links, degrees, "
                                           "distances, planar or not) or how it deals out the "
                                           "screen, and its parts");
    add_config_options(*command, options->config);
    command->add_flag("--config", options->effective,
                      "Print the configuration in effect, which loads again");
    command->add_option("--svg", options->svg, "Draw the graph or the shares of the screen")
        ->type_name("FILE");
    command
        ->add_option("--csv", options->csv,
                     "Write nodes.csv and links.csv (or elements.csv; or tiles.csv) to this folder")
        ->type_name("DIR");
    command
        ->add_option("--node", options->node,
                     "Show one node's place and neighbours or pixels instead")
        ->type_name("NAME");
    command->callback([options, &session] { describe(*options, session); });
}

}  // namespace rasterloom::cli
