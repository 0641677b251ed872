// SPDX-License-Identifier: MIT
#include "machine/emulation/drawing.hpp"

#include "topologies/screen_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <string>

namespace rasterloom::emulation {

namespace {

using observe::FabricPart;
using observe::FabricPartReport;
using observe::MachineDrawing;
using topology::Distribution;
using topology::Topology;
using topology::Vec3;
using Place = MachineDrawing::Part::Place;

bool has_place(const topology::Node& node) {
    return node.direction.x != 0 || node.direction.y != 0 || node.direction.z != 0;
}

Vec3 on_circle(double turns) {
    const double angle = 2 * std::numbers::pi * turns;
    return {std::sin(angle), std::cos(angle), 0};
}

// A full grid has square cells; anything else the two to one of longitude and latitude.
double height_over_width(const Topology& topology) {
    std::set<double> columns;
    std::set<double> rows;
    for (const topology::Node& node : topology.nodes) {
        columns.insert(node.phi);
        rows.insert(node.theta);
    }
    return columns.size() * rows.size() == topology.nodes.size()
               ? static_cast<double>(rows.size()) / static_cast<double>(columns.size())
               : 0.5;
}

std::vector<Vec3> plane_positions(const Topology& topology) {
    const auto& nodes = topology.nodes;
    std::vector<Vec3> positions;
    const bool placed = std::any_of(nodes.begin(), nodes.end(), has_place);
    const bool equator = placed && nodes.size() > 1 &&
                         std::all_of(nodes.begin(), nodes.end(),
                                     [](const topology::Node& node) { return node.theta == 90; });
    const double height = height_over_width(topology);
    const double fit = 1 / std::max(1.0, height);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (equator) {
            positions.push_back(on_circle(nodes[i].phi / 360));
        } else if (placed) {
            positions.push_back(
                {(nodes[i].phi / 180 - 1) * fit, (1 - nodes[i].theta / 90) * height * fit, 0});
        } else {
            positions.push_back(
                on_circle(static_cast<double>(i) / static_cast<double>(nodes.size())));
        }
    }
    return positions;
}

void draw_graph(const Topology& topology, MachineDrawing& drawing) {
    if (topology.triangles.empty()) {
        drawing.layout = MachineDrawing::Layout::plane;
        drawing.positions = plane_positions(topology);
        return;
    }
    drawing.layout = MachineDrawing::Layout::sphere;
    drawing.triangles = topology.triangles;
    for (const topology::Node& node : topology.nodes) {
        drawing.positions.push_back(node.direction);
    }
}

// Where processors share a part of the screen pixel by pixel, the part is drawn as one of its
// blocks of pixels enlarged, so that each has a cell.
MachineDrawing::Cell cell_of(const topology::PixelGrid& grid) {
    const int width = grid.columns * grid.x_step;
    const int height = grid.rows * grid.y_step;
    const int left = grid.x_start / width * width;
    const int bottom = grid.y_start / height * height;
    return {static_cast<double>(left + (grid.x_start - left) * grid.columns),
            static_cast<double>(bottom + (grid.y_start - bottom) * grid.rows),
            static_cast<double>(grid.columns), static_cast<double>(grid.rows)};
}

// Which part hands on to which element and to which node.
class Feeding {
  public:
    Feeding(const Distribution& distribution, const std::vector<FabricPartReport>& fabric,
            MachineDrawing& drawing)
        : distribution_(distribution), drawing_(drawing) {
        for (std::size_t part = 0; part < fabric.size(); ++part) {
            part_of_[fabric[part].name] = part;
        }
        drawing_.parts.resize(fabric.size());
        drawing_.fed_by.resize(distribution.grids.size());
    }

    void host_feeds_first() { feed(0, 0); }
    void elements_feed_others() {
        for (const Distribution::Element& element : distribution_.elements) {
            if (const auto* cut = std::get_if<Distribution::Cut>(&element.what)) {
                feed(part_of_.at(element.name), cut->low);
                feed(part_of_.at(element.name), cut->high);
            } else if (const auto* bus = std::get_if<Distribution::Broadcast>(&element.what)) {
                for (const topology::NodeIndex node : bus->processors) {
                    drawing_.fed_by[node] = part_of_.at(element.name);
                }
            }
        }
    }

  private:
    void feed(std::size_t part, std::size_t element) {
        const Distribution::Element& fed = distribution_.elements[element];
        if (const auto* leaf = std::get_if<Distribution::Leaf>(&fed.what)) {
            drawing_.fed_by[leaf->processor] = part;
        } else {
            drawing_.parts[part_of_.at(fed.name)].parent = part;
        }
    }

    const Distribution& distribution_;
    MachineDrawing& drawing_;
    std::map<std::string, std::size_t> part_of_;
};

void draw_screen(const Distribution& distribution, const std::vector<FabricPartReport>& fabric,
                 MachineDrawing& drawing) {
    drawing.layout = MachineDrawing::Layout::screen;
    drawing.width = distribution.width;
    drawing.height = distribution.height;
    drawing.grids = distribution.grids;
    for (const topology::PixelGrid& grid : distribution.grids) {
        drawing.cells.push_back(cell_of(grid));
    }
    Feeding feeding(distribution, fabric, drawing);
    feeding.host_feeds_first();
    feeding.elements_feed_others();
    for (std::size_t part = 0; part < fabric.size(); ++part) {
        if (fabric[part].part == FabricPart::turn_bus) {
            drawing.parts[part] = {Place::beside, part - 1};  // comes after its bus
        } else if (fabric[part].part == FabricPart::frame_buffer_bus) {
            drawing.parts[part].place = Place::behind;
        }
    }
}

// Lane i draws column i.
void draw_columns(MachineDrawing& drawing) {
    for (int pixel = 0; pixel < drawing.width * drawing.height; ++pixel) {
        drawing.owners.push_back(static_cast<topology::NodeIndex>(pixel % drawing.width));
    }
}

// Whose each pixel was last; pixels of tiles that nobody has drawn have an owner beyond all nodes.
std::vector<topology::NodeIndex> drawers_of_pixels(const topology::BucketTiles& tiles,
                                                   const TileSorter& sorter) {
    constexpr auto kNobody = std::numeric_limits<topology::NodeIndex>::max();
    std::vector<topology::NodeIndex> owners;
    for (int y = 0; y < tiles.screen_height(); ++y) {
        for (int x = 0; x < tiles.screen_width(); ++x) {
            const auto drawer = sorter.drawer_of(tiles.tile_at(x, y));
            owners.push_back(drawer ? static_cast<topology::NodeIndex>(*drawer) : kNobody);
        }
    }
    return owners;
}

// The sorter hands on to each node by way of its units, or of its feeder.
void draw_buckets(const Blueprint& blueprint, const BucketNetwork& buckets,
                  MachineDrawing& drawing) {
    const std::size_t on_the_way = buckets.feeders.empty() ? 2 : 1;
    drawing.parts.resize(1);
    for (std::size_t node = 0; node < blueprint.topology.nodes.size(); ++node) {
        std::size_t above = 0;
        for (std::size_t part = 0; part < on_the_way; ++part) {
            drawing.parts.push_back({Place::before, above});
            above = drawing.parts.size() - 1;
        }
        drawing.fed_by.push_back(above);
    }
    drawing.owners = drawers_of_pixels(*blueprint.tiles, *buckets.sorter);
}

}  // namespace

MachineDrawing draw_machine(const Blueprint& blueprint, const Machine& machine,
                            const std::vector<FabricPartReport>& fabric) {
    MachineDrawing drawing;
    if (blueprint.distribution) {
        draw_screen(*blueprint.distribution, fabric, drawing);
        return drawing;
    }
    draw_graph(blueprint.topology, drawing);
    if (blueprint.is_lockstep()) {  // one sequencer leads all lanes
        drawing.parts.resize(1);
        drawing.fed_by.assign(drawing.positions.size(), 0);
    }
    if (blueprint.description.scene) {
        drawing.width = static_cast<int>(blueprint.description.screen.width);
        drawing.height = static_cast<int>(blueprint.description.screen.height);
        if (blueprint.is_lockstep()) {
            draw_columns(drawing);
            return drawing;
        }
        if (machine.buckets() != nullptr) {
            draw_buckets(blueprint, *machine.buckets(), drawing);
            return drawing;
        }
        drawing.owners =
            topology::nearest_pixel_map(blueprint.topology, drawing.width, drawing.height).owner;
    }
    return drawing;
}

}  // namespace rasterloom::emulation
