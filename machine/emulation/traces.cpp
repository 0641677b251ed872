// SPDX-License-Identifier: MIT
#include "machine/emulation/traces.hpp"

#include "machine/observe/machine_trace.hpp"
#include "machine/observe/output_folder.hpp"
#include "machine/observe/sqlite_trace.hpp"

#include <cstdlib>
#include <string>
#include <system_error>

namespace rasterloom::emulation {

std::optional<TraceKind> kind_of_trace(const std::filesystem::path& path) {
    if (path.extension() == ".perfetto-trace") {
        return TraceKind::perfetto;
    }
    return path.extension() == ".sqlite" ? std::optional(TraceKind::sqlite) : std::nullopt;
}

namespace {

std::filesystem::path make_temporary_folder() {
    std::string name = (std::filesystem::temp_directory_path() / "rasterloom-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        throw observe::OutputError(name + ": cannot be made");
    }
    return name;
}

}  // namespace

Traces::Traces(const std::vector<std::filesystem::path>& paths, const observe::MachineNames& names,
               observe::CauseLog* causes, bool to_be_searched) {
    for (const std::filesystem::path& path : paths) {
        add(path, names, causes);
    }
    if (to_be_searched && sqlite_.empty()) {
        temporary_folder_ = make_temporary_folder();
        add(temporary_folder_ / "trace.sqlite", names, causes);
    }
}

Traces::~Traces() {
    traces_.clear();
    if (!temporary_folder_.empty()) {
        std::error_code ignored;
        std::filesystem::remove_all(temporary_folder_, ignored);
    }
}

void Traces::add(const std::filesystem::path& path, const observe::MachineNames& names,
                 observe::CauseLog* causes) {
    if (kind_of_trace(path) == TraceKind::sqlite) {
        traces_.push_back(std::make_unique<observe::SqliteTrace>(path, names, causes));
        sqlite_ = path;
    } else {
        traces_.push_back(std::make_unique<observe::MachineTrace>(path, names));
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
