// SPDX-License-Identifier: MIT
// The keys of a scene: the object, how it turns, where it stands, its light.
#include "machine/config/scene_fields.hpp"

#include "machine/config/field_builders.hpp"
#include "machine/config/yaml_text.hpp"

#include <limits>

namespace rasterloom::config {

namespace {

SceneDescription& scene_of(MachineDescription& machine) {
    if (!machine.scene) {
        machine.scene.emplace();
    }
    return *machine.scene;
}

const SceneDescription& scene_of(const MachineDescription& machine) {
    return *machine.scene;
}

void read_object(MachineDescription& machine, const Value& value, const Locator& locator) {
    SceneDescription& scene = scene_of(machine);
    scene.object = scalar_text(value);
    scene.mesh = locator.find(scene.object, value.where.source, {});
    const bool looks_like_a_file = scene.object.find_first_of("./") != std::string::npos;
    if (!scene.mesh && (looks_like_a_file || scene.object.empty())) {
        throw std::invalid_argument("no such file (looked in " +
                                    Locator::places(value.where.source, {}) + ")");
    }
}

Field object_field() {
    return {"scene.object",
            "a built-in object or scene, a mesh file, a polygon file (.polygons), bounding boxes "
            "(.boxes) or a triangle file (.triangles)",
            "what is drawn: see `rasterloom list scenes`; a file is looked for beside the "
            "configuration",
            false,
            read_object,
            [](const MachineDescription& machine) {
                const SceneDescription& scene = scene_of(machine);
                return yaml_scalar(scene.mesh ? scene.mesh->string() : scene.object);
            }};
}

Field model_field() {
    return file_field(
        "scene.model", "a mesh file",
        "what a polygon scene shows in place of its own shuttle; looked for beside "
        "the configuration",
        [](auto& m) -> auto& { return scene_of(m).model; });
}

void read_texture(MachineDescription& machine, const Value& value, const Locator& locator) {
    TextureDescription& texture = scene_of(machine).texture;
    texture.name = scalar_text(value);
    texture.file.reset();
    if (texture.name == "none" || texture.name == "checker" || texture.name == "skin") {
        return;
    }
    texture.file = locator.find(texture.name, value.where.source, {});
    if (!texture.file) {
        throw std::invalid_argument("no such file (looked in " +
                                    Locator::places(value.where.source, {}) + ")");
    }
}

Field texture_field() {
    return {"scene.texture",
            "none, checker, skin or a PNG file",
            "what an object is covered with on a lock-step machine or bucket tiles: nothing but "
            "its colour, a built-in pattern or a picture, looked for beside the configuration",
            false,
            read_texture,
            [](const MachineDescription& machine) {
                const TextureDescription& texture = scene_of(machine).texture;
                return yaml_scalar(texture.file ? texture.file->string() : texture.name);
            }};
}

Field background_field() {
    return {"scene.background",
            "a whole number from 0 to 255",
            "grey level behind the object; default: 0, or what the polygon scene has",
            false,
            [](MachineDescription& machine, const Value& value, const Locator&) {
                const std::int64_t grey = parse_count(scalar_text(value));
                if (grey < 0 || grey > 255) {
                    throw std::invalid_argument("out of range");
                }
                scene_of(machine).background = grey;
            },
            [](const MachineDescription& machine) {
                const auto& grey = scene_of(machine).background;
                return grey ? std::to_string(*grey) : std::string();
            }};
}

void add_camera_fields(std::vector<Field>& fields) {
    fields.push_back(vector_field(
        "scene.camera.eye",
        "of bucket tiles: where the viewer stands; the object is in the unit sphere, z up, its "
        "front towards -x",
        true, [](auto& m) -> auto& { return scene_of(m).camera.eye; }));
    fields.push_back(vector_field(
        "scene.camera.target", "what the camera looks at", true,
        [](auto& m) -> auto& { return scene_of(m).camera.target; }));
    fields.push_back(real_field(
        "scene.camera.field_of_view", "of the camera: degrees between the screen's sides", 1, 179,
        [](auto& m) -> auto& { return scene_of(m).camera.field_of_view; }));
}

void add_random_triangle_fields(std::vector<Field>& fields) {
    fields.push_back(count_field(
        "scene.triangles.count", "how many random triangles", 1, 1 << 24,
        [](auto& m) -> auto& { return scene_of(m).triangles.count; }));
    fields.push_back(real_field(
        "scene.triangles.mean_area", "of random triangles, in pixels", 0.001, 1 << 24,
        [](auto& m) -> auto& { return scene_of(m).triangles.mean_area; }));
    fields.push_back(real_field(
        "scene.triangles.depth_complexity",
        "in place of mean_area: the sum of their areas over the screen's; 0: mean_area holds", 0,
        1000, [](auto& m) -> auto& { return scene_of(m).triangles.depth_complexity; }));
    fields.push_back(count_field(
        "scene.triangles.skew",
        "how uneven their areas are: mean (skew + 1) u^skew for u from 0 to 1; 0: all alike", 0, 16,
        [](auto& m) -> auto& { return scene_of(m).triangles.skew; }));
    fields.push_back(real_field(
        "scene.triangles.box_ratio", "the area of their bounding boxes over their own", 2, 1000,
        [](auto& m) -> auto& { return scene_of(m).triangles.box_ratio; }));
    fields.push_back(real_field(
        "scene.triangles.aspect", "the longer side of their bounding boxes over the shorter", 1,
        1000, [](auto& m) -> auto& { return scene_of(m).triangles.aspect; }));
}

void add_random_fields(std::vector<Field>& fields) {
    fields.push_back(count_field(
        "scene.polygons",
        "how many, in a random scene; about how many a teapot has, on a lock-step machine", 1,
        1'000'000, [](auto& m) -> auto& { return scene_of(m).polygons; }));
    fields.push_back(count_field(
        "scene.seed", "of a random scene", 0, std::numeric_limits<std::int64_t>::max(),
        [](auto& m) -> auto& { return scene_of(m).seed; }));
}

void add_object_fields(std::vector<Field>& fields) {
    const std::vector<std::pair<std::string, std::string>> axes{
        {"x", "x"}, {"-x", "-x"}, {"y", "y"}, {"-y", "-y"}, {"z", "z"}, {"-z", "-z"}};
    fields.push_back(object_field());
    fields.push_back(model_field());
    fields.push_back(choice_field<std::string>(
        "scene.up", "axis of the mesh file that points up", axes,
        [](auto& m) -> auto& { return scene_of(m).up; }));
    fields.push_back(choice_field<std::string>(
        "scene.front", "axis of the mesh file that faces the viewer", axes,
        [](auto& m) -> auto& { return scene_of(m).front; }));
    fields.push_back(real_field(
        "scene.size", "radius a mesh file is fitted to, in sphere radii", 0.01, 1.0,
        [](auto& m) -> auto& { return scene_of(m).size; }));
    fields.push_back(choice_field<Normals>(
        "scene.normals", "shading: interpolated normals, or those of the faces",
        {{"smooth", Normals::smooth}, {"face", Normals::face}},
        [](auto& m) -> auto& { return scene_of(m).normals; }));
    fields.push_back(texture_field());
}

void add_motion_fields(std::vector<Field>& fields) {
    fields.push_back(vector_field(
        "scene.rotate.axis", "axis of rotation; +z is the north pole", false,
        [](auto& m) -> auto& { return scene_of(m).rotate.axis; }));
    fields.push_back(real_field(
        "scene.rotate.degrees", "rotation from each frame to the next, right-handed, in degrees",
        -360, 360, [](auto& m) -> auto& { return scene_of(m).rotate.degrees; }));
    fields.push_back(real_field(
        "scene.rotate.start", "rotation of the first frame, made by the machine, in degrees", -360,
        360, [](auto& m) -> auto& { return scene_of(m).rotate.start; }));
    fields.push_back(choice_field<Routing>(
        "scene.routing", "how messages find their way over the sphere",
        {{"small_circle", Routing::small_circle}, {"great_circle", Routing::great_circle}},
        [](auto& m) -> auto& { return scene_of(m).routing; }));
}

void add_view_fields(std::vector<Field>& fields) {
    fields.push_back(real_field(
        "scene.scale",
        "size in the picture: 1 fills half its width with a sphere's radius, and half its height; "
        "on a "
        "bucket tiler, whose pixels are square, the lesser of the two",
        0.01, 4, [](auto& m) -> auto& { return scene_of(m).scale; }));
    fields.push_back(vector_field(
        "scene.translate", "shift to the right, down and away, in sphere radii", true,
        [](auto& m) -> auto& { return scene_of(m).translate; }));
    fields.push_back(real_field(
        "scene.vanishing_distance", "distance of the eye, in sphere radii", 1.5, 1000,
        [](auto& m) -> auto& { return scene_of(m).vanishing_distance; }));
    fields.push_back(vector_field(
        "scene.light", "direction towards the light; the viewer stands on -x", false,
        [](auto& m) -> auto& { return scene_of(m).light; }));
    fields.push_back(real_field(
        "scene.ambient", "share of light that falls everywhere", 0, 1,
        [](auto& m) -> auto& { return scene_of(m).ambient; }));
    fields.push_back(background_field());
}

}  // namespace

void add_scene_fields(std::vector<Field>& fields) {
    add_object_fields(fields);
    add_motion_fields(fields);
    add_view_fields(fields);
    add_camera_fields(fields);
    add_random_fields(fields);
    add_random_triangle_fields(fields);
}

}  // namespace rasterloom::config
