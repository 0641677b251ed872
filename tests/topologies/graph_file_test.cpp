// SPDX-License-Identifier: MIT
#include "topologies/graph_file.hpp"

#include <sstream>

#include <gmock/gmock.h>

namespace rasterloom::topology {
namespace {

using ::testing::ElementsAre;

Topology edge_list(const std::string& text) {
    std::istringstream in(text);
    return read_edge_list(in, "g.txt");
}

Topology graphml(const std::string& text) {
    std::istringstream in(text);
    return read_graphml(in, "g.xml");
}

template <typename Read>
std::string error_of(Read read, const std::string& text) {
    try {
        read(text);
    } catch (const GraphFileError& error) {
        return error.what();
    }
    return "no error";
}

TEST(EdgeList, NumbersNodesInOrderOfAppearanceAndPortsInOrderOfLinks) {
    const Topology t =
        edge_list("# three in a row and one alone\nleft middle\n\n middle right # end\nalone\n");
    EXPECT_EQ(t.nodes.size(), 4U);
    EXPECT_EQ(t.nodes[1].name, "middle");
    EXPECT_THAT(t.ports[1], ElementsAre(0, 2));
    EXPECT_TRUE(t.ports[3].empty());
    EXPECT_EQ(t.kind, "edge_list");
}

TEST(EdgeList, TakesNumbersAsNumbersWhenTheyAreExactlyZeroToTheLast) {
    const Topology t = edge_list("2 0\n0 1\n");
    EXPECT_EQ(t.nodes[2].name, "2");
    EXPECT_THAT(t.ports[0], ElementsAre(2, 1));
    EXPECT_EQ(edge_list("5 0\n0 1\n").nodes[0].name, "5");
}

TEST(EdgeList, TakesPlaces) {
    const Topology t = edge_list("a 90 90\nb 360 45\na b\n");
    EXPECT_EQ(t.nodes[0].phi, 90);
    EXPECT_EQ(t.nodes[0].direction.y, 1);
    EXPECT_EQ(t.nodes[1].phi, 0);
}

TEST(EdgeList, ReportsFileLineValueAndWhatWasExpected) {
    EXPECT_EQ(error_of(edge_list, "a b\nb a\n"),
              "g.txt:2: nodes 'b' and 'a' are linked already; expected each link once");
    EXPECT_EQ(error_of(edge_list, "a a\n"),
              "g.txt:1: node 'a' is linked to itself; expected two different nodes");
    EXPECT_EQ(error_of(edge_list, "\n\na b c d\n"),
              "g.txt:3: 4 fields; expected 'node node', 'node' or 'node phi theta'");
    EXPECT_EQ(error_of(edge_list, "a 12 181\n"),
              "g.txt:1: theta is '181'; expected a number of degrees from 0 to 180");
    EXPECT_EQ(error_of(edge_list, "a 1x 8\n"),
              "g.txt:1: phi is '1x'; expected a number of degrees from 0 to 360");
    EXPECT_EQ(error_of(edge_list, "a nan 8\n"),
              "g.txt:1: phi is 'nan'; expected a number of degrees from 0 to 360");
    EXPECT_EQ(error_of(edge_list, "# nothing\n"), "g.txt: no node; expected at least one");
}

TEST(EdgeList, ReportsAFileThatIsNotThere) {
    EXPECT_EQ(error_of(edge_list_file, "/nonexistent/graph"),
              "/nonexistent/graph: cannot be opened; expected a readable file");
}

constexpr const char* kTriangle = R"(<?xml version="1.0"?>
<!-- <edge source="x" target="y"/> -->
<graphml xmlns="http://graphml.graphdrawing.org/xmlns">
  <key id="d0" for="node" attr.name="phi" attr.type="double"/>
  <key id="d1" for="node" attr.name="theta" attr.type="double"/>
  <graph edgedefault="DIRECTION">
    <node id="n0"><data key="d0">90</data><data key="d1">90</data></node>
    <node id="n1"/>
    <node id="n2"/>
    <edge source="n0" target="n1"/>
    <edge source="n2" target="n1"/>
    EXTRA
  </graph>
</graphml>
)";

std::string triangle(const std::string& direction, const std::string& extra) {
    std::string text = kTriangle;
    text.replace(text.find("DIRECTION"), 9, direction);
    text.replace(text.find("EXTRA"), 5, extra);
    return text;
}

TEST(Graphml, GivesNodesLinksAndPlaces) {
    const Topology t = graphml(triangle("undirected", "<edge source=\"n0\" target=\"n2\"/>"));
    EXPECT_EQ(t.nodes[2].name, "n2");
    EXPECT_THAT(t.ports[1], ElementsAre(0, 2));
    EXPECT_THAT(t.ports[2], ElementsAre(1, 0));
    EXPECT_EQ(t.nodes[0].phi, 90);
    EXPECT_EQ(t.nodes[0].direction.y, 1);
    EXPECT_EQ(t.nodes[1].direction.y, 0);
}

TEST(Graphml, MergesTheTwoDirectionsOfADirectedEdge) {
    const Topology t = graphml(triangle("directed", "<edge source=\"n1\" target=\"n0\"/>"));
    EXPECT_THAT(t.ports[0], ElementsAre(1));
}

TEST(Graphml, ReportsFileLineValueAndWhatWasExpected) {
    EXPECT_EQ(error_of(graphml, triangle("undirected", "<edge source=\"n0\" target=\"n9\"/>")),
              "g.xml:12: target is 'n9'; expected the id of a node");
    EXPECT_EQ(error_of(graphml, triangle("undirected", "<edge source=\"n1\" target=\"n0\"/>")),
              "g.xml:12: nodes 'n1' and 'n0' are linked already; expected each link once");
    EXPECT_EQ(error_of(graphml, triangle("undirected", "<edge source=\"n1\"/>")),
              "g.xml:12: attribute 'target' is missing");
    EXPECT_EQ(error_of(graphml, triangle("undirected", "<node id=\"n1\"/>")),
              "g.xml:12: node 'n1' is there already; expected each node once");
    EXPECT_EQ(error_of(graphml, "<graphml/>"), "g.xml: no <graph> in <graphml>; expected GraphML");
    EXPECT_THAT(error_of(graphml, "<graphml>\n<graph>\n</graphml>"),
                ::testing::StartsWith("g.xml:3: "));
    EXPECT_THAT(error_of(graphml, ""), ::testing::StartsWith("g.xml"));
}

}  // namespace
}  // namespace rasterloom::topology
