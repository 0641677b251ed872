// SPDX-License-Identifier: MIT
#include "machine/host/bounding_boxes.hpp"

#include "machine/host/atomic_file.hpp"
#include "topologies/text_line.hpp"

#include <iterator>
#include <optional>

#include <fmt/format.h>

namespace rasterloom::host {
namespace {

using topology::TextFileError;
using topology::TextLine;

constexpr std::string_view kCount = "NumPolygons";

std::int64_t read_count(TextLine& line) {
    line.expect(kCount);
    line.expect("=");
    const auto count = line.whole(kCount, 1, kMostBoxes);
    line.expect_end("the number of polygons");
    return count;
}

BoundingBox read_box(TextLine& line) {
    const bool is_visible = line.whole("the visible flag", 0, 1) == 1;
    const BoundingBox box{is_visible, line.box()};
    line.expect_end("the second corner");
    return box;
}

}  // namespace

std::vector<BoundingBox> read_bounding_boxes(std::istream& in, const std::string& name) {
    std::optional<std::int64_t> count;
    std::vector<BoundingBox> boxes;
    const std::size_t lines = topology::for_each_line(in, name, [&](TextLine& line) {
        if (!count)
            count = read_count(line);
        else if (std::ssize(boxes) == *count)
            line.fail(fmt::format("the end of the file after {} polygons ({}={})", *count, kCount,
                                  *count));
        else
            boxes.push_back(read_box(line));
    });
    if (!count)
        throw TextFileError(
            fmt::format("{}: nothing in the file, expected '{}=' and a number", name, kCount));
    if (std::ssize(boxes) < *count)
        throw TextFileError(
            fmt::format("{}:{}:1: the end of the file after {} polygons, expected "
                        "{} ({}={})",
                        name, lines + 1, boxes.size(), *count, kCount, *count));
    return boxes;
}

std::vector<BoundingBox> load_bounding_boxes(const std::filesystem::path& path) {
    std::ifstream in = topology::open_text_file(path, "bounding boxes of polygons");
    return read_bounding_boxes(in, path.string());
}

std::string bounding_boxes_as_text(std::span<const BoundingBox> boxes) {
    fmt::memory_buffer text;
    fmt::format_to(std::back_inserter(text), "{}={}\n", kCount, boxes.size());
    for (const auto& [is_visible, box] : boxes)
        fmt::format_to(std::back_inserter(text), "{:d} ({},{}) ({},{})\n", is_visible, box.x0,
                       box.y0, box.x1, box.y1);
    return fmt::to_string(text);
}

void save_bounding_boxes(const std::filesystem::path& path, std::span<const BoundingBox> boxes) {
    const auto text = bounding_boxes_as_text(boxes);
    write_file_atomically(path, std::vector<std::uint8_t>(text.begin(), text.end()));
}

}  // namespace rasterloom::host
