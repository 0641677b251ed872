// SPDX-License-Identifier: MIT
#include "topologies/export.hpp"

#include "topologies/geodesic.hpp"
#include "topologies/graph_file.hpp"
#include "topologies/regular.hpp"

#include <sstream>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <gtest/gtest.h>

namespace rasterloom::topology {
namespace {

using boost::property_tree::ptree;

// How many elements of an SVG are drawn with this name; fails when it is not well-formed XML.
std::size_t count_elements(const std::string& svg, const std::string& element) {
    std::istringstream in(svg);
    ptree tree;
    boost::property_tree::read_xml(in, tree);
    std::size_t count = 0;
    for (const auto& [name, content] : tree.get_child("svg")) {
        count += name == element ? 1 : 0;
    }
    return count;
}

TEST(Csv, HasARowForEachNode) {
    std::ostringstream out;
    write_nodes_csv(out, ring(4));
    EXPECT_EQ(out.str(),
              "node,name,phi_degrees,theta_degrees,x,y,z,ports\n"
              "0,R0,0.000000,90.000000,1.000000000,0.000000000,0.000000000,2\n"
              "1,R1,90.000000,90.000000,0.000000000,1.000000000,0.000000000,2\n"
              "2,R2,180.000000,90.000000,-1.000000000,0.000000000,0.000000000,2\n"
              "3,R3,270.000000,90.000000,0.000000000,-1.000000000,0.000000000,2\n");
}

TEST(Csv, HasARowForEachLinkWithThePortsAtBothEnds) {
    std::ostringstream out;
    write_links_csv(out, ring(3));
    EXPECT_EQ(out.str(), "link,node_a,port_a,node_b,port_b\n0,0,0,1,1\n1,0,1,2,0\n2,1,0,2,1\n");
}

TEST(Csv, QuotesNamesThatHoldCommasOrQuotes) {
    std::istringstream in("a,\"b c\n");
    std::ostringstream out;
    write_nodes_csv(out, read_edge_list(in, "g"));
    EXPECT_NE(out.str().find("0,\"a,\"\"b\",0.000000"), std::string::npos) << out.str();
}

TEST(Svg, OfAGeodesicShowsEveryNodeOnAHemisphereOrOnBoth) {
    const Topology t = geodesic(4, 4);
    std::size_t on_rim = 0;
    for (const Node& node : t.nodes) {
        on_rim += std::abs(node.direction.x) <= 1e-9 ? 1 : 0;
    }
    std::ostringstream out;
    write_svg(out, t);
    EXPECT_EQ(count_elements(out.str(), "circle"), 2 + t.nodes.size() + on_rim);
}

TEST(Svg, OfOtherGraphsShowsEachNodeAndLinkOnceAndEscapesNames) {
    std::ostringstream ring_svg;
    write_svg(ring_svg, ring(12));
    EXPECT_EQ(count_elements(ring_svg.str(), "circle"), 12U);
    EXPECT_EQ(count_elements(ring_svg.str(), "path"), 12U);
    std::ostringstream torus_svg;
    write_svg(torus_svg, torus(6, 5));
    EXPECT_EQ(count_elements(torus_svg.str(), "path"), 60U);
    std::istringstream in("<a&b> c\n");
    std::ostringstream named;
    write_svg(named, read_edge_list(in, "g"));
    EXPECT_NE(named.str().find("<title>&lt;a&amp;b&gt;</title>"), std::string::npos);
}

TEST(Svg, OfAScreenMapDrawsTheBordersOfItsRegions) {
    const Topology t = grid(2, 1);
    std::ostringstream out;
    write_screen_map_svg(out, t, nearest_pixel_map(t, 8, 4));
    EXPECT_EQ(count_elements(out.str(), "path"), 5U);  // the frame and the border in the middle
    EXPECT_EQ(count_elements(out.str(), "circle"), 2U);
}

}  // namespace
}  // namespace rasterloom::topology
