// SPDX-License-Identifier: MIT
#include "topologies/registry.hpp"

#include "tests/temporary_folder.hpp"
#include "topologies/nearest_name.hpp"

#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>

namespace rasterloom::topology {
namespace {

using ::testing::StartsWith;

std::string error_of(const std::string& kind, const Parameters& parameters,
                     const std::string& expected_key = "") {
    try {
        make_topology(kind, parameters);
    } catch (const TopologyError& error) {
        EXPECT_EQ(error.parameter(), expected_key);
        return error.what();
    }
    return "no error";
}

TEST(TopologyRegistry, MakesEveryKindItLists) {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "graph.txt").string();
    std::ofstream(path) << "<graphml><graph><node id='a'/></graph></graphml>";
    for (const TopologyKind& kind : topology_kinds()) {
        Parameters parameters;
        for (const ParameterInfo& p : kind.parameters) {
            parameters[p.name] = p.name == "file" ? path : "3";
        }
        if (kind.name != "edge_list") {
            EXPECT_EQ(make_topology(kind.name, parameters).kind, kind.name);
        }
    }
    std::ofstream(path) << "a b\n";
    EXPECT_EQ(make_topology("edge_list", {{"file", path}}).nodes.size(), 2U);
}

TEST(TopologyRegistry, ListsKindsInAlphabeticalOrderWithSummaries) {
    const auto kinds = topology_kinds();
    EXPECT_TRUE(std::is_sorted(kinds.begin(), kinds.end(),
                               [](const auto& a, const auto& b) { return a.name < b.name; }));
    for (const TopologyKind& kind : kinds) {
        EXPECT_FALSE(kind.summary.empty());
    }
}

TEST(TopologyRegistry, TakesStrothottesMachineAsTheDefaultGeodesic) {
    EXPECT_EQ(make_topology("geodesic", {}).nodes.size(), 482U);
}

TEST(TopologyRegistry, NamesTheNearestKindOrParameterForAWrongOne) {
    EXPECT_THAT(error_of("geodesik", {}),
                StartsWith("there is no topology 'geodesik'; did you mean 'geodesic'?"));
    EXPECT_EQ(error_of("torus", {{"widht", "3"}}, "widht"),
              "topology 'torus' has no parameter 'widht'; did you mean 'width'?");
    EXPECT_EQ(error_of("single", {{"n", "3"}}, "n"),
              "topology 'single' has no parameter 'n'; expected none");
}

TEST(TopologyRegistry, ReportsMissingMalformedAndOutOfRangeValues) {
    EXPECT_EQ(error_of("ring", {}, "nodes"),
              "topology 'ring' lacks its parameter 'nodes'; expected how many, at least 2");
    EXPECT_EQ(error_of("ring", {{"nodes", "6.5"}}, "nodes"),
              "nodes is '6.5'; expected a whole number");
    EXPECT_EQ(error_of("ring", {{"nodes", "1"}}), "ring: nodes = 1: expected 2 to 1048576");
    EXPECT_EQ(error_of("geodesic", {{"b", "0"}, {"c", "0"}}),
              "geodesic: b = 0, c = 0: expected 0 to 200 each, not both 0");
}

TEST(NearestName, IsTheOneWithTheFewestChanges) {
    EXPECT_EQ(nearest_name("rnig", {"grid", "ring", "torus"}), "ring");
    EXPECT_EQ(nearest_name("", {"aa", "b"}), "b");
    EXPECT_EQ(nearest_name("x", {}), "");
}

}  // namespace
}  // namespace rasterloom::topology
