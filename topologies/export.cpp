// SPDX-License-Identifier: MIT
#include "topologies/export.hpp"

#include "topologies/angles.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/ostream.h>

namespace rasterloom::topology {

namespace {

constexpr double kMargin = 30;
constexpr double kRadius = 400;  // of a hemisphere or circle, in drawing units

struct Point {
    double x = 0;
    double y = 0;
};

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

// A CSV field: quoted where it holds a comma or a quote.
std::string field(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) {
        return text;
    }
    std::string result = "\"";
    for (const char c : text) {
        result += c == '"' ? "\"\"" : std::string(1, c);
    }
    return result + "\"";
}

// What rounds to zero is printed without a sign.
double unsigned_zero(double x) {
    return x > -5e-10 && x < 5e-10 ? 0 : x;
}

class Drawing {
  public:
    Drawing(std::ostream& out, double width, double height) : out_(out) {
        fmt::print(out_,
                   "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
                   "width=\"{0:.0f}\" "
                   "height=\"{1:.0f}\" font-family=\"sans-serif\" font-size=\"16\">\n"
                   "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
                   width, height);
    }
    ~Drawing() { out_ << "</svg>\n"; }
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    void circle(const Point& at, double radius) {
        fmt::print(
            out_,
            "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"#f4f6f8\" stroke=\"#aab\"/>\n",
            at.x, at.y, radius);
    }

    void line(const Point& a, const Point& b) {
        fmt::print(
            out_,
            "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#78909c\" stroke-width=\"1.2\"/>\n",
            a.x, a.y, b.x, b.y);
    }

    // A link that leaves at one side of the plane and comes in at the other: bowed, so that it does
    // not cover those between.
    void arc(const Point& a, const Point& b) {
        const Point bow{(a.x + b.x) / 2 + (b.y - a.y) / 12, (a.y + b.y) / 2 - (b.x - a.x) / 12};
        fmt::print(out_,
                   "<path d=\"M{:.1f} {:.1f}Q{:.1f} {:.1f} {:.1f} {:.1f}\" fill=\"none\" "
                   "stroke=\"#b0bec5\" "
                   "stroke-width=\"0.8\"/>\n",
                   a.x, a.y, bow.x, bow.y, b.x, b.y);
    }

    void node(const Point& at, double radius, const Node& node, bool stands_out) {
        fmt::print(out_,
                   "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" "
                   "fill=\"{}\"><title>{}</title></circle>\n",
                   at.x, at.y, radius, stands_out ? "#d84315" : "#1565c0", escaped(node.name));
    }

    void text(const Point& at, const std::string& words) {
        fmt::print(
            out_,
            "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" fill=\"#37474f\">{}</text>\n",
            at.x, at.y, escaped(words));
    }

  private:
    std::ostream& out_;
};

double node_radius(std::size_t nodes) {
    return nodes <= 100 ? 7 : nodes <= 1000 ? 4.5 : nodes <= 4000 ? 2.5 : 1.5;
}

template <typename Draw>
void for_each_link(const Topology& t, Draw draw) {
    for (NodeIndex n = 0; n < t.ports.size(); ++n) {
        for (const NodeIndex m : t.ports[n]) {
            if (n < m) {
                draw(n, m);
            }
        }
    }
}

// One hemisphere seen from outside: from the viewer's side (-x) or from behind (+x).
void draw_hemisphere(Drawing& drawing, const Topology& t, bool is_front, const Point& centre) {
    const double side = is_front ? -1 : 1;
    const auto place = [&](NodeIndex n) {
        const Vec3& d = t.nodes[n].direction;
        return Point{centre.x + side * d.y * kRadius, centre.y - d.z * kRadius};
    };
    const auto is_visible = [&](NodeIndex n) { return t.nodes[n].direction.x * side > -1e-9; };
    drawing.circle(centre, kRadius);
    for_each_link(t, [&](NodeIndex a, NodeIndex b) {
        if (is_visible(a) && is_visible(b)) {
            drawing.line(place(a), place(b));
        }
    });
    for (NodeIndex n = 0; n < t.nodes.size(); ++n) {
        if (is_visible(n)) {
            drawing.node(place(n), node_radius(t.nodes.size()), t.nodes[n], t.ports[n].size() == 5);
        }
    }
}

void draw_sphere(std::ostream& out, const Topology& t) {
    const double step = 2 * (kRadius + kMargin);
    Drawing drawing(out, 2 * step, step + kMargin);
    const Point front{kMargin + kRadius, kMargin + kRadius};
    const Point back{front.x + step, front.y};
    draw_hemisphere(drawing, t, true, front);
    draw_hemisphere(drawing, t, false, back);
    drawing.text({front.x, step + kMargin / 3},
                 fmt::format("front (phi 180): {} nodes in all", t.nodes.size()));
    drawing.text({back.x, step + kMargin / 3}, "back (phi 0)");
}

void draw_flat(std::ostream& out, const Topology& t, const std::vector<Point>& place, double width,
               double height, bool bows_long_links) {
    Drawing drawing(out, width, height);
    for_each_link(t, [&](NodeIndex a, NodeIndex b) {
        const bool wraps = bows_long_links && (std::abs(t.nodes[a].phi - t.nodes[b].phi) > 180 ||
                                               std::abs(t.nodes[a].theta - t.nodes[b].theta) > 90);
        if (wraps) {
            drawing.arc(place[a], place[b]);
        } else {
            drawing.line(place[a], place[b]);
        }
    });
    for (NodeIndex n = 0; n < t.nodes.size(); ++n) {
        drawing.node(place[n], node_radius(t.nodes.size()), t.nodes[n], false);
    }
}

void draw_plane(std::ostream& out, const Topology& t) {
    std::vector<Point> place;
    for (const Node& node : t.nodes) {
        place.push_back(
            {kMargin + node.phi / 180 * kRadius, kMargin + node.theta / 180 * kRadius * 2});
    }
    draw_flat(out, t, place, 2 * (kRadius + kMargin), 2 * (kRadius + kMargin), true);
}

void draw_circle(std::ostream& out, const Topology& t) {
    std::vector<Point> place;
    for (std::size_t n = 0; n < t.nodes.size(); ++n) {
        const double angle = 360.0 * static_cast<double>(n) / static_cast<double>(t.nodes.size());
        place.push_back({kMargin + kRadius * (1 + cos_degrees(angle)),
                         kMargin + kRadius * (1 - sin_degrees(angle))});
    }
    draw_flat(out, t, place, 2 * (kRadius + kMargin), 2 * (kRadius + kMargin), false);
}

// Borders between different owners, merged into runs: across[k] tells whether there is a border at
// k.
template <typename IsBorder, typename Draw>
void for_each_run(int length, IsBorder is_border, Draw draw) {
    std::optional<int> begin;
    for (int k = 0; k <= length; ++k) {
        const bool here = k < length && is_border(k);
        if (here && !begin) {
            begin = k;
        } else if (!here && begin) {
            draw(*begin, k);
            begin.reset();
        }
    }
}

}  // namespace

void write_nodes_csv(std::ostream& out, const Topology& topology) {
    out << "node,name,phi_degrees,theta_degrees,x,y,z,ports\n";
    for (NodeIndex n = 0; n < topology.nodes.size(); ++n) {
        const Node& node = topology.nodes[n];
        fmt::print(out, "{},{},{:.6f},{:.6f},{:.9f},{:.9f},{:.9f},{}\n", n, field(node.name),
                   node.phi, node.theta, unsigned_zero(node.direction.x),
                   unsigned_zero(node.direction.y), unsigned_zero(node.direction.z),
                   topology.ports[n].size());
    }
}

void write_links_csv(std::ostream& out, const Topology& topology) {
    out << "link,node_a,port_a,node_b,port_b\n";
    std::size_t link = 0;
    for (NodeIndex a = 0; a < topology.nodes.size(); ++a) {
        for (std::size_t k = 0; k < topology.ports[a].size(); ++k) {
            const NodeIndex b = topology.ports[a][k];
            if (a < b) {
                const auto& back = topology.ports[b];
                fmt::print(out, "{},{},{},{},{}\n", link++, a, k, b,
                           std::find(back.begin(), back.end(), a) - back.begin());
            }
        }
    }
}

void write_svg(std::ostream& out, const Topology& topology) {
    if (!topology.triangles.empty()) {
        draw_sphere(out, topology);
    } else if (topology.kind == "grid" || topology.kind == "torus") {
        draw_plane(out, topology);
    } else {
        draw_circle(out, topology);
    }
}

void write_screen_map_svg(std::ostream& out, const Topology& topology, const ScreenMap& map) {
    const double scale = 4;
    const auto owner = [&](int x, int y) {
        return map.owner[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) +
                         static_cast<std::size_t>(x)];
    };
    const auto at = [&](double x, double y) {
        return Point{kMargin + scale * x, kMargin + scale * y};
    };
    Drawing drawing(out, 2 * kMargin + scale * map.width, 2 * kMargin + scale * map.height);
    for (int y = 0; y <= map.height; ++y) {
        for_each_run(
            map.width,
            [&](int x) { return y == 0 || y == map.height || owner(x, y - 1) != owner(x, y); },
            [&](int from, int to) { drawing.line(at(from, y), at(to, y)); });
    }
    for (int x = 0; x <= map.width; ++x) {
        for_each_run(
            map.height,
            [&](int y) { return x == 0 || x == map.width || owner(x - 1, y) != owner(x, y); },
            [&](int from, int to) { drawing.line(at(x, from), at(x, to)); });
    }
    for (NodeIndex n = 0; n < topology.nodes.size(); ++n) {
        const Node& node = topology.nodes[n];
        drawing.node(at(node.phi / 360 * map.width, node.theta / 180 * map.height), 3, node,
                     topology.ports[n].size() == 5);
    }
}

}  // namespace rasterloom::topology
