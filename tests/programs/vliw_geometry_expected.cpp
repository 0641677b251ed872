// SPDX-License-Identifier: MIT
#include "programs/vliw_geometry_expected.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rasterloom::test {

namespace {

using Vector = std::array<double, 3>;

constexpr double kUnit = 16384;

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector scaled(const std::array<std::int16_t, 3>& words, double unit) {
    return {words[0] / unit, words[1] / unit, words[2] / unit};
}

Vector turned(const VliwView& view, const Vector& v) {
    Vector result;
    for (std::size_t row = 0; row < 3; ++row) {
        const Vector m = scaled(
            {view.matrix[3 * row], view.matrix[3 * row + 1], view.matrix[3 * row + 2]}, kUnit);
        result[row] = dot(m, v);
    }
    return result;
}

double power(double cosine, int shininess) {
    return std::pow(std::clamp(cosine, 0.0, 1.0), std::exp2(shininess));
}

// One light's part of a vertex's intensity; `error`: of its direction and of the normal.
Range reflected(const Vector& normal, const Vector& light, int diffuse, int specular, int shininess,
                double error) {
    const double facing = dot(normal, light);
    const double mirrored = light[2] - 2 * facing * normal[2];
    const Range highlight{specular * power(mirrored - error, shininess),
                          specular * power(mirrored + error, shininess)};
    const double least = std::max(facing - error, 0.0);
    const double most = std::max(facing + error, 0.0);
    return {diffuse * least + (least > 0 ? highlight.least : 0),
            diffuse * most + (most > 0 ? highlight.most : 0)};
}

Range lit(const Vector& place, const Vector& normal, const VliwLights& lights) {
    constexpr double kWordError = 5e-4;  // of cosines, by words of s1.14
    constexpr double kLampPlace = 4;     // units to which the lamp's direction is right
    Range sum{double(lights.ambient), double(lights.ambient)};
    const auto add = [&sum](const Range& light) {
        sum.least += light.least;
        sum.most += light.most;
    };
    if (dot(normal, normal) > 0) {
        add(reflected(normal, scaled(lights.sun, kUnit), lights.sun_diffuse, lights.sun_specular,
                      lights.shininess, kWordError));
        Vector lamp = scaled(lights.lamp, 1);
        for (std::size_t k = 0; k < 3; ++k) {
            lamp[k] -= place[k];
        }
        const double distance = std::sqrt(dot(lamp, lamp));
        for (double& coordinate : lamp) {
            coordinate /= std::max(distance, 1.0);
        }
        add(reflected(normal, lamp, lights.lamp_diffuse, lights.lamp_specular, lights.shininess,
                      kWordError + kLampPlace / std::max(distance, 1.0)));
    }
    return {std::min(sum.least, 255.0), std::min(sum.most, 255.0)};
}

Fate worst(Fate a, Fate b) {
    return a == Fate::hidden || b == Fate::hidden     ? Fate::hidden
           : a == Fate::visible && b == Fate::visible ? Fate::visible
                                                      : Fate::doubtful;
}

// Whether a value is above a limit, if it may be wrong by `error`.
Fate above(double value, double limit, double error) {
    return value > limit + error   ? Fate::visible
           : value < limit - error ? Fate::hidden
                                   : Fate::doubtful;
}

}  // namespace

ExpectedPolygon::ExpectedPolygon(const VliwView& view, const VliwLights& lights,
                                 const VliwPolygon& polygon)
    : view_(view), colour_(polygon.colour) {
    for (std::size_t i = 0; i < 3; ++i) {
        const VliwVertex& given = polygon.vertices[i];
        ExpectedVertex& vertex = vertices_[i];
        vertex.eye = turned(view, scaled(given.place, 1));
        for (std::size_t k = 0; k < 3; ++k) {
            vertex.eye[k] += view.matrix[9 + k];
        }
        const auto& [x, y, z] = vertex.eye;
        vertex.sx = 16 * 384 + view.focal * x / z;
        vertex.sy = 16 * 256 - view.focal * y / z;
        // To the nearest; the eye's coordinates to whole units.
        const double slope = std::max(std::abs(x), std::abs(y)) / z;
        vertex.error = 0.501 + 0.5 * view.focal / z * (1 + slope);
        vertex.depth = std::exp2(28) / z;
        vertex.u = given.u * vertex.depth / 256;
        vertex.v = given.v * vertex.depth / 256;
        vertex.intensity = lit(vertex.eye, turned(view, scaled(given.normal, kUnit)), lights);
    }
}

Fate ExpectedPolygon::vertex_fate(const ExpectedVertex& vertex) const {
    const auto& [x, y, z] = vertex.eye;
    Fate fate = worst(above(z, view_.near, 1), above(32767.5, z, 1));
    for (const double side : {x, y}) {
        fate = worst(fate, above(z, std::abs(side), 10 + z / 1000));
    }
    return fate;
}

// The box contains a sample of the screen if it does so both ways.
Fate ExpectedPolygon::box_fate() const {
    Fate fate = Fate::visible;
    for (const auto& [coordinate, size] :
         {std::pair{&ExpectedVertex::sx, 768}, std::pair{&ExpectedVertex::sy, 512}}) {
        const auto [low, high] = std::ranges::minmax_element(
            vertices_, {}, [c = coordinate](const ExpectedVertex& v) { return v.*c; });
        const double error = std::max(low->error, high->error);
        const auto has_sample = [size = size](double from, double to) {
            return std::max(std::ceil(from / 16), 0.0) <= std::min(std::floor(to / 16), size - 1.0);
        };
        const bool surely = has_sample((*low).*coordinate + error, (*high).*coordinate - error);
        const bool perhaps = has_sample((*low).*coordinate - error, (*high).*coordinate + error);
        fate = worst(fate, surely ? Fate::visible : perhaps ? Fate::doubtful : Fate::hidden);
    }
    return fate;
}

Fate ExpectedPolygon::face_fate() const {
    const auto& [a, b, c] = vertices_;
    const double area = (b.sy - a.sy) * (c.sx - a.sx) - (b.sx - a.sx) * (c.sy - a.sy);
    const double error = std::max({a.error, b.error, c.error});
    const double around = std::abs(b.sx - a.sx) + std::abs(b.sy - a.sy) + std::abs(c.sx - a.sx) +
                          std::abs(c.sy - a.sy) + 8 * error;
    return above(area, 0, 2 * error * around);
}

Fate ExpectedPolygon::fate() const {
    Fate fate = Fate::visible;
    for (const ExpectedVertex& vertex : vertices_) {
        fate = worst(fate, vertex_fate(vertex));
    }
    return fate == Fate::hidden ? fate : worst(fate, worst(box_fate(), face_fate()));
}

std::string ExpectedPolygon::complaint(const VliwDescriptor& words, bool textured) const {
    ScreenTriangle screen;
    for (std::size_t i = 0; i < 3; ++i) {
        screen[i] = {vertices_[i].sx, vertices_[i].sy, vertices_[i].error};
    }
    Descriptor descriptor(words, screen);
    std::string text = "its edges are not those of the triangle";
    for (const ScreenCorners& corners : descriptor.possible_corners()) {
        descriptor.set_corners(corners);
        text = descriptor.box_complaint() + descriptor.sample_complaint() +
               parameter_complaint(descriptor, textured);
        if (text.empty()) {
            break;
        }
    }
    if (words[4] != 0 || !std::equal(colour_.begin(), colour_.end(), words.begin() + 5)) {
        text += "its passes or colour are wrong";
    }
    return text;
}

std::string ExpectedPolygon::parameter_complaint(const Descriptor& descriptor,
                                                 bool textured) const {
    PlaneValues depth, u, v, intensity;
    for (std::size_t i = 0; i < 3; ++i) {
        const ExpectedVertex& vertex = vertices_[i];
        const double depth_error = 0.51 + vertex.depth / vertex.eye[2] / 2;
        depth[i] = {vertex.depth, vertex.depth, depth_error};
        u[i] = {vertex.u, vertex.u, 0.51 + depth_error};
        v[i] = {vertex.v, vertex.v, 0.51 + depth_error};
        intensity[i] = {vertex.intensity.least, vertex.intensity.most, 0.5};
    }
    std::string text =
        descriptor.plane_complaint("depth", 20, depth) + descriptor.intensity_complaint(intensity);
    if (textured) {
        text += descriptor.plane_complaint("u", 30, u) + descriptor.plane_complaint("v", 36, v);
    }
    return text;
}

}  // namespace rasterloom::test
