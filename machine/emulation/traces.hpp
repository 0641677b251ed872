// SPDX-License-Identifier: MIT
// The traces of a run: files of either kind, told by the ends of their names.
#pragma once

#include "machine/observe/bottlenecks.hpp"
#include "machine/observe/cause_log.hpp"
#include "machine/observe/critical_path.hpp"
#include "machine/observe/machine_names.hpp"
#include "machine/observe/run_report.hpp"
#include "machine/observe/trace_sink.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace rasterloom::emulation {

enum class TraceKind : std::uint8_t { perfetto, sqlite };

// "x.perfetto-trace", "x.sqlite"; none for another name.
std::optional<TraceKind> kind_of_trace(const std::filesystem::path& path);

class Traces {
  public:
    // Makes the files, whose names are known to be of a kind. `causes` may be null. When the trace
    // is `to_be_searched` and none of them is of SQLite's, there is one more, which goes when this
    // does. Throws OutputError.
    Traces(const std::vector<std::filesystem::path>& paths, const observe::MachineNames& names,
           observe::CauseLog* causes, bool to_be_searched);
    Traces(const Traces&) = delete;
    Traces& operator=(const Traces&) = delete;
    ~Traces();

    std::vector<observe::TraceSink*> sinks() const;
    // Completes the files of a run that did not fail. Throws OutputError.
    void close(const observe::RunReport& report, const std::vector<observe::CriticalPath>& paths);
    // What the closed trace tells.
    observe::Bottlenecks search() const { return observe::find_bottlenecks(sqlite_); }

  private:
    void add(const std::filesystem::path& path, const observe::MachineNames& names,
             observe::CauseLog* causes);

    std::filesystem::path temporary_folder_;  // empty: none
    std::filesystem::path sqlite_;            // one of the files
    std::vector<std::unique_ptr<observe::TraceSink>> traces_;
};

}  // namespace rasterloom::emulation
