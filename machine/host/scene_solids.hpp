// SPDX-License-Identifier: MIT
// Puts together solids for scenes out of flat convex polygons.
#pragma once

#include "machine/host/mesh.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace rasterloom::host {

using Ring = std::vector<glm::dvec3>;

class SolidBuilder {
  public:
    explicit SolidBuilder(std::string name) { mesh_.name = std::move(name); }

    // Index of a surface, new or not.
    std::uint32_t surface(const std::string& name);

    // Corners counter-clockwise seen from outside; those that repeat their predecessor are left
    // out, what then has fewer than three is, too. Four corners that are not in a plane become two
    // triangles.
    void add_face(std::span<const glm::dvec3> corners, std::uint32_t surface);
    void add_face(std::initializer_list<glm::dvec3> corners, std::uint32_t surface);
    // The same face seen from the other side only.
    void add_back(std::span<const glm::dvec3> corners, std::uint32_t surface);

    // The skin between successive rings of as many points each, which run counter-clockwise as seen
    // from the last ring: edge i of ring k and edge i of ring k + 1 bound a face.
    void add_loft(std::span<const Ring> rings, std::uint32_t surface);
    using SurfaceOf = std::function<std::uint32_t(std::size_t band, std::size_t edge)>;
    void add_loft(std::span<const Ring> rings, const SurfaceOf& surface_of);
    // With both ends closed.
    void add_solid(std::span<const Ring> rings, std::uint32_t surface);

    // Edges along the axes; least and greatest corner.
    void add_box(const glm::dvec3& least, const glm::dvec3& greatest, std::uint32_t surface);

    // All that has been added since the mesh had `first` polygons once more, mirrored in y = 0.
    void mirror_since(std::size_t first);

    std::size_t polygon_count() const { return mesh_.polygons.size(); }
    Mesh take() { return std::move(mesh_); }

  private:
    void emit(std::span<const glm::dvec3> corners, std::uint32_t surface);

    Mesh mesh_;
};

// `sides` points about the axis that runs through `centre` along +x, counter-clockwise as seen from
// +x.
Ring ring_about_x(const glm::dvec3& centre, double radius, int sides);

}  // namespace rasterloom::host
