// SPDX-License-Identifier: MIT
#include "topologies/registry.hpp"

#include "topologies/geodesic.hpp"
#include "topologies/graph_file.hpp"
#include "topologies/nearest_name.hpp"
#include "topologies/regular.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::topology {

namespace {

constexpr int kMostRasterizers = 4096;

int whole_number(const Parameters& parameters, const std::string& name) {
    const std::string& text = parameters.at(name);
    int value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) {
        throw TopologyError(name, fmt::format("{} is '{}'; expected a whole number", name, text));
    }
    return value;
}

std::vector<std::string> names_of(const std::vector<ParameterInfo>& parameters) {
    std::vector<std::string> names;
    for (const ParameterInfo& p : parameters) {
        names.push_back(p.name);
    }
    return names;
}

// The given parameters, checked against the kind's list, with its defaults.
Parameters complete(const TopologyKind& kind, Parameters given) {
    const std::vector<std::string> names = names_of(kind.parameters);
    for (const auto& [name, value] : given) {
        if (names.empty()) {
            throw TopologyError(
                name,
                fmt::format("topology '{}' has no parameter '{}'; expected none", kind.name, name));
        }
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            throw TopologyError(
                name, fmt::format("topology '{}' has no parameter '{}'; did you mean '{}'?",
                                  kind.name, name, nearest_name(name, names)));
        }
    }
    for (const ParameterInfo& p : kind.parameters) {
        if (given.count(p.name) > 0) {
            continue;
        }
        if (!p.fallback) {
            throw TopologyError(p.name,
                                fmt::format("topology '{}' lacks its parameter '{}'; expected {}",
                                            kind.name, p.name, p.summary));
        }
        given[p.name] = *p.fallback;
    }
    return given;
}

Topology make_grid(Topology (*make)(int, int), const Parameters& p) {
    return make(whole_number(p, "width"), whole_number(p, "height"));
}

Topology make_tiling(const std::string& kind, const Tiling& tiling) {
    check_tiling(tiling);
    Topology t;
    t.kind = kind;
    t.tiling = tiling;
    t.nodes.resize(static_cast<std::size_t>(tiling.processors()));
    for (std::size_t node = 0; node < t.nodes.size(); ++node) {
        t.nodes[node].name = fmt::format("P{}", node);
    }
    t.ports.resize(t.nodes.size());
    return t;
}

Topology make_bucket_tiler(TileSize tile, int rasterizers) {
    if (rasterizers < 1 || rasterizers > kMostRasterizers) {
        throw TopologyError("rasterizers", fmt::format("rasterizers is {}; expected 1 to {}",
                                                       rasterizers, kMostRasterizers));
    }
    Topology t;
    t.kind = "bucket_tiles";
    t.tile = tile;
    t.nodes.resize(static_cast<std::size_t>(rasterizers));
    const std::size_t digits = std::to_string(rasterizers - 1).size();
    for (std::size_t node = 0; node < t.nodes.size(); ++node) {
        t.nodes[node].name = fmt::format("R{:0{}}", node, digits);  // in alphabetical order, too
    }
    t.ports.resize(t.nodes.size());
    return t;
}

// Chen and others 1998.
TopologyKind bucket_tiler_kind() {
    return {"bucket_tiles",
            "a tile sorter hands the triangles of each tile of the screen to rasterizers, tile by "
            "tile",
            {{"tile", "pixels of a tile, such as 8, or 32x16", std::nullopt},
             {"rasterizers", "how many, at least 1", "1"}},
            [](const Parameters& p) {
                try {
                    return make_bucket_tiler(parse_tile_size(p.at("tile")),
                                             whole_number(p, "rasterizers"));
                } catch (const TopologyError&) {
                    throw;
                } catch (const std::invalid_argument& problem) {
                    throw TopologyError("tile", fmt::format("tile is {}", problem.what()));
                }
            }};
}

// Parks' machines (Parks 1982, chapter 3).
std::vector<TopologyKind> tiling_kinds() {
    const auto sides = [](const char* columns, const char* rows) {
        return std::vector<ParameterInfo>{{"columns", columns, std::nullopt},
                                          {"rows", rows, std::nullopt}};
    };
    std::vector<ParameterInfo> hybrid = sides("parts side by side", "parts one above the other");
    hybrid.push_back({"interlace_columns", "processors that share a part's lines", std::nullopt});
    hybrid.push_back({"interlace_rows", "processors that share its columns", std::nullopt});
    return {
        {"hybrid",
         "a tree of polygon splitters whose leaves are groups of processors that share a part of "
         "the screen pixel by pixel",
         hybrid,
         [](const Parameters& p) {
             return make_tiling("hybrid", {whole_number(p, "columns"), whole_number(p, "rows"),
                                           whole_number(p, "interlace_columns"),
                                           whole_number(p, "interlace_rows")});
         }},
        {"interlace",
         "every polygon to all processors; pixel (x, y) belongs to (x mod columns, y mod rows)",
         sides("processors that share a line", "processors that share a column"),
         [](const Parameters& p) {
             return make_tiling("interlace",
                                {1, 1, whole_number(p, "columns"), whole_number(p, "rows")});
         }},
        {"splitter_tree",
         "a binary tree of polygon splitters, a processor and a block of the screen at each leaf",
         sides("blocks side by side", "blocks one above the other"),
         [](const Parameters& p) {
             return make_tiling("splitter_tree",
                                {whole_number(p, "columns"), whole_number(p, "rows"), 1, 1});
         }},
        {"uniprocessor",
         "one processor that draws all polygons",
         {},
         [](const Parameters&) { return make_tiling("uniprocessor", {}); }},
    };
}

}  // namespace

std::vector<TopologyKind> topology_kinds() {
    const std::vector<ParameterInfo> file{{"file", "path of the file", std::nullopt}};
    const std::vector<ParameterInfo> sides{{"width", "nodes in a row", std::nullopt},
                                           {"height", "number of rows", std::nullopt}};
    std::vector<TopologyKind> kinds{
        {"edge_list", "graph from a text file, one link 'a b' a line", file,
         [](const Parameters& p) { return edge_list_file(p.at("file")); }},
        {"geodesic",
         "icosahedron subdivided by the Caspar-Klug pair (b, c): 10 (b^2 + bc + c^2) + 2 nodes on "
         "a sphere",
         {{"b", "steps straight ahead from corner to corner", "4"},
          {"c", "steps after a turn of 60 degrees", "4"}},
         [](const Parameters& p) { return geodesic(whole_number(p, "b"), whole_number(p, "c")); }},
        {"graphml", "graph from a GraphML file", file,
         [](const Parameters& p) { return graphml_file(p.at("file")); }},
        {"grid", "width x height nodes with links right, up, left, down", sides,
         [](const Parameters& p) { return make_grid(grid, p); }},
        {"ring",
         "nodes in a circle",
         {{"nodes", "how many, at least 2", std::nullopt}},
         [](const Parameters& p) { return ring(whole_number(p, "nodes")); }},
        {"single", "one node without links", {}, [](const Parameters&) { return single(); }},
        {"torus", "a grid whose opposite sides are joined", sides,
         [](const Parameters& p) { return make_grid(torus, p); }},
    };
    for (TopologyKind& kind : tiling_kinds()) {
        kinds.push_back(std::move(kind));
    }
    kinds.push_back(bucket_tiler_kind());
    std::sort(kinds.begin(), kinds.end(),
              [](const TopologyKind& a, const TopologyKind& b) { return a.name < b.name; });
    return kinds;
}

Topology make_topology(const std::string& kind, const Parameters& parameters) {
    std::vector<std::string> names;
    for (const TopologyKind& row : topology_kinds()) {
        names.push_back(row.name);
        if (row.name != kind) {
            continue;
        }
        const Parameters all = complete(row, parameters);
        try {
            return row.make(all);
        } catch (const TopologyError&) {
            throw;
        } catch (const std::invalid_argument& error) {
            throw TopologyError("", error.what());
        }
    }
    throw TopologyError(
        "", fmt::format("there is no topology '{}'; did you mean '{}'? (expected one of {})", kind,
                        nearest_name(kind, names), fmt::join(names, ", ")));
}

}  // namespace rasterloom::topology
