// SPDX-License-Identifier: MIT
// Where the Princeton Engine's viewer and lights stand: integers, as programs/vliw/memory.s gives
// them to the programs. Eye space: x right, y up, z away. The world is that of view.hpp: +z is up
// and the viewer stands on the -x axis, so that without rotation
//     x' = -y,    y' = z,    z' = x + distance.
#pragma once

#include "machine/host/triangle_scene.hpp"

#include <array>
#include <cstdint>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace rasterloom::host {

inline constexpr int kNearestPlace = 4097;    // z' of a visible vertex: kept by the programs
inline constexpr int kFarthestPlace = 32767;  // z' that a word holds

// Screen, in 1/16 pixel: sx = 16 (width / 2) + focal x'/z', sy = 16 (height / 2) - focal y'/z'.
struct TriangleView {
    int width = 768;  // pixels
    int height = 512;
    // x' = (m0 x + m1 y + m2 z) / 2^14 + m9, likewise y' (m3 ... m5, m10) and z' (m6 ... m8, m11).
    std::array<std::int16_t, 12> matrix{};
    int focal = 11200;  // 1/16 pixel
    int near = kNearestPlace;
};

// The rotation (of world axes; projection.hpp makes one), then the object's middle at `place` (eye
// space, rounded). Throws std::invalid_argument when a part of an object of kTriangleReach could
// then be nearer than kNearestPlace, or so far out that its eye coordinates are no words.
std::array<std::int16_t, 12> eye_matrix(const glm::dmat3& rotation, const glm::dvec3& place);

// The least distance, from 16 384 on, at which the object stays on the screen while it turns about
// the axis (world), `margin` pixels from its sides; the greatest that a word's z' allows if less is
// not enough.
int fitting_distance(const TriangleScene& scene, const glm::dvec3& axis,
                     const TriangleView& screen = {}, int margin = 8);

// White lights, all in eye space: they stand still while the object turns.
struct TriangleLights {
    int ambient = 40;                    // 0 ... 255
    std::array<std::int16_t, 3> sun{};   // unit vector towards the directional light, s1.14
    int sun_diffuse = 150;               // 0 ... 255
    int sun_specular = 70;               // 0 ... 255
    std::array<std::int16_t, 3> lamp{};  // the point light's place
    int lamp_diffuse = 60;               // 0 ... 255
    int lamp_specular = 60;              // 0 ... 255
    int shininess = 4;                   // the specular cosine is squared so often: 0 ... 6
};

// `towards_sun`: world direction of any length but zero; the lamp hangs at the viewer's right.
TriangleLights make_lights(const glm::dvec3& towards_sun = {-0.7, 0.3, 0.65});

}  // namespace rasterloom::host
