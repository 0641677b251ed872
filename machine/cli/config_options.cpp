// SPDX-License-Identifier: MIT
#include "machine/cli/config_options.hpp"

#include "machine/config/load.hpp"
#include "machine/config/locator.hpp"
#include "machine/host/polygon_scenes.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace rasterloom::cli {

CLI::Option* add_machine_source(CLI::App& command, CLI::App& group, ConfigOptions& options,
                                const std::string& summary) {
    CLI::Option* const machine =
        group.add_option("--machine", options.file, summary)->type_name("FILE");
    command
        .add_option("--set", options.overrides,
                    "Change a value of the machine's configuration; may be given several times")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false)
        ->needs(machine);
    return machine;
}

void add_config_options(CLI::App& command, ConfigOptions& options) {
    command.add_option("config", options.file, "The machine; looked for here, then in configs/")
        ->required()
        ->type_name("FILE");
    command
        .add_option("--set", options.overrides,
                    "Change a value of the configuration; may be given several times")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command
        .add_option("--mesh", options.mesh,
                    "Draw this mesh (any format that assimp reads): scene.object, or scene.model "
                    "of a scene that has one")
        ->type_name("FILE");
}

namespace {

// A polygon scene shows the mesh in its model's place; otherwise the mesh is the scene.
const char* mesh_key(const config::MachineDescription& machine) {
    const host::PolygonScene* scene = machine.scene && !machine.scene->mesh
                                          ? host::find_polygon_scene(machine.scene->object)
                                          : nullptr;
    return scene != nullptr && scene->takes_model ? "scene.model" : "scene.object";
}

config::MachineDescription load(const ConfigOptions& options, const Session& session,
                                std::vector<config::Override> last) {
    std::vector<config::Override> changes;
    for (const std::string& text : options.overrides) {
        changes.push_back(config::parse_override(text));
    }
    const auto add = [&changes](const char* key, const std::string& value, const char* option) {
        if (!value.empty()) {
            changes.push_back(config::make_override(key, value, option));
        }
    };
    add("run.frames", options.frames, "--frames");
    add("run.max_time", options.max_time, "--max-time");
    add("run.threads", options.threads, "--threads");
    const config::Locator locator = config::make_locator(session.data);
    if (!options.mesh.empty()) {
        add(mesh_key(config::load_machine(options.file, changes, locator)), options.mesh, "--mesh");
    }
    std::move(last.begin(), last.end(), std::back_inserter(changes));
    return config::load_machine(options.file, changes, locator);
}

}  // namespace

config::MachineDescription load(const ConfigOptions& options, const Session& session) {
    return load(options, session, std::vector<config::Override>());
}

config::MachineDescription load(const ConfigOptions& options, const Session& session,
                                const config::Override& change) {
    return load(options, session, std::vector{change});
}

}  // namespace rasterloom::cli
