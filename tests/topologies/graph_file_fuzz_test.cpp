// SPDX-License-Identifier: MIT
// Damaged graph files are read or refused, in one line that names the file; never anything else.
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

// A few bytes replaced, removed, inserted or repeated.
std::string damaged(std::string_view whole, std::mt19937& random) {
    std::string text(whole);
    const auto below = [&random](std::size_t n) { return n == 0 ? 0 : random() % n; };
    for (auto times = 1 + below(4); times > 0; --times) {
        const auto at = below(text.size());
        switch (below(4)) {
            case 0:
                text[at] = static_cast<char>(below(256));
                break;
            case 1:
                text.erase(at, 1 + below(20));
                break;
            case 2:
                text.insert(at, 1, static_cast<char>(below(256)));
                break;
            default:
                text.insert(at, text.substr(below(text.size()), below(30)));
        }
        if (text.empty())
            return text;
    }
    return text;
}

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
