// SPDX-License-Identifier: MIT
#include "programs/vliw_geometry_run.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

VliwPolygon sample() {
    VliwPolygon p;
    p.vertices[0] = {{-1000, -1000, 10000}, {0, 0, -16384}, 0, 0};
    p.vertices[1] = {{1000, -1000, 10000}, {0, 0, -16384}, 255, 0};
    p.vertices[2] = {{0, 1000, 12000}, {0, 0, -16384}, 128, 255};
    p.colour = {0x1122, 0x3344, 0x5566};
    return p;
}

TEST(Try, It) {
    VliwLights l{.ambient = 20, .sun = {0, 0, -16384}, .sun_diffuse = 100};
    VliwGeometryRun run({}, l, {{sample(), sample(), sample(), sample(), sample()}});
    for (auto& d : run.descriptors(0)) {
        for (auto w : d)
            fmt::print("{} ", (std::int16_t)w);
        fmt::print("\n");
    }
    for (auto& [n, c] : run.costs())
        fmt::print("{} calls {} bundles {} ops {} longest {}\n", n, c.calls, c.bundles,
                   c.operations, c.longest);
    EXPECT_TRUE(run.kept_its_place(0));
}

}  // namespace
}  // namespace rasterloom::test
