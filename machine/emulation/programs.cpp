// SPDX-License-Identifier: MIT
#include "machine/emulation/programs.hpp"

#include "isa/assembler.hpp"
#include "isa/cost_choice.hpp"
#include "isa/diagnostic.hpp"
#include "isa/image_files.hpp"
#include "isa/pdp11/pdp11.hpp"
#include "isa/vliw/vliw.hpp"
#include "machine/emulation/scene_kind.hpp"

#include <stdexcept>

namespace rasterloom::emulation {

using config::MachineDescription;

namespace {

isa::Image read_image(const MachineDescription& machine) {
    const auto& path = machine.nodes.program.path;
    const auto memory = static_cast<std::uint32_t>(machine.nodes.memory);
    if (path.extension() == ".bin") {
        const std::uint32_t load_address = machine.nodes.load_address;
        return isa::read_raw_image(path, load_address, machine.nodes.entry.value_or(load_address),
                                   memory);
    }
    return isa::read_aout_image(path);
}

// With the symbols that the machine itself defines, where the program asks for them.
isa::AssemblerOptions assembler_options(const MachineDescription& machine) {
    isa::AssemblerOptions options;
    options.defines.insert(machine.nodes.symbols.begin(), machine.nodes.symbols.end());
    const auto define = [&](const char* name, std::int64_t value) {
        if (options.defines.contains(name)) {
            throw machine.error(std::string("nodes.symbols.") + name, {},
                                "is set by the machine itself", "no such symbol");
        }
        options.defines[name] = value;
    };
    define("frame_buffer_bus",
           !machine.fabric.ideal && machine.fabric.frame_buffer == config::FrameBufferKind::bus);
    define("half_digested", machine.fabric.half_digested);
    define("line_locked", machine.array.line_locked);
    define("scanlines", machine.array.lines);
    define("boxes", machine.scene && scene_kind(machine) == SceneKind::boxes);
    define("textured", machine.scene && machine.scene->texture.name != "none");
    return options;
}

isa::Image assemble(const isa::Isa& isa, const MachineDescription& machine) {
    const auto& program = machine.nodes.program;
    isa::Assembly assembly = isa::assemble_file(isa, program.path, assembler_options(machine));
    if (!assembly.ok()) {
        throw isa::AssemblyError(std::move(assembly.diagnostics));
    }
    for (const std::string& name : assembly.unused_defines) {
        if (machine.nodes.symbols.contains(name)) {
            throw machine.error("nodes.symbols." + name, {},
                                "the program " + program.text + " does not ask for this symbol",
                                "a symbol that it tests with .if or .ifndf");
        }
    }
    if (machine.nodes.pack) {
        if (auto packed = isa.pack(assembly.image)) {
            return std::move(packed->image);
        }
    }
    return std::move(assembly.image);
}

}  // namespace

isa::IsaRegistry built_in_isas() {
    isa::IsaRegistry registry;
    registry.add(isa::pdp11::pdp11_isa());
    registry.add(isa::vliw::vliw_isa());
    return registry;
}

const isa::Isa& select_isa(isa::IsaRegistry& registry, const MachineDescription& machine) {
    const auto& nodes = machine.nodes;
    if (nodes.plugin) {
        try {
            const isa::Isa& loaded = registry.load(nodes.plugin->path);
            if (!machine.written.contains("nodes.isa") || nodes.isa == loaded.name()) {
                return loaded;
            }
        } catch (const std::exception& problem) {
            throw machine.error("nodes.plugin", {}, problem.what());
        }
    }
    try {
        return registry.find(nodes.isa);
    } catch (const std::invalid_argument& problem) {
        throw machine.error("nodes.isa", {}, problem.what());
    }
}

isa::Image load_program(const isa::Isa& isa, const MachineDescription& machine) {
    const auto& program = machine.nodes.program;
    isa::Image image;
    if (program.path.extension() == ".s") {
        image = assemble(isa, machine);
    } else {
        if (!machine.nodes.symbols.empty()) {
            throw machine.error("nodes.symbols", {},
                                "the program " + program.text + " is not assembled",
                                "no symbols, or a program whose name ends in .s");
        }
        try {
            image = read_image(machine);
        } catch (const isa::ImageError& problem) {
            throw machine.error("nodes.program", {}, problem.what());
        }
    }
    if (machine.nodes.entry) {
        image.entry = *machine.nodes.entry;
    }
    if (isa.address_unit() > 1) {
        return image;  // the program is not in the nodes' memory
    }
    for (const isa::Segment& segment : image.segments) {
        if (segment.address + segment.bytes.size() >
            static_cast<std::size_t>(machine.nodes.memory)) {
            throw machine.error(
                "nodes.memory", std::to_string(machine.nodes.memory),
                "the program " + program.text + " does not fit",
                "at least " + std::to_string(segment.address + segment.bytes.size()) + " bytes");
        }
    }
    return image;
}

isa::CostChoice cost_choice(const MachineDescription& machine) {
    isa::CostChoice choice{machine.nodes.cost.model, {}};
    choice.overrides.insert(machine.nodes.cost.overrides.begin(),
                            machine.nodes.cost.overrides.end());
    return choice;
}

std::shared_ptr<const isa::PreparedProgram> prepare_program(const isa::Isa& isa,
                                                            const isa::Image& image,
                                                            const MachineDescription& machine) {
    try {
        isa::resolve_costs(isa.name(), isa.cost_models(), cost_choice(machine));
    } catch (const std::invalid_argument& problem) {
        throw machine.error("nodes.cost", {}, problem.what());
    }
    try {
        return isa.prepare(image, cost_choice(machine));
    } catch (const std::invalid_argument& problem) {
        throw machine.error(machine.nodes.entry ? "nodes.entry" : "nodes.program", {},
                            problem.what());
    }
}

}  // namespace rasterloom::emulation
