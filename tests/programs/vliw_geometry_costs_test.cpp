// SPDX-License-Identifier: MIT
// What the geometry stage costs, beside Eldridge 1995, 7.3 and 8.1: 1000 instructions to keep or
// reject a polygon, 5000 more for a visible one, on a line-locked machine one visible polygon in 7
// scanlines, 11 with texture.
#include "programs/vliw_geometry_run.hpp"
#include "programs/vliw_scenes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

constexpr int kScanline = 850;  // bundles that a procedure may take (7.2)
constexpr int kPolygons = 40;

struct StageCost {
    double bundles = 0;  // a polygon
    double operations = 0;
    std::int64_t longest = 0;  // bundles in a scanline
};

struct Costs {
    StageCost transform;
    StageCost visible;
};

// One lane that sees half of its polygons, shininess 4.
Costs costs(const VliwGeometryOptions& options) {
    VliwScenes scenes(1);
    VliwLights lights = scenes.lights();
    lights.shininess = 4;
    VliwDatabase polygons(kPolygons);
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        auto& [a, b, c] = polygons[i].vertices;
        a.place = {-1000, -1000, 16000};
        b.place = {1000, -1000, 16000};
        c.place = {0, 1000, 16000};
        if (i % 2 == 0) {
            std::swap(a, b);
        }
    }
    const VliwGeometryRun run({}, lights, {polygons}, options);
    const auto stage = [&](const char* name, int count) {
        const VliwGeometryRun::Cost& cost = run.costs().at(name);
        return StageCost{static_cast<double>(cost.bundles) / count,
                         static_cast<double>(cost.operations) / count, cost.longest};
    };
    return {stage("transform", kPolygons), stage("light", kPolygons / 2)};
}

void print(const char* what, const Costs& costs) {
    fmt::print(
        "{:<20} first stage {:4.0f} bundles, {:4.0f} operations; visible {:4.0f} bundles, {:4.0f} "
        "operations a polygon\n",
        what, costs.transform.bundles, costs.transform.operations, costs.visible.bundles,
        costs.visible.operations);
}

TEST(VliwGeometryCosts, AreBelowEldridgesCount) {
    const Costs textured = costs({});
    const Costs shaded = costs({.textured = false});
    print("textured", textured);
    print("shaded", shaded);
    print("textured, unpacked", costs({.packed = false}));
    print("shaded, unpacked", costs({.textured = false, .packed = false}));
    EXPECT_LT(textured.transform.bundles, 1000);
    EXPECT_LT(textured.visible.bundles, 5000);
    EXPECT_LT(shaded.visible.bundles, textured.visible.bundles);
}

TEST(VliwGeometryCosts, EveryProcedureFitsAScanline) {
    for (const bool textured : {false, true}) {
        const Costs found = costs({.textured = textured});
        EXPECT_LE(found.transform.longest, kScanline);
        EXPECT_LE(found.visible.longest, kScanline);
    }
}

TEST(VliwGeometryCosts, PackingDoesNearlyTwoOperationsABundle) {
    const Costs found = costs({});
    EXPECT_GT(found.transform.operations / found.transform.bundles, 1.7);
    EXPECT_GT(found.visible.operations / found.visible.bundles, 1.7);
}

}  // namespace
}  // namespace rasterloom::test
