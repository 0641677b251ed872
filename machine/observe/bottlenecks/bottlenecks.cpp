// SPDX-License-Identifier: MIT
#include "machine/observe/bottlenecks/bottlenecks.hpp"

#include "machine/observe/bottlenecks/trace_questions.hpp"
#include "machine/observe/trace/trace_schema.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::observe {

namespace {

constexpr std::size_t kHotSpots = 3;

Database open_trace(const std::filesystem::path& path) {
    Database trace = Database::open(path, Database::Access::read);
    const auto pragma = [&](const char* name) {
        Statement statement = trace.prepare(fmt::format("PRAGMA {}", name));
        return statement.step() ? statement.column<std::int64_t>(0) : 0;
    };
    if (pragma("application_id") != kTraceApplication) {
        throw OutputError(fmt::format(
            "{}: is no trace; expected a file that `rasterloom run --trace NAME.sqlite` wrote",
            path.string()));
    }
    if (const std::int64_t format = pragma("user_version"); format != kTraceFormat) {
        throw OutputError(fmt::format("{}: is a trace of format {}; this program reads format {}",
                                      path.string(), format, kTraceFormat));
    }
    return trace;
}

// What the frames, taken together, spent most of their time on.
std::vector<HotSpot> hot_spots(const Database& trace, Duration run) {
    std::vector<HotSpot> spots;
    // The wires behind components of one kind are one: nobody makes a single wire shorter.
    Statement longest = trace.prepare(
        "SELECT CASE WHEN on_wire THEN -1 ELSE component END AS part, CASE WHEN on_wire THEN "
        "'wires' ELSE kind END, CASE WHEN on_wire THEN 'behind ' || kind || 's' ELSE name END AS "
        "what, sum(to_ps - from_ps) AS time FROM path_step JOIN component ON component.id = "
        "component GROUP BY part, what ORDER BY time DESC, what LIMIT ?");
    longest.bind(1, static_cast<std::int64_t>(kHotSpots));
    while (longest.step()) {
        HotSpot spot;
        spot.who = {longest.column<std::string>(1), longest.column<std::string>(2)};
        spot.on_path = Duration::picoseconds(longest.column<std::int64_t>(3));
        const auto component = longest.column<std::int64_t>(0);
        if (component >= 0) {
            describe_queue(trace, component, run, spot);
            spot.waiters = who_waited_for(trace, component);
        }
        spots.push_back(std::move(spot));
    }
    return spots;
}

}  // namespace

double Balance::imbalance() const {
    return mean > Duration()
               ? static_cast<double>(most.picoseconds()) / static_cast<double>(mean.picoseconds())
               : 1;
}

Bottlenecks find_bottlenecks(const std::filesystem::path& path) {
    const Database trace = open_trace(path);
    Bottlenecks found;
    const auto number = [&](const char* name) {
        Statement statement = trace.prepare("SELECT value FROM run WHERE name = ?");
        statement.bind(1, std::string_view(name));
        return statement.step() ? statement.column<std::int64_t>(0) : 0;
    };
    Statement machine = trace.prepare("SELECT value FROM run WHERE name = 'machine'");
    found.machine = machine.step() ? machine.column<std::string>(0) : "";
    found.cycle = Duration::picoseconds(number("cycle_ps"));
    found.run = Duration::picoseconds(number("end_ps"));
    found.nodes = number("nodes");
    found.paths = path_questions(trace);
    found.hot_spots = hot_spots(trace, found.run);
    found.busiest = busiest_components(trace);
    found.contention = contention(trace);
    found.phases = balance_by_phase(trace);
    found.idle = idle_time(trace);
    found.idle_causes = idle_causes(trace);
    return found;
}

}  // namespace rasterloom::observe
