// SPDX-License-Identifier: MIT
#include "machine/observe/appendix_c/appendix_c_files.hpp"

#include <array>
#include <iterator>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rasterloom::observe {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, kSections> kSectionNames{"polygon", "vertex", "segment",
                                                                "pixel",   "digest", "other"};

Json distribution_json(const Distribution& data) {
    Json counts = Json::array();
    for (const auto& [value, times] : data.counts()) {
        counts.push_back({value, times});
    }
    return {{"points", data.points()},     {"sum", data.sum()},
            {"mean", data.mean()},         {"deviation", data.deviation()},
            {"variance", data.variance()}, {"counts", std::move(counts)}};
}

Json costs_json(const ItemCosts& costs) {
    return {{"polygon", costs.polygon},
            {"vertex", costs.vertex},
            {"segment", costs.segment},
            {"pixel", costs.pixel}};
}

Json statistics_json(const AppendixC& c, const ItemCosts& own) {
    Json json;
    json["polygons"] = c.polygons();
    json["vertices"] = c.vertex_count();
    json["edges"] = c.edges;
    json["digested"] = c.digested;
    json["segments"] = c.segments();
    json["charged_segments"] = c.charged_segments();
    json["pixels"] = c.pixels();
    json["drawn"] = c.drawn;
    Json cycles;
    for (std::size_t i = 0; i < kSectionNames.size(); ++i) {
        cycles[std::string(kSectionNames[i])] = c.cycles[i];
    }
    json["cycles_u"] = std::move(cycles);
    json["scene_u"] = c.scene_cycles();
    json["formula_u"] = formula_cycles(c);
    json["formula_error"] = error_of(formula_cycles(c), c);
    json["own_formula_u"] = predicted_cycles(c, own);
    json["own_formula_error"] = error_of(predicted_cycles(c, own), c);
    json["own_costs_u"] = costs_json(own_costs(c));
    if (const auto costs = c.pixel_fit.solve()) {
        json["pixel_costs_u"] = {
            {"run", costs->run}, {"drawn", costs->drawn}, {"hidden", costs->hidden}};
    }
    json["v"] = distribution_json(c.vertices);
    json["y"] = distribution_json(c.heights);
    json["l"] = distribution_json(c.lengths);
    json["D"] = distribution_json(c.depth);
    json["area"] = distribution_json(c.areas);
    return json;
}

void add_row(std::string& text, const AppendixCNode& node, std::size_t frame,
             const ItemCosts& own) {
    const AppendixC& c = node.frames[frame];
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "{},{},{},{},{},{},{},{},{},{},{}", frame, node.node, node.name,
                   c.polygons(), c.vertex_count(), c.edges, c.digested, c.segments(),
                   c.charged_segments(), c.pixels(), c.drawn);
    for (const std::int64_t cycles : c.cycles) {
        fmt::format_to(out, ",{}", cycles);
    }
    fmt::format_to(out, ",{},{:.1f},{:.6f},{:.1f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n",
                   c.scene_cycles(), formula_cycles(c), error_of(formula_cycles(c), c),
                   predicted_cycles(c, own), error_of(predicted_cycles(c, own), c),
                   c.heights.mean(), c.lengths.mean(), c.depth.mean(), c.areas.mean());
}

}  // namespace

std::string appendix_c_json(const AppendixCReport& report) {
    Json json;
    json["machine"] = report.machine;
    json["frames"] = report.frames;
    json["thesis_costs_u"] = costs_json(kThesisCosts);
    const AppendixC all = report.all();
    const ItemCosts own = own_costs(all);
    Json nodes = Json::array();
    for (const AppendixCNode& node : report.nodes) {
        Json frames = Json::array();
        for (const AppendixC& frame : node.frames) {
            frames.push_back(statistics_json(frame, own));
        }
        nodes.push_back({{"node", node.node},
                         {"name", node.name},
                         {"all_frames", statistics_json(node.all(), own)},
                         {"frames", std::move(frames)}});
    }
    json["all_nodes"] = statistics_json(all, own);
    json["nodes"] = std::move(nodes);
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string appendix_c_csv(const AppendixCReport& report) {
    std::string text =
        "frame,node,name,polygons,vertices,edges,digested,segments,charged_segments,pixels,drawn";
    for (const std::string_view section : kSectionNames) {
        text += fmt::format(",{}_u", section);
    }
    text +=
        ",scene_u,formula_u,formula_error,own_formula_u,own_formula_error,mean_height,mean_length,"
        "mean_depth,mean_area\n";
    const ItemCosts own = own_costs(report.all());
    for (const AppendixCNode& node : report.nodes) {
        for (std::size_t frame = 0; frame < node.frames.size(); ++frame) {
            add_row(text, node, frame, own);
        }
    }
    return text;
}

}  // namespace rasterloom::observe
