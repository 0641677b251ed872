// SPDX-License-Identifier: MIT
#include "machine/emulation/strothotte_loader.hpp"

#include "machine/emulation/node_memory.hpp"
#include "machine/emulation/strothotte_view.hpp"
#include "topologies/angles.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom {

namespace {

constexpr int kMostPixels = 256;         // of a side: columns and rows are bytes
constexpr std::size_t kMostPorts = 7;    // a path holds a port in three bits, and 7 ends it
constexpr std::uint32_t kLinkBytes = 4;  // in front of a block's message
constexpr std::uint32_t kTriangleMessage = 40;
constexpr std::uint32_t kPointsHeader = 8;
constexpr std::uint32_t kPointBytes = 8;
constexpr std::uint32_t kFewestBlocks = 48;  // in which the program can work
constexpr std::uint32_t kGroupBytes = 16;    // in which pixels are cleared
constexpr std::uint32_t kTriangleGreatCircle = 40;
constexpr std::uint32_t kTriangleSmallCircle = 34;

std::uint32_t even(std::uint32_t bytes) {
    return bytes + bytes % 2;
}

std::uint32_t groups(std::uint32_t bytes) {
    return (bytes + kGroupBytes - 1) / kGroupBytes;
}

}  // namespace

int strothotte_phases_per_frame(const isa::Image& image) {
    return static_cast<int>(require_symbol(image, "phases_per_frame"));
}

StrothotteLoader::StrothotteLoader(const isa::Image& image, const StrothotteMachine& machine,
                                   const StrothotteScene& scene)
    : image_(image),
      machine_(machine),
      scene_(scene),
      frame_(topology::virtual_frame({scene.view.axis.x, scene.view.axis.y, scene.view.axis.z})),
      virtual_routes_(topology::make_routing_table(machine.topology, frame_.z)),
      screen_routes_(topology::make_routing_table(machine.topology, {0, 0, 1})),
      walks_(topology::make_walk_table(machine.topology, machine.screen)),
      triangles_(share_triangles(machine.facets)) {
    check_machine();
    std::size_t most_crossings = 1;
    for (const auto& crossings : machine.facets.crossings) {
        most_crossings = std::max(most_crossings, crossings.size());
        for (const host::Crossing& crossing : crossings) {
            reach_ = std::max(reach_, crossing.radius);
        }
    }
    const auto points = kPointsHeader + kPointBytes * static_cast<std::uint32_t>(most_crossings);
    block_size_ = kLinkBytes + even(std::max({kTriangleMessage, points, largest_facet()}));
    make_perspective(scene.view, reach_);  // complains now rather than at the first node
}

void StrothotteLoader::check_machine() const {
    const host::View& view = scene_.view;
    if (view.width > kMostPixels || view.height > kMostPixels || view.width < 1 ||
        view.height < 1) {
        throw std::invalid_argument(
            fmt::format("screen: {} x {} pixels: the program {} draws at most {} x {}", view.width,
                        view.height, image_.name, kMostPixels, kMostPixels));
    }
    if (view.width != machine_.screen.width || view.height != machine_.screen.height) {
        throw std::invalid_argument("the screen map and the view differ in size");
    }
    if (machine_.facets.crossings.size() != machine_.topology.nodes.size()) {
        throw std::invalid_argument(
            "the object has not been sampled for this topology: facets and nodes differ in number");
    }
    for (std::size_t n = 0; n < machine_.topology.ports.size(); ++n) {
        const std::size_t ports = machine_.topology.ports[n].size();
        if (ports < 1 || ports > kMostPorts) {
            throw std::invalid_argument(
                fmt::format("node {} has {} neighbours: the program {} needs 1 to {}",
                            machine_.topology.nodes[n].name, ports, image_.name, kMostPorts));
        }
    }
}

std::uint32_t StrothotteLoader::largest_facet() const {
    std::size_t largest = 0;
    for (std::size_t f = 0; f < triangles_.size(); ++f) {
        const std::size_t bytes =
            facet_bytes(machine_.facets.crossings[f].size(), triangles_[f].size());
        if (bytes > static_cast<std::size_t>(machine_.max_message)) {
            throw std::invalid_argument(
                fmt::format("facet {} with {} crossings and {} triangles makes a message of {} "
                            "bytes: links.max_message is "
                            "{}, expected {} at least",
                            machine_.topology.nodes[f].name, machine_.facets.crossings[f].size(),
                            triangles_[f].size(), bytes, machine_.max_message, bytes));
        }
        largest = std::max(largest, bytes);
    }
    return static_cast<std::uint32_t>(largest);
}

std::vector<isa::Segment> StrothotteLoader::memory_of(topology::NodeIndex node) const {
    NodeMemory memory(image_, "phase_count", "loader_end", "free_memory");
    const auto ports = machine_.topology.ports[node].size();
    memory.set("port_count", static_cast<std::int64_t>(ports));
    memory.set("last_port", static_cast<std::int64_t>(2 * (ports - 1)));
    memory.set("great_circle", scene_.great_circle ? 1 : 0);
    memory.set("triangle_size", scene_.great_circle ? kTriangleGreatCircle : kTriangleSmallCircle);
    const std::uint32_t first = to_angle32(scene_.first_degrees);
    const std::uint32_t later = to_angle32(scene_.degrees_per_frame);
    memory.set("turn_step", first >> 16);
    memory.set("turn_step", first & 0xffff, 2);
    memory.set("turn_next", later >> 16);
    memory.set("turn_next", later & 0xffff, 2);
    set_view(memory, scene_.view, reach_);
    set_axes(memory, scene_.view, frame_, virtual_routes_.nodes[node].phi);
    add_route(memory, "virtual_route", virtual_routes_.nodes[node]);
    add_route(memory, "screen_route", screen_routes_.nodes[node]);
    add_screen(memory, node);
    add_pool(memory, node);
    return memory.segments();
}

// route.s shows the record.
void StrothotteLoader::add_route(NodeMemory& memory, const std::string& name,
                                 const topology::RoutingNode& node) const {
    const auto add_vector = [&](const topology::Vec14& v) {
        memory.append(v.x);
        memory.append(v.y);
        memory.append(v.z);
    };
    const std::uint32_t vectors = memory.here();
    add_vector(node.direction);
    for (const topology::Vec14& neighbour : node.neighbours) {
        add_vector(neighbour);
    }
    memory.set(name, memory.here());
    memory.append(node.phi);
    memory.append(node.centre_theta);
    memory.append(node.half_phi);
    memory.append(node.half_theta);
    memory.append(node.is_polar ? 1 : 0);
    memory.append(vectors);
    for (const topology::SlopeSector& sector : node.sectors) {
        memory.append(sector.limit);
        memory.append(2 * sector.port);
    }
}

// Rows, then depths, then grey levels; both follow the rows from top to bottom.
void StrothotteLoader::add_screen(NodeMemory& memory, topology::NodeIndex n) const {
    const topology::WalkNode& node = walks_.nodes[n];
    std::uint32_t pixels = 0;
    for (const topology::WalkSegment& s : node.segments) {
        pixels += s.length;
    }
    const int top = node.segments.empty() ? 0 : node.segments.front().y;
    const int rows = node.segments.empty() ? 0 : node.segments.back().y - top + 1;
    constexpr std::uint32_t kRowBytes = 16;
    const std::uint32_t table = memory.here();
    std::uint32_t depth = table + static_cast<std::uint32_t>(rows) * kRowBytes;
    std::uint32_t grey = depth + groups(2 * pixels) * kGroupBytes;
    memory.set("row_table", table);
    memory.set("row_count", rows);
    memory.set("top_row", top);
    memory.set("path_up", node.up);
    memory.set("path_down", node.segments.empty() ? node.home : node.segments.back().down);
    memory.set("depth_start", depth);
    memory.set("depth_groups", groups(2 * pixels));
    memory.set("grey_start", grey);
    memory.set("grey_groups", groups(pixels));
    topology::Path down = topology::kEmptyPath;
    std::size_t next = 0;
    for (int y = top; y < top + rows; ++y) {
        const bool owned = node.segments[next].y == y;
        const topology::WalkSegment segment = owned ? node.segments[next] : topology::WalkSegment{};
        memory.append(segment.x);
        memory.append(segment.x + segment.length - 1);
        memory.append(segment.length);
        memory.append(depth);
        memory.append(grey);
        memory.append(owned ? segment.left : down);
        memory.append(owned ? segment.right : down);
        memory.append(0);
        depth += 2U * segment.length;
        grey += segment.length;
        if (owned) {
            down = segment.down;
            ++next;
        }
    }
    memory.skip((groups(2 * pixels) + groups(pixels)) * kGroupBytes);
}

// The node's facet in a block of its own, then the message pool.
void StrothotteLoader::add_pool(NodeMemory& memory, topology::NodeIndex node) const {
    const auto& crossings = machine_.facets.crossings[node];
    memory.set("facet_list", 0);
    if (!crossings.empty()) {
        const std::vector<std::uint8_t> facet = make_facet(
            node, crossings, triangles_[node], machine_.topology.nodes[node].direction, frame_);
        memory.append(0);
        memory.append(static_cast<std::int64_t>(facet.size()));
        memory.set("facet_list", memory.here());
        for (const std::uint8_t byte : facet) {
            memory.append_byte(byte);
        }
        memory.skip(block_size_ - kLinkBytes - static_cast<std::uint32_t>(facet.size()));
    }
    memory.set("block_size", block_size_);
    const std::uint32_t blocks = memory.here() < machine_.memory_bytes
                                     ? (machine_.memory_bytes - memory.here()) / block_size_
                                     : 0;
    memory.set("free_count", blocks);
    memory.set("pool_next", memory.here() + kLinkBytes);
    memory.set("pool_last", memory.here() + kLinkBytes + (blocks - 1) * block_size_);
    if (blocks < kFewestBlocks) {
        throw std::invalid_argument(
            fmt::format("node {}: program, tables and {} message blocks of {} bytes need {} bytes "
                        "of memory; it has {}",
                        machine_.topology.nodes[node].name, kFewestBlocks, block_size_,
                        memory.here() + kFewestBlocks * block_size_, machine_.memory_bytes));
    }
}

}  // namespace rasterloom
