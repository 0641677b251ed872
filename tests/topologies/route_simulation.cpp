// SPDX-License-Identifier: MIT
#include "tests/topologies/route_simulation.hpp"

#include "topologies/angles.hpp"

#include <algorithm>
#include <deque>
#include <stdexcept>
#include <utility>

namespace rasterloom::topology {

int port_towards(const Topology& topology, NodeIndex from, NodeIndex to) {
    const auto& ports = topology.ports[from];
    return static_cast<int>(std::find(ports.begin(), ports.end(), to) - ports.begin());
}

Arrival follow(const Topology& topology, const RoutingTable& table, Router route, NodeIndex source,
               const RouteTarget& target) {
    Arrival at{source, 0};
    std::optional<int> from;
    while (at.hops <= kMaxHops) {
        const auto port = route(table.nodes[at.node], target, from);
        if (!port) {
            break;
        }
        const NodeIndex next = topology.ports[at.node][static_cast<std::size_t>(*port)];
        from = port_towards(topology, next, at.node);
        at = {next, at.hops + 1};
    }
    return at;
}

// The port chosen depends on the port of arrival only where it would be the same one. So each node
// has one next node, and the messages for one target form a forest whose roots are nodes where they
// arrive or pairs that point at each other.
std::vector<Arrival> follow_all(const Topology& topology, const RoutingTable& table, Router route,
                                const RouteTarget& target) {
    constexpr int kUnknown = -1;
    constexpr int kOnTheWay = -2;
    const auto count = static_cast<NodeIndex>(topology.nodes.size());
    std::vector<NodeIndex> next(count);
    for (NodeIndex n = 0; n < count; ++n) {
        const auto port = route(table.nodes[n], target, std::nullopt);
        next[n] = port ? topology.ports[n][static_cast<std::size_t>(*port)] : n;
    }
    std::vector<Arrival> arrival(count, {0, kUnknown});
    for (NodeIndex n = 0; n < count; ++n) {
        if (next[n] == n) {
            arrival[n] = {n, 0};
        } else if (next[next[n]] == n) {
            arrival[n] = {next[n], 1};
        }
    }
    std::vector<NodeIndex> way;
    for (NodeIndex n = 0; n < count; ++n) {
        NodeIndex at = n;
        for (; arrival[at].hops == kUnknown; at = next[at]) {
            arrival[at].hops = kOnTheWay;
            way.push_back(at);
        }
        if (arrival[at].hops == kOnTheWay) {
            throw std::logic_error("messages run in a circle");
        }
        for (; !way.empty(); way.pop_back()) {
            const Arrival& ahead = arrival[next[way.back()]];
            arrival[way.back()] = {ahead.node, ahead.hops + 1};
        }
    }
    return arrival;
}

std::vector<Arrival> walk_all(const Topology& topology, const WalkTable& walk,
                              std::vector<Arrival> arrivals, int x, int y) {
    for (Arrival& at : arrivals) {
        const int start = at.hops;
        while (const auto path = walk_path(walk.nodes[at.node], walk.width, x, y)) {
            for (Path rest = *path; first_hop(rest); rest = rest_of(rest)) {
                at = {topology.ports[at.node][static_cast<std::size_t>(*first_hop(rest))],
                      at.hops + 1};
            }
            if (*path == kEmptyPath || at.hops - start > 10000) {
                throw std::logic_error("a walk does not end");
            }
        }
    }
    return arrivals;
}

std::vector<int> distances_from(const Topology& topology, NodeIndex start) {
    std::vector<int> distance(topology.nodes.size(), -1);
    std::deque<NodeIndex> queue{start};
    distance[start] = 0;
    for (; !queue.empty(); queue.pop_front()) {
        for (const NodeIndex next : topology.ports[queue.front()]) {
            if (distance[next] < 0) {
                distance[next] = distance[queue.front()] + 1;
                queue.push_back(next);
            }
        }
    }
    return distance;
}

Rounds simulate_rounds(const Topology& topology, const RoutingTable& table, Router route,
                       const std::vector<RouteTarget>& targets) {
    struct Message {
        RouteTarget target;
        std::optional<int> from;
        int hops = 0;
        int port = 0;
    };
    Rounds result;
    result.facets.resize(topology.nodes.size());
    std::vector<std::deque<Message>> queue(topology.nodes.size());
    const auto receive = [&](NodeIndex n, Message message) {
        const auto port = route(table.nodes[n], message.target, message.from);
        if (!port) {
            result.longest = std::max(result.longest, message.hops);
            ++result.facets[n];
            return;
        }
        message.port = *port;
        queue[n].push_back(message);
    };
    for (NodeIndex n = 0; n < targets.size(); ++n) {
        receive(n, {targets[n], std::nullopt});
    }
    for (;; ++result.rounds) {
        std::vector<std::pair<NodeIndex, Message>> in_transit;
        for (NodeIndex n = 0; n < queue.size(); ++n) {
            if (queue[n].size() > result.longest_queue) {
                result.longest_queue = queue[n].size();
                result.busiest.clear();
            }
            if (!queue[n].empty()) {
                if (queue[n].size() == result.longest_queue) {
                    result.busiest.push_back(n);
                }
                Message message = queue[n].front();
                queue[n].pop_front();
                const NodeIndex next = topology.ports[n][static_cast<std::size_t>(message.port)];
                message.from = port_towards(topology, next, n);
                ++message.hops;
                in_transit.emplace_back(next, message);
            }
        }
        if (in_transit.empty()) {
            ++result.rounds;
            return result;
        }
        result.utilisation.push_back(static_cast<double>(in_transit.size()) /
                                     static_cast<double>(topology.nodes.size()));
        for (auto& [n, message] : in_transit) {
            receive(n, message);
        }
    }
}

std::vector<RouteTarget> rotation(const RoutingTable& table, double degrees) {
    std::vector<RouteTarget> targets;
    for (const RoutingNode& node : table.nodes) {
        targets.push_back(make_target(node.phi + to_angle16(degrees), node.theta));
    }
    return targets;
}

}  // namespace rasterloom::topology
