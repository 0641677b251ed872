// SPDX-License-Identifier: MIT
// How a machine looks, for drawing it: where its processors stand or which part of the screen is
// theirs, and what feeds them. Which machine it is does not matter here.
#pragma once

#include "topologies/topology.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace rasterloom::observe {

struct MachineDrawing {
    enum class Layout : std::uint8_t {
        sphere,  // positions are on the unit sphere
        plane,   // positions are within -1 to 1, y upwards, z zero
        screen,  // cells are parts of the screen
    };
    // In pixels, y upwards.
    struct Cell {
        double x = 0;
        double y = 0;
        double width = 0;
        double height = 0;
    };
    // Of the fabric, in the order of RunReport::fabric.
    struct Part {
        enum class Place : std::uint8_t {
            before,  // the processors: what they get comes from it
            beside,  // another part, its parent
            behind,  // the processors: what they make goes to it
        };
        Place place = Place::before;
        std::optional<std::size_t> parent;
    };

    Layout layout = Layout::plane;
    std::vector<topology::Vec3> positions;  // [node]; empty on a screen
    // On a sphere: neighbours of each other, counter-clockwise seen from outside. May be empty.
    std::vector<std::array<topology::NodeIndex, 3>> triangles;
    int width = 0;  // of the screen, pixels; 0 without one
    int height = 0;
    std::vector<Cell> cells;                  // [node], on a screen
    std::vector<topology::PixelGrid> grids;   // [node]: its pixels; or empty
    std::vector<topology::NodeIndex> owners;  // [pixel], from the top; or empty
    std::vector<Part> parts;
    std::vector<std::optional<std::size_t>> fed_by;  // [node]: a part; or empty
};

std::string_view name_of(MachineDrawing::Layout layout);      // "sphere", ...
std::string_view name_of(MachineDrawing::Part::Place place);  // "before", ...

}  // namespace rasterloom::observe
