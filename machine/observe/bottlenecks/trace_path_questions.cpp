// SPDX-License-Identifier: MIT
#include "machine/observe/bottlenecks/path_summary.hpp"
#include "machine/observe/bottlenecks/trace_questions.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace rasterloom::observe {

namespace {

Duration time_of(const Statement& row, int column) {
    return Duration::picoseconds(row.column<std::int64_t>(column));
}

// The wires behind components of one kind are one entry.
constexpr const char* kSteps =
    "SELECT CASE WHEN on_wire THEN 'wire' ELSE kind END AS who, CASE WHEN on_wire THEN 'from ' || "
    "kind ELSE name END AS what, sum(to_ps - from_ps) AS time, count(*) FROM path_step JOIN "
    "component ON component.id = component WHERE frame = ? GROUP BY {} ORDER BY time DESC, what";

std::vector<PathShare> shares(const Database& trace, std::int64_t frame, bool by_kind) {
    std::vector<PathShare> list;
    Statement row = trace.prepare(fmt::format(fmt::runtime(kSteps), by_kind ? "who" : "who, what"));
    row.bind(1, frame);
    while (row.step()) {
        const auto kind = row.column<std::string>(0);
        list.push_back({{kind, by_kind ? kind : row.column<std::string>(1)},
                        time_of(row, 2),
                        row.column<std::int64_t>(3)});
    }
    return list;
}

// What lies between two phases is the second one's; after the last one's end nothing happens.
std::vector<PathQuestions::Phase> phases_of(const Database& trace, std::int64_t frame,
                                            const std::vector<PathShare>& kinds) {
    std::vector<PathQuestions::Phase> phases;
    Statement row = trace.prepare(
        "WITH span AS (SELECT number, frame, name, ended_ps, coalesce(lag(ended_ps) OVER (ORDER BY "
        "number), 0) AS began_ps FROM phase) SELECT span.number, span.name, CASE WHEN on_wire THEN "
        "'wire' ELSE component.kind END, sum(min(to_ps, ended_ps) - max(from_ps, began_ps)) FROM "
        "span JOIN path_step ON path_step.frame = span.frame AND from_ps < ended_ps AND to_ps > "
        "began_ps JOIN component ON component.id = component WHERE span.frame = ? GROUP BY 1, 3 "
        "ORDER BY 1");
    row.bind(1, frame);
    std::int64_t last = -1;
    while (row.step()) {
        if (row.column<std::int64_t>(0) != last) {
            last = row.column<std::int64_t>(0);
            phases.push_back({row.column<std::string>(1), std::vector<Duration>(kinds.size())});
        }
        const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const PathShare& candidate) {
            return candidate.who.kind == row.column<std::string>(2);
        });
        if (kind != kinds.end()) {
            phases.back().by_kind[static_cast<std::size_t>(kind - kinds.begin())] +=
                time_of(row, 3);
        }
    }
    return phases;
}

std::vector<PathQuestions::Line> lines_of(const Database& trace, std::int64_t frame) {
    std::vector<PathQuestions::Line> lines;
    Statement row = trace.prepare(
        "SELECT file, line, sum(instructions), sum(time_ps) AS time FROM path_line WHERE frame = ? "
        "GROUP BY file, line ORDER BY time DESC, file, line");
    row.bind(1, frame);
    while (row.step()) {
        lines.push_back(
            {fmt::format("{}:{}", row.column<std::string>(0), row.column<std::int64_t>(1)),
             row.column<std::int64_t>(2), time_of(row, 3)});
    }
    return lines;
}

}  // namespace

std::vector<PathQuestions> path_questions(const Database& trace) {
    std::vector<PathQuestions> paths;
    Statement frame = trace.prepare("SELECT frame, ended_ps - began_ps FROM path ORDER BY frame");
    while (frame.step()) {
        PathQuestions path;
        path.frame = frame.column<std::int64_t>(0);
        path.length = time_of(frame, 1);
        path.kinds = shares(trace, path.frame, true);
        path.components = shares(trace, path.frame, false);
        path.phases = phases_of(trace, path.frame, path.kinds);
        Statement activity = trace.prepare(
            "SELECT coalesce(name, 'activity ' || activity), time_ps FROM path_activity LEFT JOIN "
            "activity ON activity.id = activity WHERE frame = ? ORDER BY activity");
        activity.bind(1, path.frame);
        while (activity.step()) {
            path.activities.emplace_back(activity.column<std::string>(0), time_of(activity, 1));
        }
        path.lines = lines_of(trace, path.frame);
        paths.push_back(std::move(path));
    }
    return paths;
}

}  // namespace rasterloom::observe
