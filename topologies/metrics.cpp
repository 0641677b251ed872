// SPDX-License-Identifier: MIT
#include "topologies/metrics.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/connected_components.hpp>

namespace rasterloom::topology {

namespace {

using Undirected =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                          boost::property<boost::edge_index_t, int>>;
using Directed =
    boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                       boost::no_property, std::uint32_t, std::uint32_t>;

Undirected undirected_graph(const Topology& topology) {
    Undirected graph(topology.nodes.size());
    int index = 0;
    for (NodeIndex n = 0; n < topology.ports.size(); ++n) {
        for (const NodeIndex m : topology.ports[n]) {
            if (n < m) {
                boost::add_edge(n, m, boost::property<boost::edge_index_t, int>(index++), graph);
            }
        }
    }
    return graph;
}

Directed compact_graph(const Topology& topology) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (NodeIndex n = 0; n < topology.ports.size(); ++n) {
        for (const NodeIndex m : topology.ports[n]) {
            edges.emplace_back(n, m);
        }
    }
    return {boost::edges_are_sorted, edges.begin(), edges.end(),
            static_cast<std::uint32_t>(topology.nodes.size())};
}

class DistanceRecorder : public boost::default_bfs_visitor {
  public:
    explicit DistanceRecorder(std::vector<int>& distance) : distance_(distance) {}

    template <typename Edge>
    void tree_edge(const Edge& edge, const Directed& graph) const {
        distance_[boost::target(edge, graph)] = distance_[boost::source(edge, graph)] + 1;
    }

  private:
    std::vector<int>& distance_;
};

Distances measure_distances(const Topology& topology) {
    const Directed graph = compact_graph(topology);
    const std::size_t count = topology.nodes.size();
    std::vector<int> distance(count);
    Distances result;
    std::int64_t sum = 0;
    for (NodeIndex n = 0; n < count; ++n) {
        distance[n] = 0;
        boost::breadth_first_search(graph, n, boost::visitor(DistanceRecorder(distance)));
        const int farthest = *std::max_element(distance.begin(), distance.end());
        result.diameter = std::max(result.diameter, farthest);
        result.radius = n == 0 ? farthest : std::min(result.radius, farthest);
        for (const int d : distance) {
            sum += d;
        }
    }
    const double pairs = static_cast<double>(count) * static_cast<double>(count - 1);
    result.mean = count > 1 ? static_cast<double>(sum) / pairs : 0;
    return result;
}

}  // namespace

Metrics measure(const Topology& topology) {
    const Undirected graph = undirected_graph(topology);
    Metrics metrics;
    metrics.nodes = topology.nodes.size();
    metrics.links = boost::num_edges(graph);
    for (const auto& ports : topology.ports) {
        ++metrics.degrees[ports.size()];
    }
    std::vector<int> component(topology.nodes.size());
    metrics.components =
        static_cast<std::size_t>(boost::connected_components(graph, component.data()));
    metrics.is_planar = boost::boyer_myrvold_planarity_test(graph);
    if (metrics.components == 1) {
        metrics.distances = measure_distances(topology);
    }
    return metrics;
}

}  // namespace rasterloom::topology
