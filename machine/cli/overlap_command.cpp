// SPDX-License-Identifier: MIT
// rasterloom overlap: how many tiles a scene's triangles overlap, counted, beside the formula of
// Molnar and Eyles (Chen et al. 1998, equation 1 and figure 6).
#include "machine/cli/command.hpp"
#include "machine/config/error.hpp"
#include "machine/host/overlap_census.hpp"
#include "machine/host/triangle_file.hpp"

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rasterloom::cli {

namespace {

using nlohmann::ordered_json;
using topology::BucketTiles;
using topology::TileSize;

struct OverlapOptions {
    std::string triangles;
    std::vector<std::string> tiles{"8", "16", "32", "64", "128"};
    int width = 1024;
    int height = 768;
    double box_ratio = 3;
    bool as_json = false;
};

TileSize tile_size(const std::string& text) {
    try {
        return topology::parse_tile_size(text);
    } catch (const std::invalid_argument& problem) {
        throw std::invalid_argument(fmt::format("--tile: {}", problem.what()));
    }
}

struct Overlaps {
    host::TriangleCensus triangles;
    std::vector<BucketTiles> tiles;
    std::vector<host::OverlapCensus> counts;  // of each of `tiles`
};

Overlaps count(const OverlapOptions& options) {
    try {
        Overlaps result;
        for (const std::string& tile : options.tiles) {
            result.tiles.emplace_back(options.width, options.height, tile_size(tile));
        }
        const auto triangles = host::load_triangles(options.triangles);
        result.triangles = host::count_triangles(triangles, options.width, options.height);
        for (const BucketTiles& tiles : result.tiles) {
            result.counts.push_back(host::count_overlaps(triangles, tiles));
        }
        return result;
    } catch (const std::runtime_error& problem) {  // files
        config::refuse({}, {}, {}, problem.what());
    } catch (const std::invalid_argument& problem) {
        config::refuse({}, {}, {}, problem.what());
    }
}

void print_json(const OverlapOptions& options, const Overlaps& overlaps) {
    const auto& scene = overlaps.triangles;
    ordered_json sizes = ordered_json::array();
    for (std::size_t k = 0; k < overlaps.tiles.size(); ++k) {
        const auto tile = overlaps.tiles[k].tile_size();
        const auto& found = overlaps.counts[k];
        sizes.push_back({{"width", tile.width},
                         {"height", tile.height},
                         {"tiles", overlaps.tiles[k].tiles()},
                         {"pairs",
                          {{"bounding_box", found.bounding_box},
                           {"exact", found.exact},
                           {"covered", found.covered}}},
                         {"molnar_eyles",
                          host::molnar_eyles_overlap(scene.mean_area(), tile, options.box_ratio)}});
    }
    const ordered_json json{
        {"triangles", scene.triangles},     {"visible", scene.visible},
        {"back_facing", scene.back_facing}, {"without_area", scene.without_area},
        {"off_screen", scene.off_screen},   {"pixels", scene.pixels},
        {"mean_area", scene.mean_area()},   {"depth_complexity", scene.depth_complexity()},
        {"box_ratio", scene.box_ratio()},   {"sizes", sizes}};
    fmt::print("{}\n", json.dump(1));
}

void print_table(const OverlapOptions& options, const Overlaps& overlaps) {
    const auto& scene = overlaps.triangles;
    fmt::print(
        "{}: {} triangles, {} visible ({} back-facing, {} without area, {} off the screen)\n",
        options.triangles, scene.triangles, scene.visible, scene.back_facing, scene.without_area,
        scene.off_screen);
    fmt::print(
        "{} pixels: {:.1f} a visible triangle, depth complexity {:.2f}; bounding boxes {:.2f} "
        "times the triangles\n",
        scene.pixels, scene.mean_area(), scene.depth_complexity(), scene.box_ratio());
    fmt::print("{:>12}{:>10}{:>14}{:>10}{:>10}{:>15}\n", "tile", "tiles", "bounding box", "exact",
               "covered", "Molnar-Eyles");
    for (std::size_t k = 0; k < overlaps.tiles.size(); ++k) {
        const auto tile = overlaps.tiles[k].tile_size();
        const auto& found = overlaps.counts[k];
        fmt::print("{:>12}{:>10}{:>14.3f}{:>10.3f}{:>10.3f}{:>15.3f}\n", topology::name_of(tile),
                   overlaps.tiles[k].tiles(), scene.per_visible(found.bounding_box),
                   scene.per_visible(found.exact), scene.per_visible(found.covered),
                   host::molnar_eyles_overlap(scene.mean_area(), tile, options.box_ratio));
    }
}

}  // namespace

void add_overlap_command(CLI::App& app, Session&) {
    auto options = std::make_shared<OverlapOptions>();
    CLI::App* command = app.add_subcommand(
        "overlap",
        "Count the tiles that triangles overlap, by bounding box and exactly (Chen et al. 1998)");
    command->add_option("triangles", options->triangles, "Screen triangles (rasterloom triangles)")
        ->required()
        ->type_name("FILE");
    const auto add = [command](const char* name, auto& value, const char* summary) {
        return command->add_option(name, value, summary)->capture_default_str();
    };
    add("--tile", options->tiles, "Sizes of tiles in pixels, such as 8,32x16")->delimiter(',');
    add("--width", options->width, "Of the screen, pixels");
    add("--height", options->height, "Of the screen, pixels");
    add("--rho", options->box_ratio,
        "For the formula of Molnar and Eyles: the area of a bounding box over its triangle's")
        ->check(CLI::PositiveNumber);
    command->add_flag("--json", options->as_json, "The counts as JSON");
    command->callback([options] {
        const Overlaps overlaps = count(*options);
        if (options->as_json) {
            print_json(*options, overlaps);
        } else {
            print_table(*options, overlaps);
        }
    });
}

}  // namespace rasterloom::cli
