// SPDX-License-Identifier: MIT
#include "machine/host/mesh_file.hpp"

#include <stdexcept>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

namespace rasterloom::host {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what) {
    throw std::runtime_error(fmt::format("{}: {}", path.string(), what));
}

glm::dvec3 to_vector(const aiVector3D& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

// What every part of a scene has, or no vertex of the mesh.
struct Extras {
    bool normals = true;
    bool texture_coordinates = true;
};

Extras extras_of(const aiScene& scene) {
    Extras extras;
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        extras.normals = extras.normals && scene.mMeshes[i]->HasNormals();
        extras.texture_coordinates =
            extras.texture_coordinates && scene.mMeshes[i]->HasTextureCoords(0);
    }
    return extras;
}

void append(Mesh& mesh, const aiMesh& part, const Extras& extras) {
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    const auto surface = static_cast<std::uint32_t>(mesh.surface_names.size());
    mesh.surface_names.emplace_back(part.mName.C_Str());
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
        mesh.positions.push_back(to_vector(part.mVertices[i]));
        if (extras.normals)
            mesh.normals.push_back(to_vector(part.mNormals[i]));
        if (extras.texture_coordinates) {
            const auto at = to_vector(part.mTextureCoords[0][i]);
            mesh.texture_coordinates.push_back({at.x, at.y});
        }
    }
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
        const aiFace& face = part.mFaces[i];
        Mesh::Polygon polygon{{}, surface};
        for (unsigned k = 0; k < face.mNumIndices; ++k)
            polygon.corners.push_back(base + face.mIndices[k]);
        mesh.polygons.push_back(std::move(polygon));
    }
}

}  // namespace

Mesh load_mesh(const std::filesystem::path& path, Polygons polygons) {
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        fail(path, "no such file, expected a mesh");
    if (!std::filesystem::is_regular_file(path, error))
        fail(path, "not a file, expected a mesh");

    Assimp::Importer importer;
    unsigned steps = aiProcess_PreTransformVertices;
    if (polygons == Polygons::triangulated)
        steps |= aiProcess_Triangulate;
    const aiScene* scene = importer.ReadFile(path.string(), steps);
    if (scene == nullptr)
        fail(path, fmt::format("not a mesh that can be read: {}", importer.GetErrorString()));

    Mesh mesh;
    mesh.name = path.string();
    const Extras extras = extras_of(*scene);
    for (unsigned i = 0; i < scene->mNumMeshes; ++i)
        append(mesh, *scene->mMeshes[i], extras);
    if (mesh.polygons.empty())
        fail(path, "no polygons, expected a mesh");
    try {
        check(mesh);
    } catch (const std::invalid_argument& problem) {
        throw std::runtime_error(problem.what());  // it names the file already
    }
    return mesh;
}

}  // namespace rasterloom::host
