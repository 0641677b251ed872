// SPDX-License-Identifier: MIT
// The traces of a run: files of either kind, told by the ends of their names.
#pragma once

#include "machine/observe/bottlenecks/bottlenecks.hpp"
#include "machine/observe/bottlenecks/cause_log.hpp"
#include "machine/observe/bottlenecks/critical_path.hpp"
#include "machine/observe/machine_names.hpp"
#include "machine/observe/run_report.hpp"
#include "machine/observe/trace/trace_filter.hpp"
#include "machine/observe/trace/trace_sink.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rasterloom::emulation {

enum class TraceKind : std::uint8_t { perfetto, sqlite };

// "x.perfetto-trace", "x.sqlite"; none for another name.
std::optional<TraceKind> kind_of_trace(const std::filesystem::path& path);

struct TraceOptions {
    std::vector<std::filesystem::path> paths;  // each of a kind
    Time from = Time::zero();                  // a window of time
    Time to = Time::never();
    std::vector<std::string> components;  // by name, with or without their kind; empty: all
};

class Traces {
  public:
    // Makes the files. `causes` may be null. When a trace is `to_be_searched`, there is one more,
    // of everything, which goes when this does. Throws OutputError, and ConfigError for a name that
    // no component has.
    Traces(const TraceOptions& options, const observe::MachineNames& names,
           observe::CauseLog* causes, bool to_be_searched);
    Traces(const Traces&) = delete;
    Traces& operator=(const Traces&) = delete;
    ~Traces();

    std::vector<observe::TraceSink*> sinks() const;
    // Completes the files of a run that did not fail. Throws OutputError.
    void close(const observe::RunReport& report, const std::vector<observe::CriticalPath>& paths);
    // What the closed trace tells.
    observe::Bottlenecks search() const { return observe::find_bottlenecks(searched_); }

  private:
    void add(const std::filesystem::path& path, const observe::TraceWindow& window,
             const observe::MachineNames& names, observe::CauseLog* causes);

    std::filesystem::path temporary_folder_;  // empty: none
    std::filesystem::path searched_;          // in it
    std::vector<std::unique_ptr<observe::TraceSink>> traces_;
};

}  // namespace rasterloom::emulation
