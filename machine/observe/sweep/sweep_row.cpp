// SPDX-License-Identifier: MIT
#include "machine/observe/sweep/sweep_row.hpp"

#include <type_traits>
#include <utility>

#include <nlohmann/json.hpp>

namespace rasterloom::observe {

namespace {

using Json = nlohmann::json;

Json to_json(const Cell& cell) {
    return std::visit([](const auto& value) { return Json(value); }, cell);
}

Cell to_cell(const Json& json) {
    if (json.is_null()) {
        return nullptr;
    }
    if (json.is_string()) {
        return json.get<std::string>();
    }
    if (json.is_number_float()) {
        return json.get<double>();
    }
    return json.get<std::int64_t>();
}

}  // namespace

SweepResult failed_result(std::string error) {
    SweepResult result;
    result.error = std::move(error);
    return result;
}

SweepResult result_of(const RunReport& report, double wall_seconds) {
    SweepResult result;
    for (const Figure& figure : run_figures()) {
        result.figures.push_back(figure.of(report));
    }
    result.wall_seconds = wall_seconds;
    result.machine_seconds =
        static_cast<double>(report.end.picoseconds()) / static_cast<double>(kPicosecondsPerSecond);
    return result;
}

std::string encode(const SweepResult& result) {
    Json json;
    json["error"] = result.error;
    json["figures"] = Json::array();
    for (const Cell& cell : result.figures) {
        json["figures"].push_back(to_json(cell));
    }
    json["wall_seconds"] = result.wall_seconds;
    json["machine_seconds"] = result.machine_seconds;
    json["fingerprint"] = result.fingerprint;
    // Names come from the user's files, in whatever encoding.
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

SweepResult decode_result(std::string_view bytes) {
    const Json json = Json::parse(bytes);
    SweepResult result;
    result.error = json.at("error").get<std::string>();
    for (const Json& cell : json.at("figures")) {
        result.figures.push_back(to_cell(cell));
    }
    result.wall_seconds = json.at("wall_seconds").get<double>();
    result.machine_seconds = json.at("machine_seconds").get<double>();
    result.fingerprint = json.at("fingerprint").get<std::string>();
    return result;
}

}  // namespace rasterloom::observe
