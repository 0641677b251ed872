// SPDX-License-Identifier: MIT
#include "programs/vliw_scenes.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace rasterloom::test {

std::array<double, 3> VliwScenes::unit() {
    while (true) {
        const std::array v{real(), real(), real()};
        const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        if (length > 0.1 && length <= 1) {
            return {v[0] / length, v[1] / length, v[2] / length};
        }
    }
}

std::array<std::int16_t, 3> VliwScenes::unit_words() {
    std::array<std::int16_t, 3> words{};
    for (std::size_t k = 0; const double part : unit()) {
        words[k++] = static_cast<std::int16_t>(std::lround(part * 16384));
    }
    return words;
}

// Rodrigues' formula.
VliwView VliwScenes::view(int z) {
    const auto axis = unit();
    const double angle = real() * std::numbers::pi;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    VliwView view;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            double element = axis[row] * axis[column] * (1 - c);
            if (row == column) {
                element += c;
            } else {
                element += ((column + 3 - row) % 3 == 1 ? -s : s) * axis[3 - row - column];
            }
            view.matrix[3 * row + column] = static_cast<std::int16_t>(std::lround(element * 16384));
        }
    }
    view.matrix[9] = word(-z / 4, z / 4);
    view.matrix[10] = word(-z / 5, z / 5);
    view.matrix[11] = static_cast<std::int16_t>(z);
    return view;
}

VliwLights VliwScenes::lights() {
    VliwLights lights;
    lights.ambient = whole(0, 60);
    lights.sun = unit_words();
    lights.sun_diffuse = whole(0, 255);
    lights.sun_specular = whole(0, 255);
    lights.lamp = {word(-9000, 9000), word(-9000, 9000), word(-3000, 3000)};
    lights.lamp_diffuse = whole(0, 255);
    lights.lamp_specular = whole(0, 255);
    lights.shininess = whole(0, 6);
    return lights;
}

VliwPolygon VliwScenes::polygon(int reach, int size) {
    VliwPolygon result;
    const std::array place{whole(-reach, reach), whole(-reach, reach), whole(-reach, reach)};
    for (VliwVertex& vertex : result.vertices) {
        for (std::size_t k = 0; k < 3; ++k) {
            vertex.place[k] = static_cast<std::int16_t>(place[k] + whole(-size, size));
        }
        vertex.normal = unit_words();
        vertex.u = whole(0, 255);
        vertex.v = whole(0, 255);
    }
    for (std::uint16_t& colour : result.colour) {
        colour = static_cast<std::uint16_t>(whole(0, 65535));
    }
    return result;
}

VliwPolygon VliwScenes::garbage() {
    VliwPolygon result = polygon(0, 0);
    for (VliwVertex& vertex : result.vertices) {
        for (std::size_t k = 0; k < 3; ++k) {
            vertex.place[k] = word(-32768, 32767);
            vertex.normal[k] = word(-32768, 32767);
        }
    }
    return result;
}

std::vector<VliwDatabase> VliwScenes::databases(int reach, int size) {
    std::vector<VliwDatabase> lanes(5);
    for (VliwDatabase& lane : lanes) {
        lane.resize(static_cast<std::size_t>(whole(0, 40)));
        for (VliwPolygon& entry : lane) {
            entry = polygon(reach, size);
        }
    }
    return lanes;
}

}  // namespace rasterloom::test
