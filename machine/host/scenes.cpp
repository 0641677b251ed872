// SPDX-License-Identifier: MIT
#include "machine/host/scenes.hpp"

#include "machine/host/primitives.hpp"
#include "machine/host/teapot.hpp"

#include <array>
#include <stdexcept>

namespace rasterloom::host {
namespace {

Mesh fitted_teapot() {
    Mesh mesh = make_teapot();
    fit_to_sphere(mesh);
    return mesh;
}

Mesh leaning(Mesh mesh, double degrees) {
    tilt(mesh, degrees);
    fit_to_sphere(mesh);
    return mesh;
}

constexpr std::array<SceneObject, 6> kObjects{{
    {"teapot", "the Utah teapot from its Bezier patches: concave, thin handle, hollow spout",
     &fitted_teapot},
    {"sphere", "an exact sphere of radius 0.98 (Strothotte 1981)", [] { return make_sphere(); }},
    {"cube", "a cube with one face towards the viewer (Strothotte 1981)",
     [] { return make_cube(); }},
    {"torus", "a ring, leaning towards the viewer: nothing in its middle",
     [] { return leaning(make_torus(0.68, 0.3), 50); }},
    {"bowl", "a thick-walled bowl, leaning towards the viewer: concave, with a rim",
     [] { return leaning(make_bowl(), 40); }},
    {"hollow_ball", "two concentric spheres: every radial line crosses twice",
     [] { return make_hollow_ball(); }},
}};

}  // namespace

std::span<const SceneObject> scene_objects() {
    return kObjects;
}

Mesh make_scene_object(const std::string& name) {
    std::string names;
    for (const auto& object : kObjects) {
        if (name == object.name)
            return object.make();
        names += (names.empty() ? "" : ", ") + std::string(object.name);
    }
    throw std::invalid_argument("no scene object '" + name + "', expected one of " + names);
}

}  // namespace rasterloom::host
