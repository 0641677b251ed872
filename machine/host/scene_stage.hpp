// SPDX-License-Identifier: MIT
// Puts meshes on a stage: places, lights and paints them. Every face has one grey level, as Parks'
// data had (his tiler interpolates shades all the same).
#pragma once

#include "machine/host/mesh.hpp"
#include "machine/host/polygon_setup.hpp"
#include "machine/host/shuttle.hpp"

#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace rasterloom::host {

struct Placement {
    glm::dvec3 position{0, 0, 0};  // of the mesh's origin
    double heading = 0;            // degrees its -x axis is turned about +z, counter-clockwise
    int depth_offset = 0;          // of all its polygons (polygon_setup.hpp)
};

// Where the camera stands and what it looks at, at one moment of a path.
struct Shot {
    glm::dvec3 eye{0, 0, 0};
    glm::dvec3 target{0, 0, 0};
    double field_of_view = 60;  // degrees
};

// The camera at frame `frame` of `frames` spread evenly over the path from the first shot to the
// last, halfway from one shot to the next in between; one frame alone is the first shot.
Camera camera_at(std::span<const Shot> path, std::int64_t frame, std::int64_t frames);

struct Level {
    double height = 0;
    int depth_offset = 0;
};

class Stage {
  public:
    // Polygons of the mesh in its order, lit by the sun; the grey of a face follows from its
    // surface's name (shuttle.hpp), 0.8 of full white for names unknown.
    void add_mesh(const Mesh& mesh, const Placement& placement);
    // A face of one grey level, 0 to 255, corners counter-clockwise as its front is seen.
    void add_flat(std::span<const glm::dvec3> corners, double grey, int depth_offset = 0);
    // Level: corners (x, y) counter-clockwise from above.
    void add_ground(std::initializer_list<glm::dvec2> corners, double grey,
                    const Level& level = {});

    const std::vector<StagePolygon>& polygons() const { return polygons_; }

  private:
    std::vector<StagePolygon> polygons_;
};

// These parts of the scenes' own shuttle, or all of the model in its place: as long, on the ground,
// its middle over the origin; the model must have +z up and its front to -x. Throws
// std::invalid_argument, naming the model, when it has no length.
Mesh scene_shuttle(const Mesh* model, ShuttleParts parts = ShuttleParts::whole);

}  // namespace rasterloom::host
