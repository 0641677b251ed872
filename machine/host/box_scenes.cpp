// SPDX-License-Identifier: MIT
#include "machine/host/box_scenes.hpp"

#include "machine/kernel/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace rasterloom::host {
namespace {

// Above zero when the corners run clockwise with y downwards, twice the area in pixels.
double turning_area(std::span<const glm::dvec2> places) {
    double sum = 0;
    for (std::size_t k = 1; k + 1 < places.size(); ++k) {
        const auto a = places[k] - places[0];
        const auto b = places[k + 1] - places[0];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

BoundingBox box_of(const StagePolygon& polygon, const Lens& lens) {
    std::vector<glm::dvec2> places;
    for (const auto& corner : polygon.corners) {
        const auto seen = through_lens(corner, lens);
        if (seen.distance < lens.near)
            return {};
        places.push_back(place_on_screen(seen, lens));
    }
    glm::dvec2 least{std::numeric_limits<double>::max()};
    glm::dvec2 greatest = -least;
    for (const auto& place : places) {
        const auto pixel = glm::floor(place + 0.5);
        least = glm::min(least, pixel);
        greatest = glm::max(greatest, pixel);
    }
    const glm::dvec2 last{lens.width - 1, lens.height - 1};
    if (greatest.x < 0 || greatest.y < 0 || least.x > last.x || least.y > last.y)
        return {};
    least = glm::max(least, glm::dvec2{0});
    greatest = glm::min(greatest, last);
    return {turning_area(places) < 0,
            {static_cast<int>(least.x), static_cast<int>(least.y), static_cast<int>(greatest.x),
             static_cast<int>(greatest.y)}};
}

void check(const RandomBoxes& options) {
    const auto expect = [](const char* what, std::int64_t value, std::int64_t most) {
        if (value < 1 || value > most)
            throw std::invalid_argument(
                fmt::format("random boxes: {} is {}, expected 1 to {}", what, value, most));
    };
    expect("the count", options.count, kMostBoxes);
    expect("the screen's width", options.width, topology::kFarthestPixel + 1);
    expect("the screen's height", options.height, topology::kFarthestPixel + 1);
    expect("the longest side", options.longest_side, topology::kFarthestPixel + 1);
}

struct Extent {
    int first, last;
};

Extent random_extent(Random& random, int size, int longest) {
    const auto below = [&](int bound) {
        return static_cast<int>(random.below(static_cast<std::uint64_t>(bound)));
    };
    const int side = 1 + below(std::min(longest, size));
    const int first = below(size - side + 1);
    return {first, first + side - 1};
}

}  // namespace

std::vector<BoundingBox> boxes_through_lens(std::span<const StagePolygon> stage, const Lens& lens) {
    std::vector<BoundingBox> boxes;
    boxes.reserve(stage.size());
    for (const auto& polygon : stage)
        boxes.push_back(box_of(polygon, lens));
    return boxes;
}

std::vector<BoundingBox> random_boxes(const RandomBoxes& options) {
    check(options);
    std::vector<BoundingBox> boxes;
    boxes.reserve(static_cast<std::size_t>(options.count));
    for (std::uint64_t number = 0; number < static_cast<std::uint64_t>(options.count); ++number) {
        Random random(options.seed, 1 + number);
        const bool is_visible = random.below(2) == 1;
        const Extent x = random_extent(random, options.width, options.longest_side);
        const Extent y = random_extent(random, options.height, options.longest_side);
        boxes.push_back({is_visible, {x.first, y.first, x.last, y.last}});
    }
    return boxes;
}

}  // namespace rasterloom::host
