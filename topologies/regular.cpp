// SPDX-License-Identifier: MIT
#include "topologies/regular.hpp"

#include "topologies/angles.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::topology {

namespace {

Node node_at(std::string name, double phi, double theta) {
    return {std::move(name), from_spherical(phi, theta), phi, theta};
}

Topology mesh(const char* kind, int width, int height, bool wraps) {
    if (width < 1 || height < 1 || width > kMaxRegularNodes || height > kMaxRegularNodes / width ||
        width * height < 2) {
        throw std::invalid_argument(
            fmt::format("{}: width = {}, height = {}: expected positive sides and 2 to {} nodes",
                        kind, width, height, kMaxRegularNodes));
    }
    constexpr std::array<std::array<int, 2>, 4> kSteps = {{{1, 0}, {0, -1}, {-1, 0}, {0, 1}}};
    Topology t;
    t.kind = kind;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            t.nodes.push_back(node_at(fmt::format("G{}-{}", x, y), 360 * (x + 0.5) / width,
                                      180 * (y + 0.5) / height));
            const auto here = static_cast<NodeIndex>(y * width + x);
            auto& ports = t.ports.emplace_back();
            for (const auto& [dx, dy] : kSteps) {
                const bool inside = x + dx >= 0 && x + dx < width && y + dy >= 0 && y + dy < height;
                const int nx = (x + dx + width) % width;
                const int ny = (y + dy + height) % height;
                const auto there = static_cast<NodeIndex>(ny * width + nx);
                const bool is_new = std::find(ports.begin(), ports.end(), there) == ports.end();
                if ((inside || wraps) && there != here && is_new) {
                    ports.push_back(there);
                }
            }
        }
    }
    return t;
}

}  // namespace

Topology single() {
    Topology t;
    t.kind = "single";
    t.nodes.push_back(node_at("N0", 180, 90));
    t.ports.emplace_back();
    return t;
}

Topology ring(int n) {
    if (n < 2 || n > kMaxRegularNodes) {
        throw std::invalid_argument(
            fmt::format("ring: nodes = {}: expected 2 to {}", n, kMaxRegularNodes));
    }
    Topology t;
    t.kind = "ring";
    for (int k = 0; k < n; ++k) {
        t.nodes.push_back(node_at(fmt::format("R{}", k), 360.0 * k / n, 90));
        auto& ports = t.ports.emplace_back();
        ports.push_back(static_cast<NodeIndex>((k + 1) % n));
        if (n > 2) {
            ports.push_back(static_cast<NodeIndex>((k + n - 1) % n));
        }
    }
    return t;
}

Topology grid(int width, int height) {
    return mesh("grid", width, height, false);
}

Topology torus(int width, int height) {
    return mesh("torus", width, height, true);
}

}  // namespace rasterloom::topology
