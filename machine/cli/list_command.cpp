// SPDX-License-Identifier: MIT
// rasterloom list: what configurations can name.
#include "machine/cli/command.hpp"
#include "machine/config/locator.hpp"
#include "machine/emulation/programs.hpp"
#include "machine/emulation/scene_kind.hpp"
#include "machine/host/polygon_scenes.hpp"
#include "machine/host/scenes.hpp"
#include "topologies/registry.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

#include <fmt/format.h>

namespace rasterloom::cli {

namespace {

namespace fs = std::filesystem;

struct Row {
    std::string name;
    std::string summary;
};

void print_rows(std::vector<Row> rows) {
    std::size_t width = 0;
    for (const Row& row : rows) {
        width = std::max(width, row.name.size());
    }
    for (const Row& row : rows) {
        fmt::print("{:<{}}  {}\n", row.name, width, row.summary);
    }
}

// A file's first comment line that says something, without its sign.
std::string first_comment(const fs::path& path) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        const std::size_t begin = line.find_first_not_of("#;/ \t");
        if (begin != std::string::npos &&
            line.find("SPDX-License-Identifier") == std::string::npos) {
            return line.substr(begin);
        }
    }
    return {};
}

// Files below `folder` with this extension, named relative to it.
std::vector<Row> files_below(const fs::path& folder, std::string_view extension) {
    std::vector<Row> rows;
    std::error_code ignored;
    for (const auto& entry : fs::recursive_directory_iterator(folder, ignored)) {
        if (entry.path().extension() == extension) {
            rows.push_back(
                {entry.path().lexically_relative(folder).string(), first_comment(entry.path())});
        }
    }
    std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.name < b.name; });
    return rows;
}

void list_isas() {
    const isa::IsaRegistry registry = emulation::built_in_isas();
    for (const isa::Isa* isa : registry.all()) {
        fmt::print("{}  {}\n", isa->name(), isa->summary());
        for (const isa::CostModelInfo& model : isa->cost_models()) {
            fmt::print("  cost model {}: {}\n", model.name, model.summary);
            for (const isa::CostParameter& parameter : model.parameters) {
                fmt::print("    {:<16}{:>4}  {}\n", parameter.name, parameter.value,
                           parameter.summary);
            }
        }
    }
}

void list_topologies() {
    for (const topology::TopologyKind& kind : topology::topology_kinds()) {
        fmt::print("{}  {}\n", kind.name, kind.summary);
        for (const topology::ParameterInfo& parameter : kind.parameters) {
            fmt::print("    {:<18} {}\n", parameter.name, parameter.summary);
        }
    }
}

void list_scenes(const config::Locator& locator) {
    std::vector<Row> rows;
    for (const host::SceneObject& object : host::scene_objects()) {
        rows.push_back({std::string("object: ") + object.name, object.summary});
    }
    for (const host::PolygonScene& scene : host::polygon_scenes()) {
        rows.push_back({std::string("polygons: ") + scene.name,
                        std::string(scene.summary) +
                            (scene.takes_model ? " (takes another model: scene.model)" : "")});
    }
    rows.push_back({std::string("triangles: ") + emulation::kRandomTriangles,
                    "screen triangles with given statistics (scene.triangles), for bucket tiles"});
    for (Row& row : files_below(locator.configs() / "scenes", ".yaml")) {
        rows.push_back({"scenes/" + row.name, row.summary});
    }
    print_rows(rows);
}

// Include files are not programs: they have no entry.
void list_programs(const config::Locator& locator) {
    std::vector<Row> rows = files_below(locator.programs(), ".s");
    std::erase_if(rows, [&](const Row& row) {
        std::ifstream file(locator.programs() / row.name);
        for (std::string line; std::getline(file, line);) {
            const std::size_t begin = line.find_first_not_of(" \t");
            if (begin != std::string::npos && line.compare(begin, 4, ".end") == 0 &&
                line.find_first_of(" \t", begin) == begin + 4) {
                return false;
            }
        }
        return true;
    });
    print_rows(rows);
}

}  // namespace

void add_list_command(CLI::App& app, Session& session) {
    CLI::App* command = app.add_subcommand("list", "List what configurations can name");
    command->require_subcommand(1);
    const auto add = [command](const char* name, const char* summary, auto action) {
        command->add_subcommand(name, summary)->callback(action);
    };
    add("isas", "Instruction sets, their cost models and parameters", [] { list_isas(); });
    add("topologies", "Kinds of wiring and their parameters", [] { list_topologies(); });
    add("programs", "Programs below programs/",
        [&session] { list_programs(config::make_locator(session.data)); });
    add("scenes", "Built-in objects and scene files",
        [&session] { list_scenes(config::make_locator(session.data)); });
}

}  // namespace rasterloom::cli
