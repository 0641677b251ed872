// SPDX-License-Identifier: MIT
// The keys of a machine: everything but the scene.
#include "machine/config/array_fields.hpp"
#include "machine/config/bucket_fields.hpp"
#include "machine/config/fabric_fields.hpp"
#include "machine/config/field.hpp"
#include "machine/config/field_builders.hpp"
#include "machine/config/scene_fields.hpp"
#include "machine/config/yaml_text.hpp"

#include <algorithm>
#include <cctype>

namespace rasterloom::config {

namespace {

FileReference find_file(const Value& value, const Locator& locator,
                        const std::filesystem::path& fallback) {
    const std::string& name = scalar_text(value);
    const auto found = locator.find(name, value.where.source, fallback);
    if (!found) {
        throw std::invalid_argument("no such file (looked in " +
                                    Locator::places(value.where.source, fallback) + ")");
    }
    return {name, *found};
}

Field machine_name_field() {
    return {"machine",
            "a name",
            "what this machine is called in reports",
            false,
            [](MachineDescription& machine, const Value& value, const Locator&) {
                machine.machine = scalar_text(value);
            },
            [](const MachineDescription& machine) { return yaml_scalar(machine.machine); }};
}

std::string find_graph(const Value& value, const Locator& locator) {
    try {
        return find_file(value, locator, locator.configs()).path.string();
    } catch (const std::invalid_argument& problem) {
        refuse(value.where, "topology.file", scalar_text(value), problem.what(),
               "an edge list or a GraphML file");
    }
}

void read_topology(MachineDescription& machine, const Value& value, const Locator& locator) {
    if (value.kind != Value::Kind::mapping) {
        throw std::invalid_argument(std::string(kind_name(value.kind)) +
                                    " where a mapping belongs");
    }
    machine.topology = {};
    for (const Entry& entry : value.entries) {
        machine.written["topology." + entry.key] = entry.value.where;
        if (entry.key == "kind") {
            machine.topology.kind = scalar_text(entry.value);
        } else if (entry.key == "file") {
            machine.topology.parameters["file"] = find_graph(entry.value, locator);
        } else {
            machine.topology.parameters[entry.key] = scalar_text(entry.value);
        }
    }
    if (machine.topology.kind.empty()) {
        throw std::invalid_argument("no kind");
    }
}

Field topology_field() {
    return {"topology",
            "a mapping with a kind and its parameters, such as { kind: geodesic, b: 4, c: 4 }",
            "the wiring: see `rasterloom list topologies` for kinds and their parameters",
            true,
            read_topology,
            [](const MachineDescription& machine) {
                std::string text = "{ kind: " + yaml_scalar(machine.topology.kind);
                for (const auto& [name, value] : machine.topology.parameters) {
                    text += ", " + name + ": " + yaml_scalar(value);
                }
                return text + " }";
            }};
}

void read_cost(MachineDescription& machine, const Value& value, const Locator&) {
    if (value.kind != Value::Kind::mapping) {
        throw std::invalid_argument(std::string(kind_name(value.kind)) +
                                    " where a mapping belongs");
    }
    machine.nodes.cost = {};
    for (const Entry& entry : value.entries) {
        machine.written["nodes.cost." + entry.key] = entry.value.where;
        if (entry.key == "model") {
            machine.nodes.cost.model = scalar_text(entry.value);
            continue;
        }
        const std::int64_t cycles = parse_count(scalar_text(entry.value));
        if (cycles < 0 || cycles > 10'000) {
            throw std::invalid_argument("out of range: " + entry.key);
        }
        machine.nodes.cost.overrides[entry.key] = cycles;
    }
}

Field cost_field() {
    return {"nodes.cost",
            "a mapping with a model and cycles, such as { model: strothotte, move: 1, branch: 1 }",
            "the cost model and its numbers, in cycles (0 to 10000): see `rasterloom list isas`",
            false,
            read_cost,
            [](const MachineDescription& machine) {
                std::vector<std::string> parts;
                if (!machine.nodes.cost.model.empty()) {
                    parts.push_back("model: " + yaml_scalar(machine.nodes.cost.model));
                }
                for (const auto& [name, cycles] : machine.nodes.cost.overrides) {
                    parts.push_back(fmt::format("{}: {}", name, cycles));
                }
                return parts.empty() ? std::string()
                                     : fmt::format("{{ {} }}", fmt::join(parts, ", "));
            }};
}

Field isa_field() {
    return {"nodes.isa",
            "the name of an instruction set",
            "the instruction set the nodes run: see `rasterloom list isas`",
            false,
            [](MachineDescription& machine, const Value& value, const Locator&) {
                machine.nodes.isa = scalar_text(value);
            },
            [](const MachineDescription& machine) { return yaml_scalar(machine.nodes.isa); }};
}

Field plugin_field() {
    return {"nodes.plugin",
            "the path of a shared object",
            "a shared object that supplies the instruction set `nodes.isa`",
            false,
            [](MachineDescription& machine, const Value& value, const Locator& locator) {
                machine.nodes.plugin = find_file(value, locator, {});
            },
            [](const MachineDescription& machine) {
                return machine.nodes.plugin ? yaml_scalar(machine.nodes.plugin->path.string()) : "";
            }};
}

Field clock_field() {
    return {"nodes.clock",
            "a period such as 300ns or a frequency such as 14MHz",
            "one cycle of a node",
            false,
            [](MachineDescription& machine, const Value& value, const Locator&) {
                machine.nodes.clock = parse_clock(scalar_text(value));
            },
            [](const MachineDescription& machine) { return format_clock(machine.nodes.clock); }};
}

Field program_field() {
    return {
        "nodes.program",
        "a file: .s is assembled, .bin is a raw image, anything else an a.out file",
        "what every node runs, but for hardware rasterizers; looked for beside the configuration, "
        "then under programs/",
        true,
        [](MachineDescription& machine, const Value& value, const Locator& locator) {
            machine.nodes.program = find_file(value, locator, locator.programs());
        },
        [](const MachineDescription& machine) {
            const std::string path = machine.nodes.program.path.string();
            return path.empty() ? path : yaml_scalar(path);
        }};
}

void read_symbols(MachineDescription& machine, const Value& value, const Locator&) {
    if (value.kind != Value::Kind::mapping) {
        throw std::invalid_argument(std::string(kind_name(value.kind)) +
                                    " where a mapping belongs");
    }
    machine.nodes.symbols.clear();
    for (const Entry& entry : value.entries) {
        machine.written["nodes.symbols." + entry.key] = entry.value.where;
        const bool is_name =
            !entry.key.empty() && std::all_of(entry.key.begin(), entry.key.end(), [](char c) {
                return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$' ||
                       c == '.';
            });
        if (!is_name || std::isdigit(static_cast<unsigned char>(entry.key[0])) != 0) {
            throw std::invalid_argument("not the name of a symbol: " + entry.key);
        }
        const std::int64_t number = parse_count(scalar_text(entry.value));
        if (number < -32768 || number > 65535) {
            throw std::invalid_argument("out of range: " + entry.key);
        }
        machine.nodes.symbols[entry.key] = number;
    }
}

Field symbols_field() {
    return {"nodes.symbols",
            "a mapping of symbols to whole numbers from -32768 to 65535, such as { full: 0 }",
            "symbols set before the first line of a program that is assembled; its first comment "
            "says which it knows",
            false,
            read_symbols,
            [](const MachineDescription& machine) {
                std::vector<std::string> parts;
                for (const auto& [name, number] : machine.nodes.symbols) {
                    parts.push_back(fmt::format("{}: {}", yaml_scalar(name), number));
                }
                return parts.empty() ? std::string()
                                     : fmt::format("{{ {} }}", fmt::join(parts, ", "));
            }};
}

Field load_address_field() {
    return {"nodes.load_address",
            "a byte address such as 0o1000, 0x200 or 512",
            "where a raw image is loaded",
            false,
            [](MachineDescription& machine, const Value& value, const Locator&) {
                machine.nodes.load_address = parse_address(scalar_text(value));
            },
            [](const MachineDescription& machine) {
                return fmt::format("0o{:o}", machine.nodes.load_address);
            }};
}

Field entry_field() {
    return {"nodes.entry",
            "a byte address such as 0o1000, 0x200 or 512",
            "first instruction; default: what the program says, for a raw image its load address",
            false,
            [](MachineDescription& machine, const Value& value, const Locator&) {
                machine.nodes.entry = parse_address(scalar_text(value));
            },
            [](const MachineDescription& machine) {
                return machine.nodes.entry ? fmt::format("0o{:o}", *machine.nodes.entry) : "";
            }};
}

Field phases_field() {
    return {"nodes.phases_per_frame",
            "a whole number from 1 to 1000",
            "phases of a frame; default: the program's symbol phases_per_frame, else 1",
            false,
            [](MachineDescription& machine, const Value& value, const Locator&) {
                const std::int64_t phases = parse_count(scalar_text(value));
                if (phases < 1 || phases > 1000) {
                    throw std::invalid_argument("out of range");
                }
                machine.nodes.phases_per_frame = phases;
            },
            [](const MachineDescription& machine) {
                return machine.nodes.phases_per_frame
                           ? std::to_string(*machine.nodes.phases_per_frame)
                           : std::string();
            }};
}

void add_node_fields(std::vector<Field>& fields) {
    fields.push_back(isa_field());
    fields.push_back(plugin_field());
    fields.push_back(clock_field());
    fields.push_back(cost_field());
    fields.push_back(bytes_field(
        "nodes.memory", "private memory of a node", 256, 16 << 20,
        [](auto& machine) -> auto& { return machine.nodes.memory; }));
    fields.push_back(program_field());
    fields.push_back(symbols_field());
    fields.push_back(load_address_field());
    fields.push_back(entry_field());
    fields.push_back(phases_field());
    fields.push_back(yes_no_field(
        "nodes.pack",
        "whether the assembler packs straight-line code into bundles by itself, where an "
        "instruction word has several slots",
        [](auto& machine) -> auto& { return machine.nodes.pack; }));
}

void add_link_fields(std::vector<Field>& fields) {
    fields.push_back(duration_field(
        "links.time_per_byte", "transfer time of a byte",
        [](auto& machine) -> auto& { return machine.links.time_per_byte; }));
    fields.push_back(duration_field(
        "links.time_per_message", "transfer time of a message beside its bytes",
        [](auto& machine) -> auto& { return machine.links.time_per_message; }));
    fields.push_back(duration_field(
        "links.latency", "from the end of a transfer to the message's arrival; at least 2ps",
        [](auto& machine) -> auto& { return machine.links.latency; }));
    fields.push_back(count_field(
        "links.input_queue", "messages that wait at a port to be received", 1, 65535,
        [](auto& machine) -> auto& { return machine.links.input_queue; }));
    fields.push_back(count_field(
        "links.output_queue", "messages that wait at a port to be sent", 1, 65535,
        [](auto& machine) -> auto& { return machine.links.output_queue; }));
    fields.push_back(bytes_field(
        "links.max_message", "the longest message", 1, 65535,
        [](auto& machine) -> auto& { return machine.links.max_message; }));
    fields.push_back(choice_field<SendPolicy>(
        "links.send", "whether a node's ports take turns or work side by side",
        {{"one_at_a_time", SendPolicy::one_at_a_time}, {"each_port", SendPolicy::each_port}},
        [](auto& machine) -> auto& { return machine.links.send; }));
}

}  // namespace

std::vector<Field> machine_fields() {
    std::vector<Field> fields{machine_name_field(), topology_field()};
    add_node_fields(fields);
    add_array_fields(fields);
    add_link_fields(fields);
    add_fabric_fields(fields);
    add_bucket_fields(fields);
    fields.push_back(duration_field(
        "supervisor.latency", "from the end of a phase to its announcement; at least 2ps",
        [](auto& machine) -> auto& { return machine.supervisor.latency; }));
    fields.push_back(count_field(
        "screen.width", "pixels", 1, 4096,
        [](auto& machine) -> auto& { return machine.screen.width; }));
    fields.push_back(count_field(
        "screen.height", "pixels", 1, 4096,
        [](auto& machine) -> auto& { return machine.screen.height; }));
    fields.push_back(file_field(
        "screen.map", "a file of rectangles (.map)",
        "which lane of an array draws which column of the program's screen, where not "
        "lane i column i; looked for beside the configuration",
        [](auto& machine) -> auto& { return machine.screen.map; }));
    add_scene_fields(fields);
    fields.push_back(count_field(
        "run.frames", "frames to draw", 1, 100000,
        [](auto& machine) -> auto& { return machine.run.frames; }));
    fields.push_back(duration_field(
        "run.max_time", "machine time after which the run is given up; above zero",
        [](auto& machine) -> auto& { return machine.run.max_time; }));
    fields.push_back(optional_count_field(
        "run.threads", "threads of the host that emulate the machine; nothing else depends on it",
        "auto", 1, 256, [](auto& machine) -> auto& { return machine.run.threads; }));
    return fields;
}

}  // namespace rasterloom::config
