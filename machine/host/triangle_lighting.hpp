// SPDX-License-Identifier: MIT
// How much white light a vertex sends to the viewer (Eldridge 1995, 7.3.4): ambient, and diffuse
// and specular from a directional and a point light,
//     I = ambient + sum over lights, n.l > 0: diffuse (n.l) + specular max(0, r.v)^(2^shininess),
//     r = 2 (n.l) n - l the mirrored light, v = (0, 0, -1) towards a viewer far away.
// n: the normal, turned like the object; l: unit vector towards the light. I ends at 255.
#pragma once

#include "machine/host/triangle_view.hpp"

#include <glm/vec3.hpp>

namespace rasterloom::host {

// Of a vertex at `place` with the unit vector `normal`, both in eye space: 0 ... 255.
double vertex_intensity(const glm::dvec3& place, const glm::dvec3& normal,
                        const TriangleLights& lights);

}  // namespace rasterloom::host
