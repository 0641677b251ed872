// SPDX-License-Identifier: MIT
#include "topologies/tiling_export.hpp"

#include "topologies/node_colour.hpp"

#include <algorithm>

#include <fmt/ostream.h>

namespace rasterloom::topology {

namespace {

constexpr double kMargin = 30;
constexpr double kScreen = 800;  // longer side of the screen in the drawing
constexpr double kLens = 400;    // of the enlarged corner

struct Span {
    int from = 0;
    int to = 0;
};

class TilingDrawing {
  public:
    TilingDrawing(std::ostream& out, const Tiling& tiling, const Distribution& distribution)
        : out_(out),
          tiling_(tiling),
          distribution_(distribution),
          scale_(kScreen / std::max(distribution.width, distribution.height)) {}

    void draw() {
        const double width = scale_ * distribution_.width;
        const double height = scale_ * distribution_.height;
        const bool has_lens = tiling_.interlaced() > 1;
        const double all_height = std::max(height, has_lens ? kLens : 0) + 2 * kMargin;
        fmt::print(out_,
                   "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
                   "width=\"{0:.0f}\" height=\"{1:.0f}\" font-family=\"sans-serif\" "
                   "font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
                   width + (has_lens ? kLens + kMargin : 0) + 2 * kMargin, all_height);
        for (int part = 0; part < tiling_.parts(); ++part) {
            draw_part(part);
        }
        if (std::holds_alternative<Distribution::Cut>(distribution_.elements[0].what)) {
            draw_cuts(0, {0, distribution_.width}, {0, distribution_.height}, 5);
        }
        if (has_lens) {
            draw_lens(kMargin * 2 + width);
        }
        out_ << "</svg>\n";
    }

  private:
    double x_of(double x) const { return kMargin + scale_ * x; }
    double y_of(double y) const { return kMargin + scale_ * (distribution_.height - y); }

    void draw_part(int part) {
        const int share = tiling_.interlaced();
        const auto first = static_cast<NodeIndex>(part * share);
        const PixelGrid& grid = distribution_.grids[first];
        const int width = grid.columns * grid.x_step;
        const int height = grid.rows * grid.y_step;
        if (share > 1) {
            define_pattern(part, grid, first);
        }
        const std::string name =
            share > 1 ? fmt::format("P{} to P{}", first, first + static_cast<NodeIndex>(share) - 1)
                      : fmt::format("P{}", first);
        fmt::print(out_,
                   "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
                   "fill=\"{}\" stroke=\"#455a64\" stroke-width=\"0.5\"><title>{}</title></rect>\n",
                   x_of(grid.x_start), y_of(grid.y_start + height), scale_ * width, scale_ * height,
                   share > 1 ? fmt::format("url(#part{})", part) : node_colour(first), name);
        if (tiling_.parts() <= 256) {
            label(x_of(grid.x_start + width / 2.0), y_of(grid.y_start + height / 2.0), name);
        }
    }

    // The pixels of a part repeat: one period is a tile of the pattern.
    void define_pattern(int part, const PixelGrid& grid, NodeIndex first) {
        fmt::print(out_,
                   "<pattern id=\"part{}\" patternUnits=\"userSpaceOnUse\" x=\"{:.2f}\" "
                   "y=\"{:.2f}\" width=\"{:.4f}\" height=\"{:.4f}\">\n",
                   part, x_of(grid.x_start), y_of(grid.y_start), scale_ * grid.x_step,
                   scale_ * grid.y_step);
        for_each_share([&](int k, int column, int row) {
            fmt::print(out_,
                       "<rect x=\"{:.4f}\" y=\"{:.4f}\" width=\"{:.4f}\" height=\"{:.4f}\" "
                       "fill=\"{}\"/>\n",
                       scale_ * column, scale_ * (grid.y_step - 1 - row), scale_, scale_,
                       node_colour(first + static_cast<NodeIndex>(k)));
        });
        out_ << "</pattern>\n";
    }

    template <typename Draw>
    void for_each_share(Draw draw) const {
        for (int k = 0; k < tiling_.interlaced(); ++k) {
            draw(k, k % tiling_.interlace_columns, k / tiling_.interlace_columns);
        }
    }

    void draw_lens(double left) {
        const double cell = kLens / std::max(tiling_.interlace_columns, tiling_.interlace_rows);
        const double bottom = kMargin + cell * tiling_.interlace_rows;
        for_each_share([&](int k, int column, int row) {
            const double x = left + cell * column;
            const double y = bottom - cell * (row + 1);
            fmt::print(out_,
                       "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
                       "fill=\"{}\" stroke=\"white\"/>\n",
                       x, y, cell, cell, node_colour(static_cast<NodeIndex>(k)));
            label(x + cell / 2, y + cell / 2, fmt::format("P{}", k));
        });
    }

    void draw_cuts(std::size_t element, Span x, Span y, double thickness) {
        const auto* cut = std::get_if<Distribution::Cut>(&distribution_.elements[element].what);
        if (cut == nullptr) {
            return;
        }
        const bool is_x = cut->axis == CutAxis::x;
        fmt::print(out_,
                   "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" "
                   "stroke=\"#b71c1c\" stroke-width=\"{:.2f}\"><title>{}</title></line>\n",
                   x_of(is_x ? cut->line : x.from), y_of(is_x ? y.from : cut->line),
                   x_of(is_x ? cut->line : x.to), y_of(is_x ? y.to : cut->line), thickness,
                   distribution_.elements[element].name);
        const auto low = [&](Span span, bool cuts) {
            return cuts ? Span{span.from, cut->line} : span;
        };
        const auto high = [&](Span span, bool cuts) {
            return cuts ? Span{cut->line, span.to} : span;
        };
        draw_cuts(cut->low, low(x, is_x), low(y, !is_x), thickness * 0.75);
        draw_cuts(cut->high, high(x, is_x), high(y, !is_x), thickness * 0.75);
    }

    void label(double x, double y, const std::string& text) {
        fmt::print(out_,
                   "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" "
                   "dominant-baseline=\"middle\" fill=\"#263238\">{}</text>\n",
                   x, y, text);
    }

    std::ostream& out_;
    const Tiling& tiling_;
    const Distribution& distribution_;
    double scale_;
};

void write_element(std::ostream& out, const Distribution::Cut& cut) {
    fmt::print(out, "splitter,{},{},{},{},,\n", cut.axis == CutAxis::x ? "x" : "y", cut.line,
               cut.low, cut.high);
}

void write_element(std::ostream& out, const Distribution::Broadcast& bus) {
    fmt::print(out, "bus,,,,,{},{}\n", bus.processors.front(), bus.processors.size());
}

void write_element(std::ostream& out, const Distribution::Leaf& leaf) {
    fmt::print(out, "processor,,,,,{},1\n", leaf.processor);
}

}  // namespace

void write_grids_csv(std::ostream& out, const Distribution& distribution) {
    out << "node,name,x_start,y_start,x_step,y_step,columns,rows\n";
    for (std::size_t node = 0; node < distribution.grids.size(); ++node) {
        const PixelGrid& grid = distribution.grids[node];
        fmt::print(out, "{},P{},{},{},{},{},{},{}\n", node, node, grid.x_start, grid.y_start,
                   grid.x_step, grid.y_step, grid.columns, grid.rows);
    }
}

void write_elements_csv(std::ostream& out, const Distribution& distribution) {
    out << "element,name,kind,axis,line,low,high,first_processor,processors\n";
    for (std::size_t element = 0; element < distribution.elements.size(); ++element) {
        fmt::print(out, "{},{},", element, distribution.elements[element].name);
        std::visit([&out](const auto& what) { write_element(out, what); },
                   distribution.elements[element].what);
    }
}

void write_tiling_svg(std::ostream& out, const Tiling& tiling, const Distribution& distribution) {
    TilingDrawing(out, tiling, distribution).draw();
}

}  // namespace rasterloom::topology
