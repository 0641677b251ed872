// SPDX-License-Identifier: MIT
// The program's fixed-point geometry and shading against double precision.
#include "machine/emulation/strothotte_loader.hpp"
#include "machine/host/projection.hpp"
#include "programs/bare_node.hpp"
#include "programs/strothotte_run.hpp"
#include "topologies/angles.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

constexpr std::uint32_t kPoint = 0150000;

struct Worst {
    double place = 0;  // pixels
    double depth = 0;
    double intensity = 0;  // grey levels
    int wrong_sides = 0;   // that look away on one side only, though not at the limit

    void add(const BareNode& node, const host::ProjectedVertex& exact, double away) {
        const auto value = [&](std::uint32_t offset) {
            return static_cast<std::int16_t>(node.word(kPoint + offset));
        };
        place = std::max(
            {place, std::fabs(value(0) / 64.0 - exact.x), std::fabs(value(2) / 64.0 - exact.y)});
        depth = std::max(depth, std::fabs(value(4) / 8192.0 - exact.depth));
        intensity = std::max(
            intensity, std::fabs((node.word(kPoint + 6) & 077777) / 128.0 - 255 * exact.intensity));
        const bool looks_away = (node.word(kPoint + 6) & 0100000) != 0;
        wrong_sides +=
            std::fabs(away - host::kEdgeOn) > 3e-4 && looks_away != (away > host::kEdgeOn) ? 1 : 0;
    }
};

// All crossings of the cube, each at its own processor but turned by up to `most_degrees` away from
// it.
Worst measure_points(const host::View& view, double most_degrees) {
    const SampledObject object = sample_object(3, 2, "cube", view);
    StrothotteScene scene;
    scene.view = view;
    const StrothotteLoader loader(strothotte_image(),
                                  {object.topology, object.screen, object.facets}, scene);
    std::mt19937 random(7);
    Worst worst;
    for (topology::NodeIndex n = 0; n < object.topology.nodes.size(); ++n) {
        BareNode node(loader.memory_of(n));
        const std::uint32_t facet = node.word("facet_list");
        const int thousandths = static_cast<int>(random() % 2001) - 1000;
        const auto turned = static_cast<topology::Angle16>(
            static_cast<int>(thousandths / 1000.0 * most_degrees * 65536 / 360));
        node.set_word(facet + BareNode::symbol("f_phi"),
                      node.word(facet + BareNode::symbol("f_phi")) + turned);
        BareNode::Registers registers;
        registers[5] = static_cast<std::uint16_t>(facet);
        node.call("facet_axes", registers);
        registers[4] = static_cast<std::uint16_t>(facet + BareNode::symbol("f_body"));
        registers[5] = kPoint;
        node.call("shade", node.call("place", registers));
        host::View exact = view;
        exact.degrees = topology::angle16_degrees(turned);
        const host::Crossing& crossing = object.facets.crossings[n][0];
        const topology::Vec3& d = object.topology.nodes[n].direction;
        const glm::dmat3 rotation = host::rotation_of(exact);
        worst.add(node,
                  host::project_point(crossing.radius * glm::dvec3(d.x, d.y, d.z), crossing.normal,
                                      rotation, exact),
                  (rotation * crossing.normal).x);
    }
    return worst;
}

void expect_accurate(const host::View& view, double most_degrees) {
    const Worst worst = measure_points(view, most_degrees);
    EXPECT_LT(worst.place, 0.04);
    EXPECT_LT(worst.depth, 0.0008);
    EXPECT_LT(worst.intensity, 0.1);
    EXPECT_EQ(worst.wrong_sides, 0);
}

TEST(StrothottePoints, StandWhereTheExactProjectionPutsThem) {
    expect_accurate({}, 0);
}

TEST(StrothottePoints, StayAccurateWhereverTheFacetStandsWithinItsProcessorsRegion) {
    host::View view;
    view.axis = {0.5, 0.3, 0.8};
    expect_accurate(view, 12);
}

TEST(StrothottePoints, StayAccurateAtAPoleOfRotationWhereTheWholeTurnIsOneProcessors) {
    host::View view;
    view.axis = {-0.2, 0.9, 0.1};
    expect_accurate(view, 180);
}

TEST(StrothottePoints, StayAccurateForOtherViews) {
    host::View view;
    view.translate = {0.2, -0.3, 0.4};
    view.scale = 0.5;
    view.vanishing_distance = 1.7;
    view.width = 200;
    view.height = 120;
    view.light = {0.3, -0.8, 0.1};
    view.ambient = 0;
    expect_accurate(view, 30);
    view.vanishing_distance = 1e9;
    expect_accurate(view, 30);
}

TEST(StrothotteView, RefusesWhatItsNumbersCannotHold) {
    const auto sampled = sample_object(1, 1, "sphere", {});
    const auto refused = [&](const host::View& view) {
        StrothotteScene scene;
        scene.view = view;
        EXPECT_THROW(StrothotteLoader(strothotte_image(),
                                      {sampled.topology, sampled.screen, sampled.facets}, scene),
                     std::invalid_argument);
    };
    host::View view;
    view.scale = 3;
    refused(view);
    view = {};
    view.vanishing_distance = 0.5;
    refused(view);
    view = {};
    view.translate.x = 1.7;
    refused(view);
}

}  // namespace
}  // namespace rasterloom::test
