// SPDX-License-Identifier: MIT
// A polygon mesh as it comes from a file or a generator, before any machine's own preparation of
// it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace rasterloom::host {

struct Mesh {
    struct Polygon {
        std::vector<std::uint32_t>
            corners;                // indices into positions, three or more, planar and convex
        std::uint32_t surface = 0;  // index into surface_names
    };

    std::string name;
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;              // empty, or one a position (any length but zero)
    std::vector<glm::dvec2> texture_coordinates;  // empty, or one a position; u right, v up
    std::vector<Polygon> polygons;
    std::vector<std::string> surface_names;
    // Set when the mesh stands for an exact sphere of this radius about the origin.
    std::optional<double> sphere_radius;
    std::size_t dropped_faces = 0;  // degenerate faces, points and lines that were left out
};

// A signed coordinate axis.
enum class Axis { plus_x, minus_x, plus_y, minus_y, plus_z, minus_z };

// Which of a model's own axes points up, and which one points at the viewer. The default is the
// habit of most modelling programs and file formats.
struct Orientation {
    Axis up = Axis::plus_y;
    Axis front = Axis::plus_z;
};

// "x", "+x", "-x", ... Throws std::invalid_argument for anything else.
Axis parse_axis(const std::string& text);

// Turns the mesh so that `up` becomes world +z and `front` world -x, where the viewer stands
// (view.hpp). Throws std::invalid_argument when both lie on one axis.
void orient(Mesh& mesh, const Orientation& orientation);

// Turns the mesh about the world's +z axis, right-handed.
void turn(Mesh& mesh, double degrees);

// Leans the mesh towards the viewer, who then sees more of its upper side; right-handed about the
// world's -y axis.
void tilt(Mesh& mesh, double degrees);

// Moves the middle of the bounding box to the origin and scales so that the vertex farthest from it
// has this radius. Throws std::invalid_argument, naming the mesh, when all vertices coincide.
void fit_to_sphere(Mesh& mesh, double radius = 0.98);

// Checks what every later step relies on: at least one polygon, indices in range, finite
// coordinates, normals and texture coordinates for all positions or none. Drops degenerate polygons
// (fewer than three different corners, or no area) and counts them. Throws std::invalid_argument,
// naming the mesh and the first offending vertex or polygon.
void check(Mesh& mesh);

// Triangles of all polygons; polygons with more corners become fans.
std::size_t triangle_count(const Mesh& mesh);

}  // namespace rasterloom::host
