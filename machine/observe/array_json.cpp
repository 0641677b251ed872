// SPDX-License-Identifier: MIT
#include "machine/observe/array_json.hpp"

namespace rasterloom::observe {

namespace {

using Json = nlohmann::ordered_json;

void add_counts(Json& json, const BundleCounts& counts) {
    json["cycles_u"] = counts.cycles;
    json["bundles"] = counts.bundles;
    json["operations"] = counts.operations;
    json["operations_per_bundle"] = counts.parallelism();
}

}  // namespace

Json array_json(const RunReport& report) {
    const ArrayReport& array = *report.array;
    Json json;
    json["lanes"] = array.lanes;
    json["line_locked"] = array.line_locked;
    json["line_u"] = array.line;
    json["scanlines"] = array.scanlines;
    json["idle_u"] = array.idle_cycles;
    json["shifts"] = array.shifts;
    json["places"] = array.places;
    json["awake"] = array.awake();
    add_counts(json, array.total());
    json["phases"] = Json::array();
    for (const ArrayReport::Phase& phase : array.phases) {
        Json row{{"phase", phase.phase},
                 {"name", report.phase_name(phase.phase)},
                 {"awake", phase.awake}};
        add_counts(row, phase.counts);
        json["phases"].push_back(std::move(row));
    }
    json["procedures"] = Json::array();
    for (const ArrayReport::Procedure& procedure : array.procedures) {
        Json row{{"name", procedure.name},
                 {"file", procedure.file},
                 {"line", procedure.line},
                 {"calls", procedure.calls}};
        add_counts(row, procedure.counts);
        json["procedures"].push_back(std::move(row));
    }
    return json;
}

}  // namespace rasterloom::observe
