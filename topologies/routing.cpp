// SPDX-License-Identifier: MIT
#include "topologies/routing.hpp"

#include "topologies/angles.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rasterloom::topology {

namespace {

constexpr int kMaxTheta = 32767;

// The difference a - b as a signed word, which wraps as 16-bit subtraction does.
std::int16_t difference(Angle16 a, Angle16 b) {
    return static_cast<std::int16_t>(static_cast<Angle16>(a - b));
}

int magnitude(std::int16_t x) {
    return std::abs(static_cast<int>(x));
}

std::int32_t dot14(const Vec14& a, const Vec14& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

bool is_inside_rectangle(const RoutingNode& node, const RouteTarget& target) {
    return magnitude(difference(target.phi, node.phi)) <= node.half_phi &&
           magnitude(difference(target.theta, node.centre_theta)) <= node.half_theta;
}

}  // namespace

Angle16 slope(std::int16_t x, std::int16_t y) {
    const int a = magnitude(x) >> 1;
    const int b = magnitude(y) >> 1;
    const int q = a + b == 0 ? 0 : (b << 14) / (a + b);
    if (y >= 0) {
        return static_cast<Angle16>(x >= 0 ? q : 32768 - q);
    }
    return static_cast<Angle16>(x >= 0 ? -q : 32768 + q);
}

std::int16_t quarter_wave14(int k) {
    return static_cast<std::int16_t>(std::floor(16384 * sin_degrees(90.0 * k / 256) + 0.5));
}

std::int16_t sine14(Angle16 angle) {
    const int quarter = angle >> 14;
    const int within = angle & 0x3fff;
    const int r = quarter % 2 == 0 ? within : 0x4000 - within;
    const int i = r >> 6;
    const int f = r & 63;
    int value = quarter_wave14(i);
    if (f != 0) {
        value += ((quarter_wave14(i + 1) - value) * f + 32) >> 6;
    }
    return static_cast<std::int16_t>(quarter < 2 ? value : -value);
}

std::int16_t cosine14(Angle16 angle) {
    return sine14(static_cast<Angle16>(angle + 0x4000));
}

RouteTarget make_target(unsigned phi, unsigned theta) {
    RouteTarget target;
    target.phi = static_cast<Angle16>(phi);
    target.theta = static_cast<Angle16>(std::min<unsigned>(theta, kMaxTheta));
    const int s = sine14(target.theta);
    const auto product = [s](int factor) {
        return static_cast<std::int16_t>((s * factor + 8192) >> 14);
    };
    target.direction = {product(cosine14(target.phi)), product(sine14(target.phi)),
                        cosine14(target.theta)};
    return target;
}

std::optional<int> small_circle_port(const RoutingNode& node, const RouteTarget& target,
                                     std::optional<int> from) {
    if (node.sectors.empty() || is_inside_rectangle(node, target)) {
        return std::nullopt;
    }
    const std::int16_t dphi = difference(target.phi, node.phi);
    const std::int16_t dtheta = difference(target.theta, node.centre_theta);
    const Angle16 direction = node.is_polar ? static_cast<Angle16>(dphi) : slope(dphi, dtheta);
    const auto sector =
        std::find_if(node.sectors.begin(), node.sectors.end(),
                     [direction](const SlopeSector& s) { return direction <= s.limit; });
    return from == sector->port ? std::nullopt : std::optional<int>(sector->port);
}

std::optional<int> great_circle_port(const RoutingNode& node, const RouteTarget& target,
                                     std::optional<int> /*from*/) {
    if (is_inside_rectangle(node, target)) {
        return std::nullopt;
    }
    std::optional<int> best;
    std::int32_t greatest = dot14(node.direction, target.direction);
    for (std::size_t k = 0; k < node.neighbours.size(); ++k) {
        const std::int32_t d = dot14(node.neighbours[k], target.direction);
        if (d > greatest) {
            greatest = d;
            best = static_cast<int>(k);
        }
    }
    return best;
}

}  // namespace rasterloom::topology
