// SPDX-License-Identifier: MIT
#include "topologies/tiling.hpp"

#include "topologies/registry.hpp"
#include "topologies/tiling_export.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom::topology {
namespace {

using Cut = Distribution::Cut;
using Broadcast = Distribution::Broadcast;
using Leaf = Distribution::Leaf;
using testing::HasSubstr;

// The processors that a polygon's point at (x, y) reaches from element 0 on.
std::vector<NodeIndex> reached(const Distribution& d, int x, int y) {
    std::size_t at = 0;
    while (const auto* cut = std::get_if<Cut>(&d.elements[at].what)) {
        at = (cut->axis == CutAxis::x ? x : y) < cut->line ? cut->low : cut->high;
    }
    if (const auto* bus = std::get_if<Broadcast>(&d.elements[at].what)) {
        return bus->processors;
    }
    return {std::get<Leaf>(d.elements[at].what).processor};
}

bool owns(const PixelGrid& g, int x, int y) {
    const int i = x - g.x_start;
    const int j = y - g.y_start;
    return i >= 0 && j >= 0 && i % g.x_step == 0 && j % g.y_step == 0 && i / g.x_step < g.columns &&
           j / g.y_step < g.rows;
}

RC_GTEST_PROP(Tiling, GivesEveryPixelToOneProcessorWhichItsPolygonsReach, ()) {
    const auto side = [] { return *rc::gen::inRange(1, 7); };
    const Tiling t{side(), side(), *rc::gen::inRange(1, 5), *rc::gen::inRange(1, 5)};
    const int width = t.columns * t.interlace_columns * *rc::gen::inRange(1, 4);
    const int height = t.rows * t.interlace_rows * *rc::gen::inRange(1, 4);
    const Distribution d = distribute(t, width, height);
    RC_ASSERT(d.grids.size() == static_cast<std::size_t>(t.processors()));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto owners = std::count_if(d.grids.begin(), d.grids.end(),
                                              [&](const auto& g) { return owns(g, x, y); });
            RC_ASSERT(owners == 1);
            const std::vector<NodeIndex> there = reached(d, x, y);
            const auto of_there = std::count_if(
                there.begin(), there.end(), [&](NodeIndex n) { return owns(d.grids[n], x, y); });
            RC_ASSERT(of_there == 1);
            RC_ASSERT(there.size() == static_cast<std::size_t>(t.interlaced()));
        }
    }
}

RC_GTEST_PROP(Tiling, HasOneWayFromTheHostToEveryElement, ()) {
    const Tiling t{*rc::gen::inRange(1, 17), *rc::gen::inRange(1, 17), *rc::gen::inRange(1, 4), 1};
    const Distribution d = distribute(t, t.columns * t.interlace_columns * 4, t.rows * 4);
    std::multiset<std::size_t> fed{0};
    std::set<std::string> names;
    for (std::size_t element = 0; element < d.elements.size(); ++element) {
        names.insert(d.elements[element].name);
        if (const auto* cut = std::get_if<Cut>(&d.elements[element].what)) {
            RC_ASSERT(cut->low > element && cut->high > element);  // no way leads back
            fed.insert(cut->low);
            fed.insert(cut->high);
        }
    }
    RC_ASSERT(names.size() == d.elements.size());
    RC_ASSERT(fed.size() == d.elements.size());
    RC_ASSERT(std::set<std::size_t>(fed.begin(), fed.end()).size() == d.elements.size());
}

TEST(Tiling, CutsBothWaysByTurnsAsTheThesisDoes) {
    const Distribution d = distribute({4, 4, 1, 1}, 512, 512);
    const auto cut = [&d](std::size_t element) { return std::get<Cut>(d.elements[element].what); };
    EXPECT_EQ(d.elements.size(), 15U + 16U);
    EXPECT_EQ(tree_depth(d), 4);
    EXPECT_EQ(cut(0).axis, CutAxis::x);
    EXPECT_EQ(cut(0).line, 256);
    EXPECT_EQ(cut(1).axis, CutAxis::y);
    EXPECT_EQ(cut(2).axis, CutAxis::y);
    EXPECT_EQ(cut(2).line, 256);
    EXPECT_EQ(cut(3).axis, CutAxis::x);
    EXPECT_EQ(cut(3).line, 128);
    EXPECT_EQ(d.elements[0].name, "splitter/0");
    EXPECT_EQ(d.elements[15].name, "node/P0");
    EXPECT_THAT(reached(d, 511, 0), testing::ElementsAre(3));  // lower right
    EXPECT_THAT(reached(d, 511, 511), testing::ElementsAre(15));
}

// Parks 1982, figure 15: in the machines of four and sixteen processors the shuttle's polygons, at
// x from 384 and y from 207 to 300, belong to processors 1 and 3, and to 7 and 11.
TEST(Tiling, NumbersSplitterProcessorsAsTheThesisDoes) {
    EXPECT_THAT(reached(distribute({2, 2, 1, 1}, 512, 512), 400, 210), testing::ElementsAre(1));
    EXPECT_THAT(reached(distribute({4, 4, 1, 1}, 512, 512), 400, 210), testing::ElementsAre(7));
    EXPECT_THAT(reached(distribute({4, 4, 1, 1}, 512, 512), 400, 300), testing::ElementsAre(11));
}

TEST(Tiling, NumbersInterlacedProcessorsAlongTheLineFirst) {
    const Distribution d = distribute({1, 1, 4, 2}, 16, 8);
    ASSERT_EQ(d.elements.size(), 1U);
    EXPECT_EQ(d.elements[0].name, "bus/0");
    EXPECT_EQ(d.grids[6].x_start, 2);
    EXPECT_EQ(d.grids[6].y_start, 1);
    EXPECT_EQ(d.grids[6].x_step, 4);
    EXPECT_EQ(d.grids[6].y_step, 2);
    EXPECT_EQ(d.grids[6].columns, 4);
    EXPECT_EQ(d.grids[6].rows, 4);
}

TEST(Tiling, PutsABusAtEveryLeafOfAHybrid) {
    const Distribution d = distribute({2, 2, 2, 2}, 512, 512);
    ASSERT_EQ(d.elements.size(), 3U + 4U);
    EXPECT_EQ(d.elements[4].name, "bus/1");
    EXPECT_EQ(std::get<Broadcast>(d.elements[4].what).processors,
              (std::vector<NodeIndex>{4, 5, 6, 7}));
    EXPECT_EQ(d.grids[5].x_start, 257);  // lower right quadrant
    EXPECT_EQ(d.grids[5].y_start, 0);
    EXPECT_EQ(d.grids[5].columns, 128);
}

TEST(Tiling, OfOneProcessorIsALeaf) {
    const Distribution d = distribute({}, 512, 512);
    ASSERT_EQ(d.elements.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<Leaf>(d.elements[0].what));
    EXPECT_EQ(tree_depth(d), 0);
}

TEST(Tiling, NeedsAScreenThatCanBeDealtOutEvenly) {
    try {
        distribute({2, 3, 1, 2}, 512, 512);
        FAIL();
    } catch (const TilingError& error) {
        EXPECT_EQ(error.axis(), CutAxis::y);
        EXPECT_STREQ(error.what(),
                     "6 rows of processors (3 x 2) cannot share the screen's height of 512 pixels "
                     "evenly; one of 1, 2, 4, 8, 16, 32, 64, 128, 256, 512 can");
    }
    EXPECT_THROW(distribute({1024, 1, 1, 1}, 512, 512), TilingError);
    EXPECT_THROW(distribute({1, 1, 3, 1}, 512, 512), TilingError);
}

TEST(Tiling, RefusesNumbersOutOfRange) {
    EXPECT_THROW(distribute({0, 1, 1, 1}, 8, 8), std::invalid_argument);
    EXPECT_THROW(distribute({1, 1, 1, -2}, 8, 8), std::invalid_argument);
    EXPECT_THROW(check_tiling({4096, 4096, 1, 1}), std::invalid_argument);
    try {
        make_topology("interlace", {{"columns", "4"}, {"rows", "0"}});
        FAIL();
    } catch (const TopologyError& error) {
        EXPECT_THAT(error.what(), HasSubstr("rows = 0: expected 1 to 4096"));
    }
}

TEST(TilingKinds, AreOneFamily) {
    const auto tiling = [](const char* kind, const Parameters& parameters) {
        return make_topology(kind, parameters).tiling.value();
    };
    const Parameters sides{{"columns", "4"}, {"rows", "2"}};
    EXPECT_EQ(tiling("uniprocessor", {}).processors(), 1);
    EXPECT_EQ(tiling("splitter_tree", sides).parts(), 8);
    EXPECT_EQ(tiling("interlace", sides).interlace_columns, 4);
    EXPECT_EQ(tiling("interlace", sides).parts(), 1);
    const Topology hybrid = make_topology(
        "hybrid",
        {{"columns", "2"}, {"rows", "2"}, {"interlace_columns", "2"}, {"interlace_rows", "3"}});
    EXPECT_EQ(hybrid.nodes.size(), 24U);
    EXPECT_EQ(hybrid.nodes[23].name, "P23");
    EXPECT_TRUE(hybrid.ports[23].empty());
    EXPECT_FALSE(make_topology("single", {}).tiling.has_value());
}

TEST(TilingCsv, HasARowForEachProcessorAndElement) {
    const Distribution d = distribute({2, 1, 1, 2}, 8, 4);
    std::ostringstream grids;
    write_grids_csv(grids, d);
    EXPECT_EQ(grids.str(),
              "node,name,x_start,y_start,x_step,y_step,columns,rows\n"
              "0,P0,0,0,1,2,4,2\n1,P1,0,1,1,2,4,2\n2,P2,4,0,1,2,4,2\n3,P3,4,1,1,2,4,2\n");
    std::ostringstream elements;
    write_elements_csv(elements, d);
    EXPECT_EQ(elements.str(),
              "element,name,kind,axis,line,low,high,first_processor,processors\n"
              "0,splitter/0,splitter,x,4,1,2,,\n1,bus/0,bus,,,,,0,2\n2,bus/1,bus,,,,,2,2\n");
}

std::size_t count_elements(const std::string& svg, const std::string& element) {
    std::istringstream in(svg);
    boost::property_tree::ptree tree;
    boost::property_tree::read_xml(in, tree);
    return tree.get_child("svg").count(element);
}

TEST(TilingSvg, DrawsPartsCutsAndAPeriodOfTheInterlace) {
    std::ostringstream hybrid;
    const Tiling t{2, 2, 2, 2};
    write_tiling_svg(hybrid, t, distribute(t, 512, 512));
    EXPECT_EQ(count_elements(hybrid.str(), "pattern"), 4U);
    EXPECT_EQ(count_elements(hybrid.str(), "rect"), 1U + 4U + 4U);  // paper, parts, lens
    EXPECT_EQ(count_elements(hybrid.str(), "line"), 3U);
    std::ostringstream one;
    write_tiling_svg(one, {}, distribute({}, 512, 512));
    EXPECT_EQ(count_elements(one.str(), "rect"), 2U);
}

}  // namespace
}  // namespace rasterloom::topology
