// SPDX-License-Identifier: MIT
#include "machine/observe/trace/sqlite_trace.hpp"

#include "machine/observe/trace/trace_schema.hpp"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::observe {

namespace {

// States of parts are numbered after those of nodes.
constexpr int kPartStates = kNodeStates;

constexpr const char* kStateNames[] = {"busy",          "waiting_input",     "waiting_output",
                                       "waiting_phase", "waiting_interrupt", "asleep",
                                       "idle",          "part_busy",         "part_blocked"};

std::int64_t key_of(EventId event) {
    return static_cast<std::int64_t>(event.source) << 32 | event.sequence;
}

std::int64_t number(ComponentId component) {
    return static_cast<std::int64_t>(component);
}

std::int64_t number(Duration duration) {
    return duration.picoseconds();
}

std::int64_t number(Time time) {
    return time.picoseconds();
}

void bind_all(Statement& statement, std::initializer_list<std::int64_t> values) {
    int parameter = 0;
    for (const std::int64_t value : values) {
        statement.bind(++parameter, value);
    }
}

Statement insert(const Database& database, const std::string& table, int columns) {
    std::string values;
    for (int column = 0; column < columns; ++column) {
        values += column == 0 ? "?" : ", ?";
    }
    return database.prepare(fmt::format("INSERT INTO {} VALUES ({})", table, values));
}

}  // namespace

SqliteTrace::SqliteTrace(std::filesystem::path path, MachineNames names, CauseLog* causes)
    : path_(std::move(path)),
      partial_{path_.string() + ".partial"},
      names_(std::move(names)),
      causes_(causes),
      blame_(names_.components.size()) {
    std::error_code ignored;
    std::filesystem::remove(partial_.path, ignored);
    open_database();
    database_->execute(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}; BEGIN",
                                   kTraceApplication, kTraceFormat));
    database_->execute(kTraceTables);
    write_names();
    database_->execute("COMMIT");
    database_.reset();
    rows_.emplace(partial_.path, std::vector<std::string>{std::begin(kTables), std::end(kTables)});
}

void SqliteTrace::open_database() {
    database_.emplace(Database::open(partial_.path, Database::Access::change));
    // Nobody else sees the file before it is complete, and a broken one is thrown away.
    database_->execute(
        "PRAGMA auto_vacuum = NONE; PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; PRAGMA "
        "locking_mode = EXCLUSIVE");
}

SqliteTrace::PartialFile::~PartialFile() {
    if (!is_complete) {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
    }
}

void SqliteTrace::write_names() {
    Statement component = insert(*database_, "component", 6);
    std::vector<std::optional<NodeIndex>> node_of(names_.components.size());
    for (std::size_t node = 0; node < names_.nodes.size(); ++node) {
        node_of[static_cast<std::size_t>(names_.nodes[node])] = static_cast<NodeIndex>(node);
    }
    std::vector<const LinkEnds*> ends_of(names_.components.size());
    for (const LinkEnds& ends : names_.links) {
        ends_of[static_cast<std::size_t>(ends.link)] = &ends;
    }
    for (std::size_t id = 0; id < names_.components.size(); ++id) {
        component.bind(1, static_cast<std::int64_t>(id))
            .bind(2, std::string_view(names_.components[id].kind))
            .bind(3, std::string_view(names_.components[id].name));
        const auto bind_node = [&](int parameter, std::optional<NodeIndex> node) {
            node ? component.bind(parameter, std::int64_t{*node})
                 : component.bind(parameter, nullptr);
        };
        bind_node(4, node_of[id]);
        const LinkEnds* ends = ends_of[id];
        bind_node(5, ends != nullptr ? std::optional(ends->from) : std::nullopt);
        bind_node(6, ends != nullptr ? std::optional(ends->to) : std::nullopt);
        component.run();
    }
    Statement state = insert(*database_, "state_name", 2);
    for (std::size_t id = 0; id < std::size(kStateNames); ++id) {
        state.bind(1, static_cast<std::int64_t>(id))
            .bind(2, std::string_view(kStateNames[id]))
            .run();
    }
    Statement activity = insert(*database_, "activity", 2);
    for (std::size_t id = 0; id < names_.activities.size(); ++id) {
        if (!names_.activities[id].empty()) {
            activity.bind(1, static_cast<std::int64_t>(id))
                .bind(2, std::string_view(names_.activities[id]))
                .run();
        }
    }
}

// Books the wait to those who took the time, and names the one who took most of it.
std::optional<ComponentId> SqliteTrace::explain(const StateInterval& wait) {
    if (causes_ == nullptr || wait.state == NodeState::busy || wait.ended_by == kNoCause) {
        return std::nullopt;
    }
    std::optional<ComponentId> most;
    Duration longest;
    causes_->walk_back(wait.ended_by, wait.from, [&](const PathStep& step) {
        Blame& blame = blame_[static_cast<std::size_t>(step.component)][step.on_wire ? 1 : 0]
                             [static_cast<std::size_t>(wait.state)];
        ++blame.waits;
        blame.time += step.duration();
        if (step.duration() > longest) {
            longest = step.duration();
            most = step.component;
        }
    });
    return most;
}

void SqliteTrace::interval_ended(const StateInterval& interval) {
    const std::optional<ComponentId> because = explain(interval);
    rows_->add(kStateTable,
               {number(names_.nodes[interval.node]), static_cast<std::int64_t>(interval.state),
                interval.activity, number(interval.from), number(interval.to),
                because ? number(*because) : kSqlNull});
}

void SqliteTrace::part_interval_ended(const PartInterval& interval) {
    rows_->add(kStateTable,
               {number(interval.part), kPartStates + static_cast<std::int64_t>(interval.state),
                kSqlNull, number(interval.from), number(interval.to), kSqlNull});
}

void SqliteTrace::write_message(const MessageRecord& message, ComponentId receiver) {
    const ComponentId source = message.source() < names_.nodes.size()
                                   ? names_.nodes[message.source()]
                                   : names_.parts.front();
    const std::optional<EventId> parent =
        causes_ != nullptr ? causes_->message_behind(message.delivery) : std::nullopt;
    rows_->add(kMessageTable,
               {key_of(message.delivery), static_cast<std::int64_t>(message.id), message.kind,
                message.bytes, message.hops, number(source), number(message.delivery.source),
                number(receiver), number(message.queued), number(message.started),
                number(message.delivered - names_.latency), number(message.delivered),
                number(message.consumed), parent ? key_of(*parent) : kSqlNull});
}

void SqliteTrace::message_consumed(const MessageRecord& message) {
    write_message(message, names_.nodes[message.destination]);
}

void SqliteTrace::message_passed(ComponentId part, const MessageRecord& message) {
    write_message(message, part);
}

void SqliteTrace::phase_ended(const PhaseRecord& phase) {
    phases_.push_back(phase);
}

void SqliteTrace::write_phases() {
    Statement statement = insert(*database_, "phase", 6);
    for (const PhaseRecord& phase : phases_) {
        const std::string name = names_.phase_name(phase.phase);
        statement.bind(1, phase.number)
            .bind(2, std::int64_t{phase.frame})
            .bind(3, std::int64_t{phase.phase})
            .bind(4, std::string_view(name))
            .bind(5, number(phase.began))
            .bind(6, number(phase.ended))
            .run();
    }
}

void SqliteTrace::write_paths(const std::vector<CriticalPath>& paths) {
    Statement frame = insert(*database_, "path", 3);
    Statement statement = insert(*database_, "path_step", 6);
    for (const CriticalPath& path : paths) {
        bind_all(frame, {path.frame, number(path.began), number(path.ended)});
        frame.run();
        std::int64_t count = 0;
        for (const PathStep& step : path.steps) {
            bind_all(statement, {path.frame, count++, number(step.component), step.on_wire ? 1 : 0,
                                 number(step.from), number(step.to)});
            statement.run();
        }
    }
}

void SqliteTrace::close(const RunReport& report, const std::vector<CriticalPath>& paths) {
    add_summaries(report);
    rows_->finish();
    rows_.reset();
    open_database();
    database_->execute("BEGIN");
    write_phases();
    write_paths(paths);
    Statement line = insert(*database_, "path_line", 5);
    for (const PathReport& path : report.paths) {
        for (const PathReport::LineShare& part : path.lines) {
            line.bind(1, path.frame)
                .bind(2, std::string_view(part.file))
                .bind(3, std::int64_t{part.line})
                .bind(4, part.instructions)
                .bind(5, number(part.time))
                .run();
        }
        Statement statement = insert(*database_, "path_activity", 3);
        for (const PathReport::ActivityShare& part : path.activities) {
            bind_all(statement, {path.frame, part.activity, number(part.time)});
            statement.run();
        }
    }
    write_summaries(report);
    database_->execute("COMMIT; PRAGMA analysis_limit = 200; ANALYZE");
    database_.reset();
    std::error_code error;
    std::filesystem::rename(partial_.path, path_, error);
    if (error) {
        throw OutputError(path_.string() + ": cannot be written: " + error.message());
    }
    partial_.is_complete = true;
}

}  // namespace rasterloom::observe
