// SPDX-License-Identifier: MIT
#include "machine/observe/appendix_c/appendix_c_text.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

namespace rasterloom::observe {

namespace {

double percent(std::int64_t part, std::int64_t whole) {
    return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

void add_row(std::string& text, const std::string& name, const AppendixC& c, const ItemCosts& own) {
    const auto share = [&](Section section) { return percent(c.in(section), c.scene_cycles()); };
    fmt::format_to(
        std::back_inserter(text),
        "{:<12}{:>9}{:>9}{:>9}{:>10}{:>12}{:>14.1f}{:>+8.2f}%{:>+8.2f}%{:>8.1f}%{:>8.1f}%{:>8.1f}%{"
        ":>8.1f}%\n",
        name, c.polygons(), c.vertex_count(), c.segments(), c.pixels(), c.scene_cycles(),
        formula_cycles(c), 100 * error_of(formula_cycles(c), c),
        100 * error_of(predicted_cycles(c, own), c), share(Section::polygon),
        share(Section::vertex), share(Section::segment), share(Section::pixel));
}

void add_costs(std::string& text, const AppendixC& c) {
    const auto out = std::back_inserter(text);
    const ItemCosts own = own_costs(c);
    const auto row = [&](const char* item, double own_cost, double thesis) {
        fmt::format_to(out, "{:<12}{:>10.1f}{:>10.1f}{:>+9.1f}%\n", item, own_cost, thesis,
                       100 * (own_cost / thesis - 1));
    };
    fmt::format_to(out, "\n{:<12}{:>10}{:>10}{:>10}\n", "Cycles a", "program", "thesis", "");
    row("polygon", own.polygon, kThesisCosts.polygon);
    row("vertex", own.vertex, kThesisCosts.vertex);
    row("segment", own.segment, kThesisCosts.segment);
    row("pixel", own.pixel, kThesisCosts.pixel);
    if (c.digested > 0) {
        fmt::format_to(out, "{:<12}{:>10.1f}   ({} polygons)\n", "digest",
                       static_cast<double>(c.in(Section::digest)) / static_cast<double>(c.digested),
                       c.digested);
    }
    if (const auto costs = c.pixel_fit.solve()) {
        fmt::format_to(out, "A pixel drawn {:.2f}, hidden {:.2f}, a run of pixels {:.2f} more\n",
                       costs->drawn, costs->hidden, costs->run);
    }
}

// Lines of "[n]=m" of at most 100 columns.
void add_distribution(std::string& text, const Distribution& data) {
    constexpr std::size_t kWidth = 100;
    std::string line;
    for (const auto& [value, times] : data.counts()) {
        const std::string entry = fmt::format(" [{}]={}", value, times);
        if (line.size() + entry.size() > kWidth) {
            text += line + "\n";
            line.clear();
        }
        line += entry;
    }
    if (!line.empty()) {
        text += line + "\n";
    }
}

void add_data(std::string& text, std::string_view what, const Distribution& data) {
    fmt::format_to(std::back_inserter(text),
                   "{:<10}{:>9} data points  mean {:.6f}  deviation {:.6f}  variance {:.6f}\n",
                   what, data.points(), data.mean(), data.deviation(), data.variance());
}

void add_times(std::string& text, const AppendixC& c) {
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "{:<16}{:>14}{:>12}{:>9}{:>16}{:>9}\n", "time", "cycles", "a polygon",
                   "share", "formula", "share");
    const auto polygons = static_cast<double>(std::max<std::int64_t>(1, c.polygons()));
    const double formula = formula_cycles(c);
    const auto row = [&](const char* name, Section section, double charged) {
        const std::int64_t cycles = c.in(section);
        fmt::format_to(out, "{:<16}{:>14}{:>12.3f}{:>8.3f}%{:>16.1f}{:>8.3f}%\n", name, cycles,
                       static_cast<double>(cycles) / polygons, percent(cycles, c.scene_cycles()),
                       charged, formula > 0 ? 100 * charged / formula : 0);
    };
    row("polygon", Section::polygon, kThesisCosts.polygon * static_cast<double>(c.polygons()));
    row("vertex", Section::vertex, kThesisCosts.vertex * static_cast<double>(c.vertex_count()));
    row("segment", Section::segment,
        kThesisCosts.segment * static_cast<double>(c.charged_segments()));
    row("pixel", Section::pixel, kThesisCosts.pixel * static_cast<double>(c.pixels()));
    if (c.digested > 0) {
        row("digest", Section::digest, 0);
    }
    fmt::format_to(out, "{:<16}{:>14}{:>12.3f}{:>9}{:>16.1f}{:>9}  error {:+.3f} %\n", "scene",
                   c.scene_cycles(), static_cast<double>(c.scene_cycles()) / polygons, "", formula,
                   "", 100 * error_of(formula_cycles(c), c));
    fmt::format_to(out, "{:<16}{:>14}\n", "other", c.in(Section::other));
}

}  // namespace

std::string appendix_c_table(const AppendixCReport& report) {
    std::string text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "Appendix C of {}{}\n", report.machine,
                   report.frames > 1 ? fmt::format(", {} frames together", report.frames) : "");
    fmt::format_to(out, "{:<12}{:>9}{:>9}{:>9}{:>10}{:>12}{:>14}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}\n",
                   "Processor", "polygons", "vertices", "segments", "pixels", "cycles", "formula",
                   "error", "own", "polygon", "vertex", "segment", "pixel");
    const AppendixC all = report.all();
    const ItemCosts own = own_costs(all);
    for (const AppendixCNode& node : report.nodes) {
        add_row(text, node.name, node.all(), own);
    }
    if (report.nodes.size() > 1) {
        add_row(text, "all", all, own);
    }
    add_costs(text, all);
    return text;
}

std::string appendix_c_of(const AppendixCNode& node) {
    const AppendixC c = node.all();
    std::string text = fmt::format("Appendix C of processor {} (node {})\n", node.name, node.node);
    add_data(text, "v data", c.vertices);
    add_distribution(text, c.vertices);
    add_data(text, "y data", c.heights);
    add_distribution(text, c.heights);
    add_data(text, "l data", c.lengths);
    add_distribution(text, c.lengths);
    add_data(text, "D data", c.depth);
    add_distribution(text, c.depth);
    add_data(text, "area", c.areas);
    add_times(text, c);
    add_costs(text, c);
    return text;
}

}  // namespace rasterloom::observe
