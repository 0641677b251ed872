// SPDX-License-Identifier: MIT
#include "machine/host/triangle_file.hpp"

#include "machine/fabric/polygon.hpp"
#include "machine/host/atomic_file.hpp"
#include "topologies/text_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

#include <fmt/format.h>

namespace rasterloom::host {
namespace {

using topology::TextFileError;
using topology::TextLine;

std::int32_t to_units(double value, int units) {
    return static_cast<std::int32_t>(std::floor(value * units + 0.5));
}

ScreenVertex read_vertex(TextLine& line) {
    constexpr double kFarthestPlace = topology::kFarthestPixel;
    ScreenVertex vertex;
    vertex.x = to_units(line.decimal("x", -kFarthestPlace, kFarthestPlace), kSubpixels);
    vertex.y = to_units(line.decimal("y", -kFarthestPlace, kFarthestPlace), kSubpixels);
    vertex.depth = to_units(line.decimal("z", 0, kFarthest), 1);
    vertex.shade = to_units(line.decimal("grey", 0, 255), kShadeUnit);
    return vertex;
}

std::int32_t read_texture_place(TextLine& line, const char* what) {
    return std::min(to_units(line.decimal(what, 0, 1), kTextureUnits), kTextureUnits - 1);
}

ScreenTriangle read_triangle(TextLine& line) {
    ScreenTriangle triangle;
    for (ScreenVertex& vertex : triangle.vertices)
        vertex = read_vertex(line);
    if (line.at_end())
        return triangle;
    for (ScreenVertex& vertex : triangle.vertices) {
        vertex.u = read_texture_place(line, "u");
        vertex.v = read_texture_place(line, "v");
    }
    line.expect_end("the third vertex' u and v");
    return triangle;
}

bool is_textured(const ScreenTriangle& triangle) {
    return std::any_of(triangle.vertices.begin(), triangle.vertices.end(),
                       [](const ScreenVertex& vertex) { return vertex.u != 0 || vertex.v != 0; });
}

// Five digits tell 1/kTextureUnits apart.
void append_texture_places(fmt::memory_buffer& text, const ScreenTriangle& triangle) {
    for (const ScreenVertex& vertex : triangle.vertices)
        fmt::format_to(std::back_inserter(text), "  {:.5g} {:.5g}", 1.0 * vertex.u / kTextureUnits,
                       1.0 * vertex.v / kTextureUnits);
}

}  // namespace

std::vector<ScreenTriangle> read_triangles(std::istream& in, const std::string& name) {
    std::vector<ScreenTriangle> triangles;
    topology::for_each_line(in, name, [&](TextLine& line) {
        if (triangles.size() == kMostTriangles)
            line.fail(fmt::format("the end of the file after {} triangles", kMostTriangles));
        triangles.push_back(read_triangle(line));
    });
    if (triangles.empty())
        throw TextFileError(fmt::format(
            "{}: nothing in the file, expected lines of three vertices 'x y z grey'", name));
    return triangles;
}

std::vector<ScreenTriangle> load_triangles(const std::filesystem::path& path) {
    std::ifstream in = topology::open_text_file(path, "triangles on the screen");
    return read_triangles(in, path.string());
}

std::string triangles_as_text(std::span<const ScreenTriangle> triangles) {
    fmt::memory_buffer text;
    for (const ScreenTriangle& triangle : triangles) {
        for (const ScreenVertex& vertex : triangle.vertices)
            fmt::format_to(std::back_inserter(text), "{}{} {} {} {}",
                           &vertex == &triangle.vertices.front() ? "" : "  ",
                           1.0 * vertex.x / kSubpixels, 1.0 * vertex.y / kSubpixels, vertex.depth,
                           1.0 * vertex.shade / kShadeUnit);
        if (is_textured(triangle))
            append_texture_places(text, triangle);
        text.push_back('\n');
    }
    return fmt::to_string(text);
}

void save_triangles(const std::filesystem::path& path, std::span<const ScreenTriangle> triangles) {
    const auto text = triangles_as_text(triangles);
    write_file_atomically(path, std::vector<std::uint8_t>(text.begin(), text.end()));
}

}  // namespace rasterloom::host
