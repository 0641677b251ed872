// SPDX-License-Identifier: MIT
// rasterloom assemble: a program's raw image, its listing, or only its errors.
#include "isa/assembler.hpp"
#include "isa/disassembler.hpp"
#include "isa/image_files.hpp"
#include "isa/listing.hpp"
#include "machine/cli/command.hpp"
#include "machine/config/locator.hpp"
#include "machine/config/units.hpp"
#include "machine/emulation/programs.hpp"
#include "machine/observe/output_folder.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

namespace rasterloom::cli {

namespace {

struct AssembleOptions {
    std::string source;
    std::string output;
    bool listing = false;
    bool pack = false;
    std::string isa = "pdp11";
    std::string plugin;
    std::string cost;
    std::vector<std::string> include_dirs;
    std::vector<std::string> defines;
};

[[noreturn]] void refuse_option(const std::string& option, const std::string& value,
                                const std::string& what, const std::string& expected = {}) {
    config::refuse({option, 0, 0}, {}, value, what, expected);
}

isa::AssemblerOptions assembler_options(const AssembleOptions& options) {
    isa::AssemblerOptions result;
    result.include_dirs.assign(options.include_dirs.begin(), options.include_dirs.end());
    for (const std::string& define : options.defines) {
        const std::size_t equals = define.find('=');
        try {
            const std::string value = equals == std::string::npos ? "1" : define.substr(equals + 1);
            result.defines[define.substr(0, equals)] = config::parse_address(value);
        } catch (const std::invalid_argument& problem) {
            refuse_option("--define", define, problem.what(),
                          "NAME=VALUE, such as SIZE=512 or SIZE=0o1000");
        }
    }
    return result;
}

const isa::Isa& choose_isa(isa::IsaRegistry& registry, const AssembleOptions& options) {
    try {
        return options.plugin.empty() ? registry.find(options.isa) : registry.load(options.plugin);
    } catch (const std::exception& problem) {
        refuse_option(options.plugin.empty() ? "--isa" : "--plugin", {}, problem.what());
    }
}

std::string listing_of(const isa::Assembly& assembly, const isa::Isa& isa,
                       const std::string& cost) {
    try {
        return isa::make_listing(assembly, isa, {cost, {}});
    } catch (const std::invalid_argument& problem) {
        refuse_option("--cost", {}, problem.what());
    }
}

// The image packed; its disassembly, where a listing is asked for, and the report.
isa::Image packed_image(const isa::Image& image, const isa::Isa& isa, bool listing) {
    auto packed = isa.pack(image);
    if (!packed) {
        refuse_option("--pack", std::string(isa.name()), "its instructions cannot be packed");
    }
    if (listing) {
        fmt::print("{}\n{}", isa::disassemble(isa::dialect_of(isa), packed->image), packed->report);
    } else {
        fmt::print(stderr, "{}", packed->report);
    }
    return std::move(packed->image);
}

void assemble(const AssembleOptions& options, const Session& session) {
    isa::IsaRegistry registry = emulation::built_in_isas();
    const isa::Isa& isa = choose_isa(registry, options);
    const config::Locator locator = config::make_locator(session.data);
    const auto source = locator.find(options.source, ".", locator.programs());
    // As the user wrote it, so that messages do; from the data folder only when it is not here.
    const std::filesystem::path path = source && !std::filesystem::exists(options.source)
                                           ? *source
                                           : std::filesystem::path(options.source);
    isa::Assembly assembly = isa::assemble_file(isa, path, assembler_options(options));
    if (!assembly.ok()) {
        throw isa::AssemblyError(assembly.diagnostics);
    }
    if (options.pack) {
        assembly.image = packed_image(assembly.image, isa, options.listing);
    } else if (options.listing) {
        fmt::print("{}", listing_of(assembly, isa, options.cost));
    }
    const std::vector<std::uint8_t> bytes = isa::raw_bytes(assembly.image);
    const std::uint32_t lowest = assembly.image.segments.empty()
                                     ? 0
                                     : assembly.image.segments.front().address /
                                           static_cast<std::uint32_t>(isa.address_unit());
    if (!options.output.empty()) {
        observe::write_file_whole(options.output,
                                  {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
    if (!options.listing) {
        fmt::print("{}: {} bytes, load address 0o{:o}, entry 0o{:o}\n", options.source,
                   bytes.size(), lowest, assembly.image.entry);
    }
}

}  // namespace

void add_assemble_command(CLI::App& app, Session& session) {
    auto options = std::make_shared<AssembleOptions>();
    CLI::App* command =
        app.add_subcommand("assemble", "Assemble a program: errors, listing, raw image");
    command
        ->add_option("source", options->source, "The program; looked for here, then in programs/")
        ->required()
        ->type_name("FILE");
    command
        ->add_option("-o,--output", options->output,
                     "Write the raw image: bytes from the lowest address up")
        ->type_name("FILE");
    command->add_flag("--listing", options->listing,
                      "Print address, words, fetch and data cycles, source");
    command->add_flag("--pack", options->pack,
                      "Pack straight-line code into fewer instruction words, and report how far; "
                      "--listing shows the result");
    command->add_option("--cost", options->cost,
                        "Cost model of the listing (rasterloom list isas)");
    command->add_option("--isa", options->isa, "Instruction set")->capture_default_str();
    command->add_option("--plugin", options->plugin, "Instruction set from a shared object")
        ->type_name("FILE");
    command
        ->add_option("-I,--include", options->include_dirs, "Folder to look for included files in")
        ->type_name("DIR");
    command->add_option("-D,--define", options->defines, "Set a symbol before the first line")
        ->type_name("NAME=VALUE");
    command->callback([options, &session] { assemble(*options, session); });
}

}  // namespace rasterloom::cli
