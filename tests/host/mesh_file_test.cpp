// SPDX-License-Identifier: MIT
#include "machine/host/mesh_file.hpp"

#include "tests/host/meshes.hpp"
#include "tests/temporary_folder.hpp"

#include <fstream>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class MeshFile : public ::testing::Test {
  protected:
    std::filesystem::path write(const std::string& name, const std::string& text) {
        const auto path = folder_.path() / ("rasterloom-" + name);
        std::ofstream(path) << text;
        return path;
    }

  private:
    TemporaryFolder folder_;
};

constexpr const char* kPyramid =
    "v 1 1 0\nv -1 1 0\nv -1 -1 0\nv 1 -1 0\nv 0 0 1\n"
    "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

TEST_F(MeshFile, ReadsWavefrontObjects) {
    const Mesh mesh = load_mesh(write("pyramid.obj", kPyramid));
    EXPECT_EQ(mesh.polygons.size(), 6U);
    EXPECT_NEAR(signed_volume(mesh), 4.0 / 3, 1e-6);
}

TEST_F(MeshFile, KeepsPolygonsWholeWhenAsked) {
    EXPECT_EQ(load_mesh(write("pyramid.obj", kPyramid), Polygons::as_in_file).polygons.size(), 5U);
}

TEST_F(MeshFile, ReadsPolygonFiles) {
    const Mesh mesh = load_mesh(write(
        "tetrahedron.ply",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"));
    EXPECT_EQ(mesh.polygons.size(), 4U);
    EXPECT_NEAR(signed_volume(mesh), 1.0 / 6, 1e-6);
}

TEST_F(MeshFile, SaysThatAFileIsMissing) {
    EXPECT_THAT([] { load_mesh("/nowhere/teapot.obj"); },
                ThrowsMessage<std::runtime_error>(
                    AllOf(HasSubstr("/nowhere/teapot.obj"), HasSubstr("no such file"))));
    EXPECT_THAT([] { load_mesh(::testing::TempDir()); },
                ThrowsMessage<std::runtime_error>(HasSubstr("not a file")));
}

TEST_F(MeshFile, SaysThatAFileIsNoMesh) {
    const auto text = write("letter.obj", "Dear reader,\nthis is not a mesh.\n");
    EXPECT_THAT([&] { load_mesh(text); },
                ThrowsMessage<std::runtime_error>(HasSubstr(text.string())));
    const auto unknown = write("letter.doc", "Dear reader");
    EXPECT_THAT([&] { load_mesh(unknown); },
                ThrowsMessage<std::runtime_error>(
                    AllOf(HasSubstr(unknown.string()), HasSubstr("not a mesh"))));
    const auto empty = write("empty.obj", "");
    EXPECT_THAT([&] { load_mesh(empty); },
                ThrowsMessage<std::runtime_error>(HasSubstr(empty.string())));
}

TEST_F(MeshFile, SaysThatCoordinatesAreNotFinite) {
    const auto path = write("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_THAT([&] { load_mesh(path); },
                ThrowsMessage<std::runtime_error>(HasSubstr(path.string())));
}

TEST_F(MeshFile, SaysThatAnIndexIsOutOfRange) {
    const auto path = write("range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    EXPECT_THAT([&] { load_mesh(path); },
                ThrowsMessage<std::runtime_error>(HasSubstr(path.string())));
}

TEST_F(MeshFile, DropsFacesWithoutArea) {
    const Mesh mesh = load_mesh(write("line.obj", std::string(kPyramid) + "f 1 1 2\n"));
    EXPECT_EQ(mesh.polygons.size(), 6U);
    EXPECT_EQ(mesh.dropped_faces, 1U);
}

TEST_F(MeshFile, TurnsAwayAFileOfDegenerateFacesOnly) {
    const auto path = write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    EXPECT_THAT([&] { load_mesh(path); },
                ThrowsMessage<std::runtime_error>(
                    AllOf(HasSubstr(path.string()), HasSubstr("expected a surface"))));
}

}  // namespace
}  // namespace rasterloom::host
