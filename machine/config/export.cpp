// SPDX-License-Identifier: MIT
#include "machine/config/export.hpp"

#include "machine/config/field.hpp"

#include <fmt/format.h>

namespace rasterloom::config {

namespace {

std::vector<std::string> split(const std::string& path) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    for (std::size_t dot = path.find('.'); dot != std::string::npos; dot = path.find('.', begin)) {
        parts.push_back(path.substr(begin, dot - begin));
        begin = dot + 1;
    }
    parts.push_back(path.substr(begin));
    return parts;
}

}  // namespace

std::string export_machine(const MachineDescription& machine) {
    std::string text;
    std::vector<std::string> open;  // the sections that the last line stands in
    for (const Field& field : machine_fields()) {
        const bool of_scene = field.path.starts_with("scene.");
        const std::string value = of_scene && !machine.scene ? std::string() : field.write(machine);
        if (value.empty() || value == "\"\"") {
            continue;
        }
        std::vector<std::string> parts = split(field.path);
        const std::string name = parts.back();
        parts.pop_back();
        std::size_t shared = 0;
        while (shared < open.size() && shared < parts.size() && open[shared] == parts[shared]) {
            ++shared;
        }
        for (std::size_t level = shared; level < parts.size(); ++level) {
            text += fmt::format("{:{}}{}:\n", "", 2 * level, parts[level]);
        }
        text += fmt::format("{:{}}{}: {}\n", "", 2 * parts.size(), name, value);
        open = parts;
    }
    return text;
}

std::string keys_as_markdown() {
    MachineDescription defaults;
    defaults.scene.emplace();
    std::string text = "| key | value | default | meaning |\n|---|---|---|---|\n";
    for (const Field& field : machine_fields()) {
        std::string value = field.required ? std::string("required") : field.write(defaults);
        if (value == "\"\"") {
            value.clear();
        }
        text +=
            fmt::format("| `{}` | {} | {} | {} |\n", field.path, field.expected,
                        value.empty() || field.required ? value : "`" + value + "`", field.summary);
    }
    return text;
}

}  // namespace rasterloom::config
