// SPDX-License-Identifier: MIT
#include "machine/host/polygon_file.hpp"

#include "machine/host/atomic_file.hpp"
#include "machine/host/polygon_convex.hpp"
#include "machine/host/polygon_shape.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::host {
namespace {

// Of one polygon as it stands in the file: dividing takes time that grows with the cube.
constexpr std::size_t kMostVertices = 500;

std::vector<std::string_view> words_of(std::string_view line) {
    constexpr std::string_view kSpace = " \t\r";
    line = line.substr(0, line.find('#'));
    std::vector<std::string_view> words;
    for (std::size_t at = 0; (at = line.find_first_not_of(kSpace, at)) != line.npos;) {
        const std::size_t end = std::min(line.find_first_of(kSpace, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

template <typename Number>
std::optional<Number> parse(std::string_view word) {
    Number number{};
    const auto* end = word.data() + word.size();
    const auto result = std::from_chars(word.data(), end, number);
    if (result.ec != std::errc{} || result.ptr != end)
        return std::nullopt;
    return number;
}

// For messages: short, and without control characters.
std::string quoted(std::string_view word) {
    constexpr std::size_t kLongest = 40;
    std::string text;
    for (const char c : word.substr(0, kLongest))
        text += c >= ' ' && c <= '~' ? std::string(1, c)
                                     : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    return "'" + text + (word.size() > kLongest ? "...'" : "'");
}

// Whether two edges that do not follow each other have a point in common.
bool crosses_itself(const std::vector<PolygonVertex>& outline) {
    const std::size_t count = outline.size();
    const auto side = [&](std::size_t a, std::size_t b, std::size_t c) {
        const std::array triangle{outline[a % count], outline[b % count], outline[c % count]};
        const auto area = doubled_area(triangle);
        return (area > 0) - (area < 0);
    };
    const auto is_between = [&](std::size_t a, std::size_t b, std::size_t p) {
        const auto &u = outline[a % count], &v = outline[b % count], &w = outline[p % count];
        return std::min(u.x, v.x) <= w.x && w.x <= std::max(u.x, v.x) &&
               std::min(u.y, v.y) <= w.y && w.y <= std::max(u.y, v.y);
    };
    for (std::size_t a = 0; a < count; ++a)
        for (std::size_t c = a + 2; c < count && (c + 1) % count != a; ++c) {
            const int s1 = side(a, a + 1, c), s2 = side(a, a + 1, c + 1);
            const int s3 = side(c, c + 1, a), s4 = side(c, c + 1, a + 1);
            if ((s1 * s2 < 0 && s3 * s4 < 0) || (s1 == 0 && is_between(a, a + 1, c)) ||
                (s2 == 0 && is_between(a, a + 1, c + 1)) || (s3 == 0 && is_between(c, c + 1, a)) ||
                (s4 == 0 && is_between(c, c + 1, a + 1)))
                return true;
        }
    return false;
}

bool lies_in_a_line(const std::vector<PolygonVertex>& outline) {
    return convex_hull(outline).size() <= 2;
}

std::vector<Polygon> parts_of(const std::vector<PolygonVertex>& outline) {
    std::vector<glm::dvec3> corners;
    for (const auto& v : outline)
        corners.emplace_back(v.x, v.y, 0);
    std::vector<Polygon> parts;
    for (const auto& part : convex_parts(corners)) {
        Polygon polygon;
        for (const std::size_t k : part)
            polygon.vertices.push_back(outline[k]);
        std::ranges::move(divide_polygon(std::move(polygon)), std::back_inserter(parts));
    }
    return parts;
}

class Reader {
  public:
    Reader(std::string name, int width, int height)
        : name_(std::move(name)), width_(width), height_(height) {}

    std::vector<Polygon> read(std::istream& stream) {
        for (std::string line; std::getline(stream, line);) {
            ++line_;
            read_line(words_of(line));
        }
        if (stream.bad())
            throw std::runtime_error(fmt::format("{}: cannot be read", name_));
        end_polygon();
        if (polygons_.empty())
            throw std::runtime_error(
                fmt::format("{}: no polygons, expected a line 'polygon' and its vertices", name_));
        return std::move(polygons_);
    }

  private:
    [[noreturn]] void fail(std::size_t line, const std::string& what) const {
        throw std::runtime_error(fmt::format("{}:{}: {}", name_, line, what));
    }

    void read_line(const std::vector<std::string_view>& words) {
        if (words.empty())
            return;
        if (words[0] == "polygon") {
            if (words.size() > 1)
                fail(line_, fmt::format("{} after 'polygon', expected a line of its own",
                                        quoted(words[1])));
            end_polygon();
            first_line_ = line_;
            return;
        }
        if (!first_line_)
            fail(line_,
                 fmt::format("{}, expected 'polygon' before the first vertex", quoted(words[0])));
        if (words.size() != 4)
            fail(line_, fmt::format("{} words from {} on, expected x y z grey, or 'polygon'",
                                    words.size(), quoted(words[0])));
        if (outline_.size() == kMostVertices)
            fail(line_, fmt::format("one more than {} vertices, expected fewer", kMostVertices));
        outline_.push_back({whole("x", words[0], width_ - 1), whole("y", words[1], height_ - 1),
                            whole("z", words[2], kFarthest), shade(words[3])});
    }

    std::int16_t whole(const char* what, std::string_view word, int most) const {
        const auto number = parse<long long>(word);
        if (!number || *number < 0 || *number > most)
            fail(line_, fmt::format("{} is {}, expected a whole number from 0 to {}", what,
                                    quoted(word), most));
        return static_cast<std::int16_t>(*number);
    }

    std::int16_t shade(std::string_view word) const {
        const auto grey = parse<double>(word);
        if (!grey || !(*grey >= 0 && *grey <= 255))
            fail(line_, fmt::format("the grey level is {}, expected a number from 0 to 255",
                                    quoted(word)));
        return static_cast<std::int16_t>(std::floor(*grey * kShadeUnit + 0.5));
    }

    void end_polygon() {
        if (!first_line_)
            return;
        if (outline_.empty())
            fail(*first_line_, "a polygon without vertices, expected at least one line x y z grey");
        drop_repeated_vertices(outline_);
        if (lies_in_a_line(outline_)) {
            if (!is_convex(outline_) || outline_.size() > kMaxPolygonVertices)
                outline_ = convex_hull(outline_);
        } else if (!is_convex(outline_) && crosses_itself(outline_)) {
            fail(*first_line_,
                 "an outline that crosses or touches itself, expected one that does not");
        } else if (doubled_area(outline_) < 0) {
            fail(*first_line_,
                 "vertices that run clockwise, expected counter-clockwise with y upwards");
        }
        std::ranges::move(parts_of(outline_), std::back_inserter(polygons_));
        outline_.clear();
    }

    std::string name_;
    int width_;
    int height_;
    std::size_t line_ = 0;
    std::optional<std::size_t> first_line_;  // of the polygon being read
    std::vector<PolygonVertex> outline_;
    std::vector<Polygon> polygons_;
};

}  // namespace

std::vector<Polygon> read_polygons(std::istream& stream, const std::string& name, int width,
                                   int height) {
    return Reader(name, width, height).read(stream);
}

std::vector<Polygon> load_polygons(const std::filesystem::path& path, int width, int height) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        throw std::runtime_error(
            fmt::format("{}: no such file, expected screen polygons", path.string()));
    std::ifstream stream(path);
    if (!stream)
        throw std::runtime_error(fmt::format("{}: cannot be opened", path.string()));
    return read_polygons(stream, path.string(), width, height);
}

std::string polygons_as_text(std::span<const Polygon> polygons) {
    std::string text =
        "# x y z grey: pixels from the left and from the bottom, depth 0 (nearest) "
        "to 32766, level 0 to 255\n";
    for (const auto& polygon : polygons) {
        text += "polygon\n";
        for (const auto& v : polygon.vertices)
            text += fmt::format("  {} {} {} {}\n", v.x, v.y, v.z,
                                static_cast<double>(v.shade) / kShadeUnit);
    }
    return text;
}

void save_polygons(const std::filesystem::path& path, std::span<const Polygon> polygons) {
    const auto text = polygons_as_text(polygons);
    write_file_atomically(path, std::vector<std::uint8_t>(text.begin(), text.end()));
}

}  // namespace rasterloom::host
