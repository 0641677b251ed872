// SPDX-License-Identifier: MIT
#include "machine/observe/bucket_json.hpp"

#include <utility>

namespace rasterloom::observe {

nlohmann::ordered_json bucket_json(const BucketReport& buckets) {
    using Json = nlohmann::ordered_json;
    Json frames = Json::array();
    for (const BucketReport::Frame& frame : buckets.frames) {
        frames.push_back({{"triangles", frame.triangles},
                          {"visible", frame.visible},
                          {"pairs", frame.pairs},
                          {"overlap", frame.overlap()},
                          {"pixels", frame.pixels},
                          {"tiles", frame.tiles},
                          {"sort_u", frame.sort_cycles},
                          {"draw_u", frame.draw_cycles}});
    }
    Json rasterizers = Json::array();
    for (const BucketReport::Rasterizer& each : buckets.rasterizers) {
        Json row{{"name", each.name}, {"tiles", each.tiles}, {"pairs", each.pairs}};
        if (buckets.hardware) {
            row["pairs_without_pixels"] = each.pairs_without_pixels;
            row["pixels"] = each.pixels;
            row["triangle_unit"] = {{"busy_u", each.triangle_busy},
                                    {"blocked_u", each.triangle_blocked},
                                    {"starved_u", each.triangle_starved}};
            row["pixel_unit"] = {{"busy_u", each.pixel_busy}, {"starved_u", each.pixel_starved}};
            row["fifo_peak"] = each.fifo_peak;
        }
        rasterizers.push_back(std::move(row));
    }
    return {{"tile_width", buckets.tile_width},
            {"tile_height", buckets.tile_height},
            {"tiles", buckets.tiles},
            {"rasterizer", buckets.hardware ? "hardware" : "software"},
            {"frames", std::move(frames)},
            {"rasterizers", std::move(rasterizers)}};
}

}  // namespace rasterloom::observe
