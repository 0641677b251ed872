// SPDX-License-Identifier: MIT
#include "machine/emulation/sweep_point.hpp"

#include "machine/config/export.hpp"
#include "machine/emulation/run.hpp"

#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

namespace rasterloom::emulation {

namespace {

std::string error_text(const std::exception& error) {
    std::string text = error.what();
    while (text.ends_with('\n')) {
        text.pop_back();
    }
    return text.empty() ? "an error without a message" : text;
}

// FNV-1a, 64 bits: nobody tries to find two configurations with one fingerprint.
class Hash {
  public:
    void add(std::string_view text) {
        for (const char c : text) {
            value_ = (value_ ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
        }
        value_ = (value_ ^ 0x100U) * 0x100000001b3U;  // no byte: an end
    }
    void add_file(const std::filesystem::path& path) {
        std::ifstream file(path, std::ios::binary);
        add(std::string{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()});
    }
    std::string text() const { return fmt::format("{:016x}", value_); }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325U;
};

void add_files(Hash& hash, const config::MachineDescription& machine) {
    hash.add_file(machine.nodes.program.path);
    if (machine.nodes.plugin) {
        hash.add_file(machine.nodes.plugin->path);
    }
    if (const auto file = machine.topology.parameters.find("file");
        file != machine.topology.parameters.end()) {
        hash.add_file(file->second);
    }
    if (machine.screen.map) {
        hash.add_file(machine.screen.map->path);
    }
    if (machine.scene && machine.scene->mesh) {
        hash.add_file(*machine.scene->mesh);
    }
    if (machine.scene && machine.scene->model) {
        hash.add_file(machine.scene->model->path);
    }
}

}  // namespace

std::string fingerprint(const config::SweepPoint& point, const config::Locator& locator) {
    Hash hash;
    try {
        const config::MachineDescription machine = config::load_point(point, locator);
        hash.add(config::export_machine(machine));
        add_files(hash, machine);
    } catch (const std::exception& error) {
        hash.add(error.what());
    }
    return hash.text();
}

observe::SweepResult run_point(const config::SweepPoint& point, const config::Locator& locator) {
    // First, so that a file that is changed meanwhile counts as changed.
    const std::string before = fingerprint(point, locator);
    RunOptions options;
    options.check_communication = false;
    observe::SweepResult result;
    try {
        const RunOutcome outcome = run_machine(config::load_point(point, locator), options);
        result = outcome.failure.empty() ? observe::result_of(outcome.report, outcome.wall_seconds)
                                         : observe::failed_result(outcome.failure);
    } catch (const std::exception& error) {
        result = observe::failed_result(error_text(error));
    }
    result.fingerprint = before;
    return result;
}

}  // namespace rasterloom::emulation
