// SPDX-License-Identifier: MIT
#include "machine/emulation/bucket_books.hpp"

#include <limits>
#include <vector>

namespace rasterloom::emulation {

namespace {

using observe::BucketReport;

// Pairs come in the order of their triangles.
BucketReport::Frame count(const TileFrame& work, topology::TileIndex tiles) {
    BucketReport::Frame frame;
    frame.triangles = work.triangles;
    frame.pairs = static_cast<std::int64_t>(work.pairs.size());
    std::vector<bool> has_pair(tiles);
    std::uint32_t last = std::numeric_limits<std::uint32_t>::max();
    for (const TileWork& pair : work.pairs) {
        frame.visible += pair.triangle != last ? 1 : 0;
        last = pair.triangle;
        frame.pixels += pair.pixels;
        frame.tiles += has_pair[pair.tile] ? 0 : 1;
        has_pair[pair.tile] = true;
    }
    return frame;
}

BucketReport::Rasterizer count(const Rasterizer& rasterizer) {
    const RasterizerStatistics counted = rasterizer.statistics();
    BucketReport::Rasterizer report;
    report.tiles = counted.tiles;
    report.pairs = counted.pairs;
    report.pairs_without_pixels = counted.pairs_without_pixels;
    report.pixels = counted.pixels;
    report.triangle_busy = counted.triangle_busy.count();
    report.triangle_blocked = counted.triangle_blocked.count();
    report.triangle_starved = counted.triangle_starved.count();
    report.pixel_busy = counted.pixel_busy.count();
    report.pixel_starved = counted.pixel_starved.count();
    report.fifo_peak = static_cast<std::int64_t>(counted.fifo_peak);
    return report;
}

BucketReport::Rasterizer count(const TileFeeder& feeder) {
    BucketReport::Rasterizer report;
    report.tiles = feeder.statistics().tiles;
    report.pairs = feeder.statistics().triangles;
    return report;
}

}  // namespace

BucketReport gather_buckets(const Blueprint& blueprint, const BucketNetwork& buckets,
                            const std::vector<observe::PhaseReport>& phases) {
    const topology::BucketTiles& tiles = *blueprint.tiles;
    const Clock clock = blueprint.description.nodes.clock.clock();
    const auto cycles = [&clock](Duration duration) {
        return clock.edge_at_or_before(Time::zero() + duration).count();
    };
    BucketReport report;
    report.tile_width = tiles.tile_size().width;
    report.tile_height = tiles.tile_size().height;
    report.tiles = tiles.tiles();
    report.hardware = !buckets.rasterizers.empty();
    for (std::size_t i = 0; i < buckets.sorter->frames().size(); ++i) {
        const TileFrameRecord& record = buckets.sorter->frames()[i];
        BucketReport::Frame& frame =
            report.frames.emplace_back(count(buckets.sorter->work_of_frame(i), tiles.tiles()));
        frame.sort_cycles = cycles(record.sorted - record.began);
        // What has been sent to a program is not drawn yet.
        const Time drawn = report.hardware || i >= phases.size() ? record.ended : phases[i].end;
        frame.draw_cycles = cycles(drawn - record.sorted);
    }
    for (const Rasterizer* rasterizer : buckets.rasterizers) {
        report.rasterizers.push_back(count(*rasterizer));
    }
    for (const TileFeeder* feeder : buckets.feeders) {
        report.rasterizers.push_back(count(*feeder));
    }
    for (std::size_t i = 0; i < report.rasterizers.size(); ++i) {
        report.rasterizers[i].name = blueprint.topology.nodes[i].name;
    }
    return report;
}

}  // namespace rasterloom::emulation
