// SPDX-License-Identifier: MIT
#include "machine/observe/bucket_report.hpp"

#include "machine/observe/csv_text.hpp"

#include <iterator>

#include <fmt/format.h>

namespace rasterloom::observe {

namespace {

double ratio(std::int64_t part, std::int64_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

BucketReport::Rasterizer total(const BucketReport& buckets) {
    BucketReport::Rasterizer sum;
    for (const BucketReport::Rasterizer& each : buckets.rasterizers) {
        sum.pairs += each.pairs;
        sum.pairs_without_pixels += each.pairs_without_pixels;
        sum.pixels += each.pixels;
        sum.triangle_busy += each.triangle_busy;
        sum.triangle_blocked += each.triangle_blocked;
        sum.triangle_starved += each.triangle_starved;
        sum.pixel_busy += each.pixel_busy;
        sum.pixel_starved += each.pixel_starved;
    }
    return sum;
}

void add_units(std::string& text, const BucketReport& buckets) {
    const BucketReport::Rasterizer sum = total(buckets);
    const std::int64_t triangle = sum.triangle_busy + sum.triangle_blocked + sum.triangle_starved;
    const std::int64_t pixel = sum.pixel_busy + sum.pixel_starved;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "Triangle unit{}  {} cycles: {:.1f}% busy, {:.1f}% the FIFO was full\n",
                   buckets.rasterizers.size() == 1 ? " " : "s", triangle,
                   100 * ratio(sum.triangle_busy, triangle),
                   100 * ratio(sum.triangle_blocked, triangle));
    fmt::format_to(out, "Pixel unit{}     {} cycles: {:.1f}% busy, {:.1f}% the FIFO was empty\n",
                   buckets.rasterizers.size() == 1 ? " " : "s", pixel,
                   100 * ratio(sum.pixel_busy, pixel), 100 * ratio(sum.pixel_starved, pixel));
}

}  // namespace

double BucketReport::Frame::overlap() const {
    return ratio(pairs, visible);
}

std::string rasterizers_csv(const BucketReport& buckets) {
    std::string text =
        "name,tiles,pairs,pairs_without_pixels,pixels,triangle_busy_u,triangle_blocked_u,"
        "triangle_starved_u,pixel_busy_u,pixel_starved_u,fifo_peak\n";
    for (const BucketReport::Rasterizer& each : buckets.rasterizers) {
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{}\n",
                       csv_text(each.name), each.tiles, each.pairs, each.pairs_without_pixels,
                       each.pixels, each.triangle_busy, each.triangle_blocked,
                       each.triangle_starved, each.pixel_busy, each.pixel_starved, each.fifo_peak);
    }
    return text;
}

std::string bucket_summary(const BucketReport& buckets) {
    std::string text = fmt::format("Tiles           {} of {} x {} pixels\n", buckets.tiles,
                                   buckets.tile_width, buckets.tile_height);
    for (std::size_t i = 0; i < buckets.frames.size(); ++i) {
        const BucketReport::Frame& frame = buckets.frames[i];
        fmt::format_to(
            std::back_inserter(text),
            "Frame {:<9} {} triangles, {} in {} tiles: {} pairs, overlap {:.3f}, {} pixels; {} "
            "cycles to sort, {} to draw\n",
            i, frame.triangles, frame.visible, frame.tiles, frame.pairs, frame.overlap(),
            frame.pixels, frame.sort_cycles, frame.draw_cycles);
    }
    if (buckets.hardware) {
        add_units(text, buckets);
    }
    return text;
}

}  // namespace rasterloom::observe
