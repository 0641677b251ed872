// SPDX-License-Identifier: MIT
#include "machine/emulation/princeton_check.hpp"

#include "machine/emulation/node_memory.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom {

namespace {

using host::DeliveryReport;
using host::PolygonIndex;
using host::ProcessorIndex;
using topology::RegionIndex;
using topology::RegionMap;

// A screen that is wider than the ring ends with the ring.
RegionMap columns_of_lanes(const ColumnMap& columns, int width, int rows) {
    const auto lanes = static_cast<RegionIndex>(columns.size());
    std::vector<RegionMap::Share> shares;
    for (RegionIndex lane = 0; lane < lanes; ++lane)
        if (const auto column = columns[lane])
            shares.push_back({lane, {*column, 0, *column, rows - 1}});
    return {"the lanes' columns", std::min(width, static_cast<int>(lanes)), rows, lanes, shares};
}

// As region.s divides it.
RegionMap regions_of_group(const isa::Image& image, int width, int rows) {
    const RegionIndex group = require_symbol(image, "group");
    const auto columns = static_cast<int>(require_symbol(image, "kRegionColumns"));
    std::vector<RegionMap::Share> shares;
    for (int left = 0; left < width; left += columns)
        shares.push_back({static_cast<RegionIndex>(left / columns),
                          {left, 0, std::min(left + columns, width) - 1, rows - 1}});
    return {"the group's regions", width, rows, group, shares};
}

RegionMap screen_map(const isa::Image& image, const ColumnMap& columns) {
    const auto width = static_cast<int>(require_symbol(image, "screen_columns"));
    const auto rows = static_cast<int>(require_symbol(image, "screen_rows"));
    return image.symbol("kRegion") ? regions_of_group(image, width, rows)
                                   : columns_of_lanes(columns, width, rows);
}

}  // namespace

CommunicationCheck::CommunicationCheck(const isa::Image& image, const ColumnMap& columns)
    : records_(image),
      distribution_(static_cast<int>(require_symbol(image, "phase_name_communicate"))),
      migration_(static_cast<int>(require_symbol(image, "phase_name_migrate"))),
      lanes_(static_cast<std::int64_t>(columns.size())),
      apart_(lanes_ / image.symbol("duplication").value_or(1)),
      map_(screen_map(image, columns)) {}

std::string CommunicationCheck::phase_ended(const LockstepArray& array, int phase, int next) {
    try {
        std::string wrong;
        if (phase == distribution_)
            wrong = end_distribution(array);
        else if (phase == migration_)
            wrong = end_migration(array);
        if (next == distribution_ || next == migration_)
            begin(array);
        return wrong;
    } catch (const std::invalid_argument& problem) {
        return fmt::format("communication: {}", problem.what());
    }
}

void CommunicationCheck::begin(const LockstepArray& array) {
    polygons_.clear();
    by_words_.clear();
    for (std::int64_t lane = 0; lane < lanes_; ++lane) {
        const LaneRecords own = records_.to_be_sent(array, lane);
        for (std::size_t place = 0; place < own.size(); ++place)
            add(own[place], lane, place);
    }
}

// Of several copies of a database only one may send a polygon: what another one has, too, is the
// same.
void CommunicationCheck::add(const PrincetonRecord& record, std::int64_t lane, std::size_t place) {
    std::vector<PolygonIndex>& equal = by_words_[record.words];
    const auto of_copies = [&](bool own) {
        return std::ranges::count_if(equal, [&](PolygonIndex polygon) {
            const std::int64_t other = polygons_[polygon].lane;
            return own ? other == lane : other != lane && other % apart_ == lane % apart_;
        });
    };
    if (of_copies(true) < of_copies(false))
        return;
    equal.push_back(static_cast<PolygonIndex>(polygons_.size()));
    polygons_.push_back({record.box, lane, place});
}

std::string CommunicationCheck::end_distribution(const LockstepArray& array) const {
    std::vector<host::BoundingBox> boxes;
    for (const Polygon& polygon : polygons_) {
        boxes.push_back(polygon.box);
        if (map_.regions_in(polygon.box.box).empty())
            boxes.back().is_visible = false;
    }
    const RegionIndex regions = map_.regions();
    std::vector<std::vector<PolygonIndex>> received(static_cast<std::size_t>(lanes_));
    for (RegionIndex region = 0; region < regions; ++region) {
        std::unordered_map<std::u16string, std::size_t> seen;
        for (std::int64_t lane = region; lane < lanes_; lane += regions)
            for (const PrincetonRecord& record : records_.received(array, lane))
                received[static_cast<std::size_t>(lane)].push_back(
                    number(record.words, seen[record.words]++));
    }
    return tell(host::check_delivery(host::Destinations(boxes, map_), received), "communication",
                regions < lanes_ ? "no lane of region {} has" : "lane {} lacks");
}

// Lanes that may have had to let polygons pass. A lane holds what it had and what comes to stay,
// and what those before it had no room for: to the right first, then to the left, as migrate.s
// does.
std::vector<bool> CommunicationCheck::possibly_full(const LockstepArray& array) const {
    std::vector<std::int64_t> held(static_cast<std::size_t>(lanes_), 0);
    for (const Polygon& polygon : polygons_) {
        ++held[static_cast<std::size_t>(polygon.lane)];
        if (polygon.box.is_visible && polygon.box.box.x0 != polygon.lane)
            ++held[static_cast<std::size_t>(polygon.box.box.x0)];
    }
    std::vector<bool> is_full(held.size(), false);
    for (const std::int64_t way : {1, -1}) {
        std::int64_t passing = 0;
        for (std::int64_t step = 0; step < 2 * lanes_; ++step) {
            const std::int64_t lane = (2 * lanes_ + way * step) % lanes_;
            const auto index = static_cast<std::size_t>(lane);
            const std::int64_t most = held[index] + passing;
            passing = std::max<std::int64_t>(0, most - records_.room_for_homes(array, lane));
            is_full[index] = is_full[index] || passing > 0;
            if (way == 1 && step >= lanes_)
                held[index] = most;
        }
    }
    return is_full;
}

std::string CommunicationCheck::end_migration(const LockstepArray& array) const {
    const std::vector<bool> is_full = possibly_full(array);
    std::vector<int> homes(polygons_.size(), 0);
    std::unordered_map<std::u16string, std::size_t> seen;
    DeliveryReport report;
    for (std::int64_t lane = 0; lane < lanes_; ++lane)
        for (const PrincetonRecord& record : records_.at_home(array, lane)) {
            const PolygonIndex polygon = number(record.words, seen[record.words]++);
            const host::DeliveryFault here{polygon, static_cast<ProcessorIndex>(lane)};
            const bool is_known = polygon < polygons_.size();
            const auto& [is_visible, box] = record.box;
            if (is_known && ++homes[polygon] > 1)
                report.repeated.add(here);
            else if (!is_known ||
                     (is_visible && box.x0 != lane && !is_full[static_cast<std::size_t>(box.x0)]))
                report.unneeded.add(here);
        }
    for (PolygonIndex polygon = 0; polygon < polygons_.size(); ++polygon)
        if (homes[polygon] == 0)
            report.missing.add({polygon, static_cast<ProcessorIndex>(polygons_[polygon].lane)});
    return tell(report, "migration", "no lane has");
}

// Of the polygons with these words one after the other; beyond the last polygon if there is none.
PolygonIndex CommunicationCheck::number(const std::u16string& words, std::size_t occurrence) const {
    const auto found = by_words_.find(words);
    return found == by_words_.end() ? static_cast<PolygonIndex>(polygons_.size())
                                    : found->second[occurrence % found->second.size()];
}

std::string CommunicationCheck::name(PolygonIndex number) const {
    if (number >= polygons_.size())
        return "a polygon that no lane has sent";
    const Polygon& polygon = polygons_[number];
    const auto& box = polygon.box.box;
    return fmt::format("polygon {} of lane {}, with the box ({},{}) ({},{})", polygon.place,
                       polygon.lane, box.x0, box.y0, box.x1, box.y1);
}

// `lacks`: for whom a polygon is missing.
std::string CommunicationCheck::tell(const DeliveryReport& report, const char* communication,
                                     const char* lacks) const {
    std::string text;
    const auto add = [&](const host::DeliveryFaults& faults, const char* what) {
        if (faults.count == 0)
            return;
        const auto& [polygon, processor] = faults.first.front();
        text += fmt::format("{} {} {}", text.empty() ? "" : ";",
                            fmt::format(fmt::runtime(what), processor), name(polygon));
        if (faults.count > 1)
            text += fmt::format(" ({} more such)", faults.count - 1);
    };
    add(report.missing, lacks);
    add(report.unneeded, "lane {} has what it does not need:");
    add(report.repeated, "lane {} has once too often");
    return text.empty() ? text : fmt::format("{}:{}", communication, text);
}

}  // namespace rasterloom
