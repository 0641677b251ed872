// SPDX-License-Identifier: MIT
// Damaged graph files are read or refused, in one line that names the file; never anything else.
#include "tests/damage.hpp"
#include "topologies/graph_file.hpp"

#include <cstdlib>
#include <random>
#include <sstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace rasterloom::topology {
namespace {

constexpr std::string_view kEdgeList = "# a graph\na 30.5 122\nb 0 90\na b\nb c # end\n3 c\n";
constexpr std::string_view kGraphml =
    "<?xml version='1.0'?>\n<graphml><key id='p' for='node' attr.name='phi'/>\n"
    "<key id='t' for='node' attr.name='theta'/>\n<graph edgedefault='undirected'>\n"
    "<node id='a'><data key='p'>30</data><data key='t'>60</data></node>\n<node id='b'/>\n"
    "<edge source='a' target='b'/></graph></graphml>\n";

template <typename Read>
void refuse_or_read(Read read, std::string_view whole) {
    const int rounds = std::getenv("RASTERLOOM_LONG_TESTS") != nullptr ? 200'000 : 3'000;
    std::mt19937 random(1);
    int refused = 0;
    for (int round = 0; round < rounds; ++round) {
        const std::string text = damaged(whole, random);
        std::istringstream in(text);
        try {
            const Topology graph = read(in, "g");
            ASSERT_FALSE(graph.nodes.empty()) << text;
            ASSERT_EQ(graph.ports.size(), graph.nodes.size()) << text;
        } catch (const GraphFileError& error) {
            ++refused;
            ASSERT_TRUE(std::string_view(error.what()).starts_with("g:")) << text;
        }
    }
    EXPECT_GT(refused, rounds / 20);
    EXPECT_LT(refused, rounds);
}

TEST(DamagedGraphFile, IsReadOrRefusedAsAnEdgeList) {
    refuse_or_read(read_edge_list, kEdgeList);
}

TEST(DamagedGraphFile, IsReadOrRefusedAsGraphml) {
    refuse_or_read(read_graphml, kGraphml);
}

}  // namespace
}  // namespace rasterloom::topology
