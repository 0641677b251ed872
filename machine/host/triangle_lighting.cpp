// SPDX-License-Identifier: MIT
#include "machine/host/triangle_lighting.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

namespace rasterloom::host {
namespace {

double reflected(const glm::dvec3& normal, const glm::dvec3& light, int diffuse, int specular,
                 int shininess) {
    const double facing = glm::dot(normal, light);
    if (!(facing > 0))
        return 0;
    double highlight = std::clamp(light.z - 2 * facing * normal.z, 0.0, 1.0);
    for (int i = 0; i < shininess; ++i)
        highlight *= highlight;
    return diffuse * facing + specular * highlight;
}

glm::dvec3 vector_of(const std::array<std::int16_t, 3>& words) {
    return {words[0], words[1], words[2]};
}

}  // namespace

double vertex_intensity(const glm::dvec3& place, const glm::dvec3& normal,
                        const TriangleLights& lights) {
    double intensity = lights.ambient;
    intensity += reflected(normal, vector_of(lights.sun) / double{kUnitNormal}, lights.sun_diffuse,
                           lights.sun_specular, lights.shininess);
    const glm::dvec3 to_lamp = vector_of(lights.lamp) - place;
    const double distance = glm::length(to_lamp);
    if (distance > 0)
        intensity += reflected(normal, to_lamp / distance, lights.lamp_diffuse,
                               lights.lamp_specular, lights.shininess);
    return std::min(intensity, 255.0);
}

}  // namespace rasterloom::host
