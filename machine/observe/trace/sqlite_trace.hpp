// SPDX-License-Identifier: MIT
// What a machine does, as a SQLite file to ask questions of: a row for each hop of a message with
// all its times and the message that it was sent because of, for each state of a node or part, and
// for each step of the critical paths (machine/observe/trace/trace_schema.hpp, docs/traces.md).
//
// The file is written under a temporary name and gets its own when it is complete.
#pragma once

#include "machine/observe/bottlenecks/cause_log.hpp"
#include "machine/observe/bottlenecks/critical_path.hpp"
#include "machine/observe/database.hpp"
#include "machine/observe/machine_names.hpp"
#include "machine/observe/run_report.hpp"
#include "machine/observe/trace/row_writer.hpp"
#include "machine/observe/trace/trace_sink.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace rasterloom::observe {

class SqliteTrace final : public TraceSink {
  public:
    // `causes`: of the events of the frame in progress, to explain messages and waits; null where
    // nobody keeps them. Throws OutputError when the file cannot be made.
    SqliteTrace(std::filesystem::path path, MachineNames names, CauseLog* causes);
    SqliteTrace(const SqliteTrace&) = delete;
    SqliteTrace& operator=(const SqliteTrace&) = delete;
    ~SqliteTrace() override = default;  // removes what was not closed

    void interval_ended(const StateInterval& interval) override;
    void message_consumed(const MessageRecord& message) override;
    void phase_ended(const PhaseRecord& phase) override;
    void part_interval_ended(const PartInterval& interval) override;
    void message_passed(ComponentId part, const MessageRecord& message) override;

    void close(const RunReport& report, const std::vector<CriticalPath>& paths) override;

  private:
    // What processors waited for: one component, or the wire behind it.
    struct Blame {
        std::int64_t waits = 0;
        Duration time;
    };
    using Blames = std::array<std::array<Blame, kNodeStates>, 2>;  // [on wire][state]

    void open_database();
    void write_names();
    void write_message(const MessageRecord& message, ComponentId receiver);
    std::optional<ComponentId> explain(const StateInterval& wait);
    void write_phases();
    void write_paths(const std::vector<CriticalPath>& paths);
    void add_summaries(const RunReport& report);
    void add_node(ComponentId id, const NodeReport& node);
    void add_blame();
    void write_summaries(const RunReport& report);
    void write_parts(const RunReport& report);

    // Removed unless it has got its own name: also when the constructor fails.
    struct PartialFile {
        std::filesystem::path path;
        bool is_complete = false;

        ~PartialFile();
    };
    // Those that rows_ fills: they grow with the run or with the machine.
    enum Table : std::size_t {
        kStateTable,
        kMessageTable,
        kNodeSummaryTable,
        kNodePhaseTable,
        kLinkSummaryTable,
        kWaitCauseTable,
    };
    static constexpr const char* kTables[] = {"state",      "message",      "node_summary",
                                              "node_phase", "link_summary", "wait_cause"};

    std::filesystem::path path_;
    PartialFile partial_;
    MachineNames names_;
    CauseLog* causes_;
    std::vector<Blames> blame_;         // [component]
    std::optional<Database> database_;  // while nobody else writes the file
    std::optional<RowWriter> rows_;
    std::vector<PhaseRecord> phases_;
};

}  // namespace rasterloom::observe
