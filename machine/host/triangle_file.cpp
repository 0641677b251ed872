// SPDX-License-Identifier: MIT
#include "machine/host/triangle_file.hpp"

#include "machine/fabric/polygon.hpp"
#include "machine/host/atomic_file.hpp"
#include "topologies/text_line.hpp"

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

}  // namespace

std::vector<ScreenTriangle> read_triangles(std::istream& in, const std::string& name) {
    std::vector<ScreenTriangle> triangles;
    topology::for_each_line(in, name, [&](TextLine& line) {
        if (triangles.size() == kMostTriangles)
            line.fail(fmt::format("the end of the file after {} triangles", kMostTriangles));
        ScreenTriangle triangle;
        for (ScreenVertex& vertex : triangle.vertices)
            vertex = read_vertex(line);
        line.expect_end("the third vertex");
        triangles.push_back(triangle);
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
    for (const ScreenTriangle& triangle : triangles)
        for (const ScreenVertex& vertex : triangle.vertices)
            fmt::format_to(std::back_inserter(text), "{} {} {} {}{}", 1.0 * vertex.x / kSubpixels,
                           1.0 * vertex.y / kSubpixels, vertex.depth,
                           1.0 * vertex.shade / kShadeUnit,
                           &vertex == &triangle.vertices.back() ? "\n" : "  ");
    return fmt::to_string(text);
}

void save_triangles(const std::filesystem::path& path, std::span<const ScreenTriangle> triangles) {
    const auto text = triangles_as_text(triangles);
    write_file_atomically(path, std::vector<std::uint8_t>(text.begin(), text.end()));
}

}  // namespace rasterloom::host
