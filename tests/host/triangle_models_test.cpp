// SPDX-License-Identifier: MIT
// The reference renderer of the Princeton Engine on meshes from the field, when they are there.
#include "machine/host/mesh_file.hpp"
#include "machine/host/projection.hpp"
#include "machine/host/triangle_renderer.hpp"
#include "tests/host/meshes.hpp"

#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

struct Model {
    const char* file;
    std::size_t triangles;
    std::size_t least_visible;
    std::size_t most_visible;
    std::size_t most_enclosed;  // pixels of background that the model surrounds
};

std::ostream& operator<<(std::ostream& stream, const Model& model) {
    return stream << model.file;
}

// Pixels without a triangle that no chain of such pixels joins to the picture's border.
std::size_t enclosed_background(const TriangleRendering& rendering) {
    const int width = rendering.picture.width;
    const int height = rendering.picture.height;
    std::vector<bool> is_open(rendering.depth.size(), false);
    std::vector<int> to_visit;
    const auto visit = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= width || y >= height)
            return;
        const int index = y * width + x;
        if (rendering.depth[static_cast<std::size_t>(index)] == 0 &&
            !is_open[static_cast<std::size_t>(index)]) {
            is_open[static_cast<std::size_t>(index)] = true;
            to_visit.push_back(index);
        }
    };
    visit(0, 0);  // models stand away from the border
    while (!to_visit.empty()) {
        const int x = to_visit.back() % width;
        const int y = to_visit.back() / width;
        to_visit.pop_back();
        visit(x - 1, y);
        visit(x + 1, y);
        visit(x, y - 1);
        visit(x, y + 1);
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < is_open.size(); ++i)
        count += rendering.depth[i] == 0 && !is_open[i] ? 1U : 0U;
    return count;
}

class TriangleModels : public ::testing::TestWithParam<Model> {};

TEST_P(TriangleModels, AreDrawnWithoutHoles) {
    const auto path = shared_model(GetParam().file);
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << path << " is not there";
    Mesh mesh = load_mesh(path);
    orient(mesh, {});
    const TriangleScene scene = make_triangle_scene(mesh, {});
    EXPECT_EQ(scene.triangles.size(), GetParam().triangles);
    TriangleView view;
    const int distance = fitting_distance(scene, {0, 0, 1}, view);
    view.matrix = eye_matrix(glm::dmat3(1), {0, 0, static_cast<double>(distance)});
    const auto rendering = render_triangles(scene, view, make_lights());
    EXPECT_GE(rendering.visible, GetParam().least_visible);
    EXPECT_LE(rendering.visible, GetParam().most_visible);
    EXPECT_LE(enclosed_background(rendering), GetParam().most_enclosed);
}

// Of Beethoven's polygons about 3700 are visible (Eldridge 1995, figure 7-1). The alligator is a
// flat one, with a narrow gap between its jaws.
INSTANTIATE_TEST_SUITE_P(Shared, TriangleModels,
                         ::testing::Values(Model{"beethoven.ply", 5030, 3600, 3800, 0},
                                           Model{"alligator.obj", 5981, 5900, 5981, 300},
                                           Model{"bunny.obj", 3674, 1300, 1900, 0}));

}  // namespace
}  // namespace rasterloom::host
