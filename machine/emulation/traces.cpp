// SPDX-License-Identifier: MIT
#include "machine/emulation/traces.hpp"

#include "machine/config/error.hpp"
#include "machine/observe/output_folder.hpp"
#include "machine/observe/trace/machine_trace.hpp"
#include "machine/observe/trace/sqlite_trace.hpp"

#include <cstdlib>
#include <map>
#include <string>
#include <system_error>
#include <utility>

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

std::vector<ComponentId> components_of(const TraceOptions& options,
                                       const observe::MachineNames& names) {
    std::map<std::string, ComponentId> by_name;
    std::vector<std::string> all;
    for (const ComponentId node : names.nodes) {  // a part may have the name of what it serves
        by_name.emplace(names.label(node).name, node);
    }
    for (std::size_t id = 0; id < names.components.size(); ++id) {
        const observe::ComponentLabel& label = names.components[id];
        by_name.emplace(label.name, static_cast<ComponentId>(id));
        by_name.emplace(label.kind + "/" + label.name, static_cast<ComponentId>(id));
    }
    std::vector<ComponentId> components;
    for (const std::string& name : options.components) {
        const auto found = by_name.find(name);
        if (found == by_name.end()) {
            for (const auto& [known, id] : by_name) {
                all.push_back(known);
            }
            config::refuse({"--trace-of", 0, 0}, {}, name, "no such part of the machine",
                           "names as `rasterloom describe` shows them, a link's as \"A > B\"",
                           config::nearest_name(name, all));
        }
        components.push_back(found->second);
    }
    return components;
}

}  // namespace

Traces::Traces(const TraceOptions& options, const observe::MachineNames& names,
               observe::CauseLog* causes, bool to_be_searched) {
    const observe::TraceWindow window{options.from, options.to, components_of(options, names)};
    for (const std::filesystem::path& path : options.paths) {
        add(path, window, names, causes);
    }
    if (to_be_searched) {
        temporary_folder_ = make_temporary_folder();
        searched_ = temporary_folder_ / "trace.sqlite";
        add(searched_, {}, names, causes);
    }
}

Traces::~Traces() {
    traces_.clear();
    if (!temporary_folder_.empty()) {
        std::error_code ignored;
        std::filesystem::remove_all(temporary_folder_, ignored);
    }
}

void Traces::add(const std::filesystem::path& path, const observe::TraceWindow& window,
                 const observe::MachineNames& names, observe::CauseLog* causes) {
    std::unique_ptr<observe::TraceSink> sink;
    if (kind_of_trace(path) == TraceKind::sqlite) {
        sink = std::make_unique<observe::SqliteTrace>(path, names, causes);
    } else {
        sink = std::make_unique<observe::MachineTrace>(path, names);
    }
    traces_.push_back(std::make_unique<observe::TraceFilter>(std::move(sink), window, names.nodes,
                                                             names.components.size()));
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
