// SPDX-License-Identifier: MIT
#include "machine/observe/appendix_c/appendix_c.hpp"

namespace rasterloom::observe {

namespace {

double per(std::int64_t cycles, std::int64_t items) {
    return items == 0 ? 0 : static_cast<double>(cycles) / static_cast<double>(items);
}

}  // namespace

void AppendixC::add(const AppendixC& other) {
    vertices.add(other.vertices);
    heights.add(other.heights);
    lengths.add(other.lengths);
    depth.add(other.depth);
    areas.add(other.areas);
    digested += other.digested;
    edges += other.edges;
    drawn += other.drawn;
    for (std::size_t i = 0; i < cycles.size(); ++i) {
        cycles[i] += other.cycles[i];
    }
    pixel_fit.add(other.pixel_fit);
}

double formula_cycles(const AppendixC& statistics) {
    return predicted_cycles(statistics, kThesisCosts) +
           kThesisCosts.segment *
               static_cast<double>(statistics.charged_segments() - statistics.segments());
}

double predicted_cycles(const AppendixC& statistics, const ItemCosts& costs) {
    return costs.polygon * static_cast<double>(statistics.polygons()) +
           costs.vertex * static_cast<double>(statistics.vertex_count()) +
           costs.segment * static_cast<double>(statistics.segments()) +
           costs.pixel * static_cast<double>(statistics.pixels());
}

double error_of(double cycles, const AppendixC& statistics) {
    const auto emulated = static_cast<double>(statistics.scene_cycles());
    return emulated > 0 ? cycles / emulated - 1 : 0;
}

ItemCosts own_costs(const AppendixC& statistics) {
    return {per(statistics.in(Section::polygon), statistics.polygons()),
            per(statistics.in(Section::vertex), statistics.vertex_count()),
            per(statistics.in(Section::segment), statistics.segments()),
            per(statistics.in(Section::pixel), statistics.pixels())};
}

AppendixC AppendixCNode::all() const {
    AppendixC sum;
    for (const AppendixC& frame : frames) {
        sum.add(frame);
    }
    return sum;
}

AppendixC AppendixCReport::all() const {
    AppendixC sum;
    for (const AppendixCNode& node : nodes) {
        sum.add(node.all());
    }
    return sum;
}

}  // namespace rasterloom::observe
