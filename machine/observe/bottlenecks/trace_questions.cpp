// SPDX-License-Identifier: MIT
#include "machine/observe/bottlenecks/trace_questions.hpp"

#include <algorithm>

namespace rasterloom::observe {

namespace {

constexpr int kBins = 48;  // of a queue's time line
constexpr const char* kShown = "8";

Duration time_of(const Statement& row, int column) {
    return Duration::picoseconds(row.column<std::int64_t>(column));
}

ComponentLabel label_of(const Statement& row) {
    return {row.column<std::string>(0), row.column<std::string>(1)};
}

// Adds `from` to `to`, in which one message waits, to the averages of the bins.
void add_waiting(std::vector<double>& bins, std::int64_t whole, std::int64_t from,
                 std::int64_t to) {
    const double width = static_cast<double>(whole) / static_cast<double>(bins.size());
    const auto bin_of = [&](std::int64_t time) {
        return std::min(bins.size() - 1,
                        static_cast<std::size_t>(static_cast<double>(time) / width));
    };
    for (std::size_t bin = bin_of(from); bin <= bin_of(to); ++bin) {
        const double begin = std::max(static_cast<double>(from), static_cast<double>(bin) * width);
        const double end = std::min(static_cast<double>(to), static_cast<double>(bin + 1) * width);
        bins[bin] += std::max(0.0, end - begin) / width;
    }
}

}  // namespace

std::vector<Use> busiest_components(const Database& trace) {
    std::vector<Use> list;
    Statement row = trace.prepare(
        std::string("SELECT kind, name, busy_ps, blocked_ps FROM (SELECT component, busy_ps, 0 AS "
                    "blocked_ps FROM node_summary UNION ALL SELECT component, busy_ps, blocked_ps "
                    "FROM link_summary UNION ALL SELECT component, busy_ps, blocked_ps FROM "
                    "part_summary) JOIN component ON component.id = component ORDER BY busy_ps "
                    "DESC, component LIMIT ") +
        kShown);
    while (row.step()) {
        list.push_back({label_of(row), time_of(row, 2), time_of(row, 3)});
    }
    return list;
}

std::vector<Contention> contention(const Database& trace) {
    std::vector<Contention> list;
    Statement row = trace.prepare(
        std::string("SELECT kind, name, on_wire, sum(waits), sum(time_ps) AS time FROM wait_cause "
                    "JOIN component ON component.id = component GROUP BY component, on_wire ORDER "
                    "BY time DESC, component, on_wire LIMIT ") +
        kShown);
    while (row.step()) {
        list.push_back({label_of(row), row.column<std::int64_t>(2) != 0,
                        row.column<std::int64_t>(3), time_of(row, 4)});
    }
    return list;
}

std::vector<Balance> balance_by_phase(const Database& trace) {
    std::vector<Balance> list;
    // SQLite takes `busiest` from the row of the maximum.
    Statement row = trace.prepare(
        "SELECT min(phase), name, sum(lasted), sum(mean), sum(most), busiest, max(most) FROM "
        "(SELECT phase.phase, phase.name, max(ended_ps - began_ps) AS lasted, avg(busy_ps) AS "
        "mean, max(busy_ps) AS most, component.name AS busiest FROM node_phase JOIN phase ON "
        "phase.number = node_phase.phase JOIN component ON component.id = component GROUP BY "
        "phase.number) GROUP BY name ORDER BY 1");
    while (row.step()) {
        list.push_back({row.column<std::string>(1), time_of(row, 2), time_of(row, 3),
                        time_of(row, 4), row.column<std::string>(5)});
    }
    return list;
}

Duration idle_time(const Database& trace) {
    Statement row = trace.prepare(
        "SELECT sum(waiting_input_ps + waiting_output_ps + waiting_phase_ps + "
        "waiting_interrupt_ps + asleep_ps) FROM node_summary");
    return row.step() ? time_of(row, 0) : Duration();
}

std::vector<IdleCause> idle_causes(const Database& trace) {
    std::vector<IdleCause> list;
    Statement row = trace.prepare(
        "WITH total AS (SELECT 1 AS state, sum(waiting_input_ps) AS time FROM node_summary UNION "
        "ALL SELECT 2, sum(waiting_output_ps) FROM node_summary UNION ALL SELECT 3, "
        "sum(waiting_phase_ps) FROM node_summary UNION ALL SELECT 4, sum(waiting_interrupt_ps) "
        "FROM node_summary UNION ALL SELECT 5, sum(asleep_ps) FROM node_summary), explained AS "
        "(SELECT state, CASE WHEN on_wire THEN 'wire' ELSE kind "
        "END AS cause, sum(time_ps) AS time FROM wait_cause JOIN component ON component.id = "
        "component GROUP BY 1, 2) SELECT state_name.name, cause, time FROM (SELECT * FROM "
        "explained UNION ALL SELECT total.state, 'unknown', total.time - coalesce((SELECT "
        "sum(time) FROM explained WHERE explained.state = total.state), 0) FROM total) JOIN "
        "state_name ON state_name.id = state WHERE time > 0 ORDER BY time DESC, cause");
    while (row.step()) {
        list.push_back({row.column<std::string>(0), row.column<std::string>(1), time_of(row, 2)});
    }
    return list;
}

void describe_queue(const Database& trace, std::int64_t component, Duration run, HotSpot& spot) {
    Statement row = trace.prepare(
        "SELECT delivered_ps, consumed_ps FROM message WHERE receiver = ?1 UNION ALL SELECT "
        "queued_ps, started_ps FROM message WHERE carrier = ?1 AND (SELECT kind FROM component "
        "WHERE id = ?1) = 'link' ORDER BY 1");
    row.bind(1, component);
    std::vector<std::pair<std::int64_t, int>> changes;
    spot.queue.assign(kBins, 0);
    while (row.step()) {
        const auto from = row.column<std::int64_t>(0);
        const auto to = row.column<std::int64_t>(1);
        if (from < to) {
            add_waiting(spot.queue, std::max<std::int64_t>(1, run.picoseconds()), from, to);
            changes.emplace_back(from, 1);
            changes.emplace_back(to, -1);
        }
    }
    std::sort(changes.begin(), changes.end());
    int length = 0;
    for (const auto& [time, change] : changes) {
        length += change;
        spot.longest_queue = std::max(spot.longest_queue, length);
    }
}

std::vector<std::pair<std::string, Duration>> who_waited_for(const Database& trace,
                                                             std::int64_t component) {
    std::vector<std::pair<std::string, Duration>> list;
    Statement row = trace.prepare(
        "SELECT name, sum(to_ps - from_ps) AS time FROM state JOIN component ON component.id = "
        "component WHERE because = ? GROUP BY component ORDER BY time DESC, component LIMIT 5");
    row.bind(1, component);
    while (row.step()) {
        list.emplace_back(row.column<std::string>(0), time_of(row, 1));
    }
    return list;
}

}  // namespace rasterloom::observe
