// SPDX-License-Identifier: MIT
// Meshes from the field, when they are there.
#include "machine/host/facets.hpp"
#include "machine/host/mesh_file.hpp"
#include "tests/host/meshes.hpp"
#include "topologies/geodesic.hpp"

#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

struct Model {
    const char* file;
    std::size_t triangles;
    bool is_closed;
};

std::ostream& operator<<(std::ostream& stream, const Model& model) {
    return stream << model.file;
}

class Models : public ::testing::TestWithParam<Model> {};

TEST_P(Models, AreLinkedWithoutCracksWhenTheyAreClosed) {
    const auto path = shared_model(GetParam().file);
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << path << " is not there";
    Mesh mesh = load_mesh(path);
    EXPECT_EQ(triangle_count(mesh) + mesh.dropped_faces, GetParam().triangles);
    orient(mesh, {});
    fit_to_sphere(mesh);
    const auto geodesic = topology::geodesic(8, 8);
    FacetStatistics statistics;
    const auto model = sample_facets(geodesic, mesh, {}, &statistics);
    EXPECT_EQ(statistics.cut_edges, 0U);
    EXPECT_LT(statistics.links.dropped, statistics.crossings / 100);
    EXPECT_GT(signed_volume(geodesic, model), 0);
    if (GetParam().is_closed) {
        EXPECT_EQ(unmatched_edges(model), 0U);
        EXPECT_EQ(statistics.links.guessed + statistics.links.unpaired, 0U);
    } else {
        EXPECT_LT(statistics.links.unpaired, statistics.links.traced / 20);
    }
}

INSTANTIATE_TEST_SUITE_P(Shared, Models,
                         ::testing::Values(Model{"bunny.obj", 3674, true},
                                           Model{"shuttle.obj", 616, true},
                                           Model{"beethoven.ply", 5030, true},
                                           Model{"head.obj", 37629, false},
                                           Model{"teapot-npm.obj", 992, false}));

}  // namespace
}  // namespace rasterloom::host
