// SPDX-License-Identifier: MIT
#include "machine/emulation/traces.hpp"

#include "machine/observe/machine_trace.hpp"
#include "machine/observe/sqlite_trace.hpp"

namespace rasterloom::emulation {

std::optional<TraceKind> kind_of_trace(const std::filesystem::path& path) {
    if (path.extension() == ".perfetto-trace") {
        return TraceKind::perfetto;
    }
    return path.extension() == ".sqlite" ? std::optional(TraceKind::sqlite) : std::nullopt;
}

Traces::Traces(const std::vector<std::filesystem::path>& paths, const observe::MachineNames& names,
               observe::CauseLog* causes) {
    for (const std::filesystem::path& path : paths) {
        if (kind_of_trace(path) == TraceKind::sqlite) {
            traces_.push_back(std::make_unique<observe::SqliteTrace>(path, names, causes));
        } else {
            traces_.push_back(std::make_unique<observe::MachineTrace>(path, names));
        }
    }
}

std::vector<observe::TraceSink*> Traces::sinks() const {
    std::vector<observe::TraceSink*> sinks;
    for (const auto& trace : traces_) {
        sinks.push_back(trace.get());
    }
    return sinks;
}

void Traces::close(const observe::RunReport& report,
                   const std::vector<observe::CriticalPath>& paths) {
    for (const auto& trace : traces_) {
        trace->close(report, paths);
    }
}

}  // namespace rasterloom::emulation
