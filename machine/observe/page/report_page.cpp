// SPDX-License-Identifier: MIT
#include "machine/observe/page/report_page.hpp"

#include "machine/host/png.hpp"
#include "machine/observe/page/packed.hpp"
#include "machine/observe/statistics_files.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rasterloom::observe {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kRunGoesHere = "@RUN@";
constexpr std::int64_t kFull = 65535;  // a bin at its series' scale

void append_little_endian(std::string& bytes, std::uint64_t value, int size) {
    for (int i = 0; i < size; ++i) {
        bytes += static_cast<char>(value >> (8 * i) & 255U);
    }
}

std::string_view name_of(TimelineSeries::Of of) {
    constexpr std::array<std::string_view, 4> kNames{"machine", "node", "link", "part"};
    return kNames[static_cast<std::size_t>(of)];
}

std::string_view name_of(TimelineSeries::Role role) {
    constexpr std::array<std::string_view, 3> kNames{"busy", "waiting", "queue"};
    return kNames[static_cast<std::size_t>(role)];
}

// Bins of one series as 16-bit numbers, component by component.
class SeriesWriter {
  public:
    SeriesWriter(const Timeline& bins, const TimelineSeries& series, Time end)
        : bins_(bins), series_(series), end_(end) {}

    // The greatest mean of a bin; where it is a share of time, 1.
    double scale() const {
        if (series_.role != TimelineSeries::Role::queue) {
            return 1;
        }
        double scale = 0;
        for (std::size_t bin = 0; bin < bins_.bins(); ++bin) {
            for (std::size_t i = 0; i < series_.components; ++i) {
                scale = std::max(scale, mean(i, bin));
            }
        }
        return scale;
    }
    void append_bins(std::string& bytes, double scale) const {
        for (std::size_t i = 0; i < series_.components; ++i) {
            for (std::size_t bin = 0; bin < bins_.bins(); ++bin) {
                const double share = scale > 0 ? mean(i, bin) / scale : 0;
                append_little_endian(bytes, static_cast<std::uint64_t>(std::lround(share * kFull)),
                                     2);
            }
        }
    }
    void append_totals(std::string& bytes) const {
        for (std::size_t i = 0; i < series_.components; ++i) {
            const auto total = static_cast<double>(bins_.total(series_.first_track + i));
            append_little_endian(bytes, std::bit_cast<std::uint64_t>(total), 8);
        }
    }

  private:
    // The last bin is as long as the run reaches into it.
    double mean(std::size_t component, std::size_t bin) const {
        const std::int64_t width = bins_.width().picoseconds();
        const std::int64_t begins = static_cast<std::int64_t>(bin) * width;
        const std::int64_t length = std::min(width, end_.picoseconds() - begins);
        return length > 0
                   ? static_cast<double>(bins_.integral(series_.first_track + component, bin)) /
                         static_cast<double>(length)
                   : 0;
    }

    const Timeline& bins_;
    const TimelineSeries& series_;
    Time end_;
};

Json timeline_json(const RunTimeline& timeline, Time end) {
    Json series = Json::array();
    for (const TimelineSeries& of : timeline.series()) {
        const SeriesWriter writer(timeline.bins(), of, end);
        const double scale = writer.scale();
        std::string bins;
        std::string totals;
        writer.append_bins(bins, scale);
        writer.append_totals(totals);
        series.push_back({{"of", name_of(of.of)},
                          {"role", name_of(of.role)},
                          {"name", of.name},
                          {"label", of.label},
                          {"scale", scale},
                          {"bins", packed(bins)},
                          {"totals_ps", packed(totals)}});
    }
    return {{"bin_ps", timeline.bins().width().picoseconds()},
            {"bins", timeline.bins().bins()},
            {"series", std::move(series)}};
}

Json distribution_json(const Distribution& distribution) {
    Json json = Json::array();
    for (const auto& [value, count] : distribution.counts()) {
        json.push_back({value, count});
    }
    return json;
}

// Six digits are enough to draw.
double rounded(double value) {
    return std::round(value * 1e6) / 1e6;
}

Json parts_json(const MachineDrawing& drawing) {
    Json parts = Json::array();
    for (const MachineDrawing::Part& part : drawing.parts) {
        parts.push_back({{"place", name_of(part.place)},
                         {"parent", part.parent ? Json(*part.parent) : Json()}});
    }
    return parts;
}

Json screen_json(const MachineDrawing& drawing) {
    Json cells = Json::array();
    for (const MachineDrawing::Cell& cell : drawing.cells) {
        cells.push_back({cell.x, cell.y, cell.width, cell.height});
    }
    Json grids = Json::array();
    for (const topology::PixelGrid& grid : drawing.grids) {
        grids.push_back(
            {grid.x_start, grid.y_start, grid.x_step, grid.y_step, grid.columns, grid.rows});
    }
    std::string owners;
    for (const topology::NodeIndex owner : drawing.owners) {
        append_little_endian(owners, owner, 4);
    }
    return {{"width", drawing.width},
            {"height", drawing.height},
            {"cells", std::move(cells)},
            {"grids", std::move(grids)},
            {"owners", packed(owners)}};
}

Json drawing_json(const MachineDrawing& drawing) {
    Json positions = Json::array();
    for (const topology::Vec3& at : drawing.positions) {
        positions.push_back({rounded(at.x), rounded(at.y), rounded(at.z)});
    }
    Json fed_by = Json::array();
    for (const std::optional<std::size_t>& part : drawing.fed_by) {
        fed_by.push_back(part ? Json(*part) : Json());
    }
    return {{"layout", name_of(drawing.layout)}, {"positions", std::move(positions)},
            {"triangles", drawing.triangles},    {"screen", screen_json(drawing)},
            {"parts", parts_json(drawing)},      {"fed_by", std::move(fed_by)}};
}

Json tables_json(const RunReport& report) {
    Json tables;
    tables["nodes"] = packed(nodes_csv(report));
    if (!report.links.empty()) {
        tables["links"] = packed(links_csv(report));
    }
    if (!report.fabric.empty()) {
        tables["parts"] = packed(fabric_csv(report.fabric, report.end.since_start()));
    }
    return tables;
}

Json pictures_json(const std::vector<host::Picture>& pictures) {
    Json json = Json::array();
    for (const host::Picture& picture : pictures) {
        json.push_back("data:image/png;base64," + base64(host::encode_png(picture)));
    }
    return json;
}

// Inside a <script> no tag may begin; in JSON the sign occurs in strings only.
std::string without_tags(const std::string& json) {
    std::string text;
    text.reserve(json.size());
    for (const char c : json) {
        text += c == '<' ? std::string_view("\\u003c") : std::string_view(&c, 1);
    }
    return text;
}

}  // namespace

std::string page_json(const PageContent& content) {
    Json json;
    json["timeline"] = timeline_json(content.timeline, content.report.end);
    json["histograms"] = {{"latency_ps", distribution_json(content.timeline.latencies())},
                          {"hops", distribution_json(content.timeline.hops())}};
    json["drawing"] = drawing_json(content.drawing);
    json["tables"] = tables_json(content.report);
    json["pictures"] = pictures_json(content.pictures);
    const std::string rest = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return fmt::format("{{\"statistics\":{},{}", statistics_json(content.report), rest.substr(1));
}

std::string report_page(const PageContent& content) {
    const std::optional<std::string> page = page_template();
    const std::size_t at = page ? page->find(kRunGoesHere) : std::string::npos;
    if (at == std::string::npos) {
        throw std::logic_error("this program was built without the report's page");
    }
    return page->substr(0, at) + without_tags(page_json(content)) +
           page->substr(at + kRunGoesHere.size());
}

}  // namespace rasterloom::observe
