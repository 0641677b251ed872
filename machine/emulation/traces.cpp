// SPDX-License-Identifier: MIT
#include "machine/emulation/traces.hpp"

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
            sqlite_.push_back(std::make_unique<observe::SqliteTrace>(path, names, causes));
        } else {
            perfetto_.push_back(std::make_unique<observe::MachineTrace>(path, names));
        }
    }
}

std::vector<observe::TraceSink*> Traces::sinks() const {
    std::vector<observe::TraceSink*> sinks;
    for (const auto& trace : perfetto_) {
        sinks.push_back(trace.get());
    }
    for (const auto& trace : sqlite_) {
        sinks.push_back(trace.get());
    }
    return sinks;
}

void Traces::close(const observe::RunReport& report,
                   const std::vector<observe::CriticalPath>& paths) {
    for (const auto& trace : perfetto_) {
        trace->close(report);
    }
    for (const auto& trace : sqlite_) {
        for (const observe::CriticalPath& path : paths) {
            trace->add_path(path);
        }
        trace->close(report);
    }
}

}  // namespace rasterloom::emulation
