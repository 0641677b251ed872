// SPDX-License-Identifier: MIT
#include "topologies/graph_file.hpp"

#include "topologies/angles.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <fmt/format.h>

namespace rasterloom::topology {

namespace {

using boost::property_tree::ptree;

[[noreturn]] void fail(const std::string& file, std::size_t line, const std::string& message) {
    throw GraphFileError(line > 0 ? fmt::format("{}:{}: {}", file, line, message)
                                  : fmt::format("{}: {}", file, message));
}

// Collects nodes and links; messages name the line that `at` set last.
class GraphBuilder {
  public:
    GraphBuilder(std::string file, const char* kind) : file_(std::move(file)) {
        graph_.kind = kind;
    }

    void at(std::size_t line) { line_ = line; }
    [[noreturn]] void fail(const std::string& message) const {
        topology::fail(file_, line_, message);
    }

    NodeIndex node(const std::string& name) {
        const auto [entry, is_new] =
            index_.try_emplace(name, static_cast<NodeIndex>(graph_.nodes.size()));
        if (is_new) {
            graph_.nodes.emplace_back().name = name;
            graph_.ports.emplace_back();
        }
        return entry->second;
    }

    bool has_node(const std::string& name) const { return index_.count(name) > 0; }

    bool has_link(NodeIndex a, NodeIndex b) const { return links_.count(std::minmax(a, b)) > 0; }

    void link(NodeIndex a, NodeIndex b) {
        if (a == b) {
            fail(fmt::format("node '{}' is linked to itself; expected two different nodes",
                             graph_.nodes[a].name));
        }
        if (!links_.insert(std::minmax(a, b)).second) {
            fail(fmt::format("nodes '{}' and '{}' are linked already; expected each link once",
                             graph_.nodes[a].name, graph_.nodes[b].name));
        }
        graph_.ports[a].push_back(b);
        graph_.ports[b].push_back(a);
    }

    double degrees(const std::string& what, const std::string& text, double limit) const {
        double value = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        if (error != std::errc() || stop != end || !(value >= 0 && value <= limit)) {
            fail(fmt::format("{} is '{}'; expected a number of degrees from 0 to {}", what, text,
                             limit));
        }
        return value;
    }

    void place(NodeIndex n, const std::string& phi, const std::string& theta) {
        Node& node = graph_.nodes[n];
        node.phi = std::fmod(degrees("phi", phi, 360), 360.0);
        node.theta = degrees("theta", theta, 180);
        node.direction = from_spherical(node.phi, node.theta);
    }

    Topology finish() {
        if (graph_.nodes.empty()) {
            topology::fail(file_, 0, "no node; expected at least one");
        }
        return std::move(graph_);
    }

  private:
    std::string file_;
    std::size_t line_ = 0;
    Topology graph_;
    std::map<std::string, NodeIndex> index_;
    std::set<std::pair<NodeIndex, NodeIndex>> links_;
};

// Renumbers the nodes by name if the names are exactly 0 to n - 1.
void number_by_name(Topology& t) {
    std::vector<NodeIndex> number;
    std::vector<bool> taken(t.nodes.size());
    for (const Node& node : t.nodes) {
        NodeIndex n = 0;
        const char* const end = node.name.data() + node.name.size();
        const auto [stop, error] = std::from_chars(node.name.data(), end, n);
        if (error != std::errc() || stop != end || n >= t.nodes.size() || taken[n]) {
            return;
        }
        taken[n] = true;
        number.push_back(n);
    }
    Topology sorted = t;
    for (std::size_t old = 0; old < number.size(); ++old) {
        sorted.nodes[number[old]] = t.nodes[old];
        sorted.ports[number[old]].clear();
        for (const NodeIndex neighbour : t.ports[old]) {
            sorted.ports[number[old]].push_back(number[neighbour]);
        }
    }
    t = std::move(sorted);
}

// The same text with comments blanked out; lines stay where they are.
std::string without_comments(std::string text) {
    for (std::size_t begin = text.find("<!--"); begin != std::string::npos;
         begin = text.find("<!--", begin)) {
        const std::size_t close = text.find("-->", begin);
        const std::size_t end = close == std::string::npos ? text.size() : close + 3;
        for (; begin < end; ++begin) {
            text[begin] = text[begin] == '\n' ? '\n' : ' ';
        }
    }
    return text;
}

// Lines on which elements of this name open, in order: the tree itself does not keep them.
std::vector<std::size_t> element_lines(const std::string& text, const std::string& element) {
    std::vector<std::size_t> lines;
    std::size_t line = 1;
    for (std::size_t k = 0; k < text.size(); ++k) {
        line += text[k] == '\n' ? 1 : 0;
        const bool opens = text.compare(k, element.size() + 1, "<" + element) == 0;
        if (opens &&
            std::string(" \t\r\n/>").find(text[k + element.size() + 1]) != std::string::npos) {
            lines.push_back(line);
        }
    }
    return lines;
}

class GraphmlReader {
  public:
    GraphmlReader(std::istream& in, const std::string& name)
        : name_(name), builder_(name, "graphml") {
        const std::string text = without_comments(
            std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()));
        node_lines_ = element_lines(text, "node");
        edge_lines_ = element_lines(text, "edge");
        std::istringstream stream(text);
        try {
            boost::property_tree::read_xml(stream, tree_);
        } catch (const boost::property_tree::xml_parser_error& error) {
            topology::fail(name, error.line(), error.message() + "; expected GraphML");
        }
    }

    Topology read() {
        const auto graph = tree_.get_child_optional("graphml.graph");
        if (!graph) {
            topology::fail(name_, 0, "no <graph> in <graphml>; expected GraphML");
        }
        find_keys(tree_.get_child("graphml"));
        const bool is_directed = graph->get("<xmlattr>.edgedefault", "undirected") == "directed";
        std::size_t nodes = 0;
        for (const auto& [element, content] : *graph) {
            if (element == "node") {
                builder_.at(node_lines_.at(nodes++));
                add_node(content);
            }
        }
        std::size_t edges = 0;
        for (const auto& [element, content] : *graph) {
            if (element == "edge") {
                builder_.at(edge_lines_.at(edges++));
                add_edge(content, is_directed);
            }
        }
        return builder_.finish();
    }

  private:
    void find_keys(const ptree& graphml) {
        for (const auto& [element, content] : graphml) {
            if (element == "key") {
                // ptree reads the dots of "attr.name" as levels of a path
                const ptree none;
                const ptree& attributes = content.get_child("<xmlattr>", none);
                const auto named = attributes.find("attr.name");
                if (named != attributes.not_found()) {
                    key_name_[attributes.get("id", "")] = named->second.data();
                }
            }
        }
    }

    std::string attribute(const ptree& element, const char* name) const {
        const auto value = element.get_optional<std::string>(std::string("<xmlattr>.") + name);
        if (!value) {
            builder_.fail(fmt::format("attribute '{}' is missing", name));
        }
        return *value;
    }

    void add_node(const ptree& element) {
        const std::string id = attribute(element, "id");
        if (builder_.has_node(id)) {
            builder_.fail(fmt::format("node '{}' is there already; expected each node once", id));
        }
        const NodeIndex n = builder_.node(id);
        std::map<std::string, std::string> data;
        for (const auto& [name, content] : element) {
            if (name == "data") {
                data[key_name_[attribute(content, "key")]] = content.data();
            }
        }
        if (data.count("phi") > 0 && data.count("theta") > 0) {
            builder_.place(n, data["phi"], data["theta"]);
        }
    }

    void add_edge(const ptree& element, bool is_directed) {
        const auto end = [&](const char* name) {
            const std::string id = attribute(element, name);
            if (!builder_.has_node(id)) {
                builder_.fail(fmt::format("{} is '{}'; expected the id of a node", name, id));
            }
            return builder_.node(id);
        };
        const NodeIndex source = end("source");
        const NodeIndex target = end("target");
        if (!(is_directed && builder_.has_link(source, target))) {
            builder_.link(source, target);
        }
    }

    std::string name_;
    GraphBuilder builder_;
    ptree tree_;
    std::vector<std::size_t> node_lines_;
    std::vector<std::size_t> edge_lines_;
    std::map<std::string, std::string> key_name_;
};

std::ifstream open(const std::string& path) {
    std::ifstream in(path);
    if (!in) {
        fail(path, 0, "cannot be opened; expected a readable file");
    }
    return in;
}

}  // namespace

Topology read_edge_list(std::istream& in, const std::string& name) {
    GraphBuilder builder(name, "edge_list");
    std::string line;
    for (std::size_t number = 1; std::getline(in, line); ++number) {
        builder.at(number);
        std::istringstream fields(line.substr(0, line.find('#')));
        const std::vector<std::string> field{std::istream_iterator<std::string>(fields), {}};
        if (field.size() > 3) {
            builder.fail(fmt::format("{} fields; expected 'node node', 'node' or 'node phi theta'",
                                     field.size()));
        }
        if (field.size() == 2) {
            const NodeIndex first = builder.node(field[0]);
            builder.link(first, builder.node(field[1]));
        } else if (field.size() == 3) {
            builder.place(builder.node(field[0]), field[1], field[2]);
        } else if (field.size() == 1) {
            builder.node(field[0]);
        }
    }
    Topology t = builder.finish();
    number_by_name(t);
    return t;
}

Topology read_graphml(std::istream& in, const std::string& name) {
    return GraphmlReader(in, name).read();
}

Topology edge_list_file(const std::string& path) {
    std::ifstream in = open(path);
    return read_edge_list(in, path);
}

Topology graphml_file(const std::string& path) {
    std::ifstream in = open(path);
    return read_graphml(in, path);
}

}  // namespace rasterloom::topology
