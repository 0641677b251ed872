// SPDX-License-Identifier: MIT
#include "programs/vliw_renderer.hpp"

#include "isa/assembler.hpp"
#include "isa/vliw/scheduler.hpp"
#include "isa/vliw/vliw.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::test {
namespace {

using isa::vliw::Interpreter;
using isa::vliw::Program;

constexpr std::int64_t kScanlineCycles = 910;
constexpr std::int64_t kScanlinesAtMost = 1'000'000;
constexpr std::int64_t kBundlesAtOnce = 20'000'000;

isa::Image assembled(std::string_view source, const Defines& defines, Form form) {
    isa::AssemblerOptions options;
    options.include_dirs = {RASTERLOOM_SOURCE_DIR "/programs/vliw"};
    options.defines = defines;
    const isa::Assembly assembly =
        isa::assemble_text(isa::vliw::vliw_isa(), "stages.s", source, options);
    if (!assembly.ok()) {
        throw std::runtime_error(to_string(assembly.diagnostics));
    }
    return form == Form::packed ? isa::vliw::pack(assembly.image).image : assembly.image;
}

std::string include(std::string_view file) {
    return fmt::format(" .include \"{}\"\n", file);
}

std::string with_stubs(std::span<const std::string_view> files, std::string_view stubs,
                       std::string_view first) {
    std::string source = include("options.s") + include("memory.s") + include("dispatch.s");
    for (const std::string_view file : files) {
        source += include(file);
    }
    return source + fmt::format("{}\nfirst_procedure:\n setp {}\n line\n .end first_procedure\n",
                                stubs, first);
}

}  // namespace

VliwRenderer::VliwRenderer(std::span<const std::string_view> files, std::string_view stubs,
                           std::string_view first, const Defines& defines, std::int64_t lanes,
                           Form form)
    : VliwRenderer(assembled(with_stubs(files, stubs, first), defines, form), lanes) {}

VliwRenderer::VliwRenderer(std::string_view file, const Defines& defines, std::int64_t lanes,
                           Form form)
    : VliwRenderer(assembled(include(file), defines, form), lanes) {}

VliwRenderer::VliwRenderer(const isa::Image& image, std::int64_t lanes)
    : symbols_(image.symbols),
      program_(std::make_shared<const Program>(image)),
      machine_(program_, lanes),
      line_locked_(symbol("line_locked") != 0) {
    for (std::int64_t lane = 0; lane < lanes; ++lane) {
        write(lane, "lane", static_cast<int>(lane));
        write(lane, "column", static_cast<int>(lane));
        write(lane, "lanes", static_cast<int>(lanes));
    }
}

bool VliwRenderer::run() {
    for (std::int64_t lines = 0; lines < kScanlinesAtMost; ++lines) {
        if (const Ended ended = run_scanline(); ended != Ended::line) {
            return ended == Ended::halt;
        }
    }
    throw std::runtime_error("the program does not end");
}

Ended VliwRenderer::run_scanline() {
    for (;;) {
        const std::int64_t before = machine_.bundles_executed();
        const Interpreter::Stop stop = machine_.run(kBundlesAtOnce);
        bundles_.at(static_cast<std::size_t>(phase_)) += machine_.bundles_executed() - before;
        cycles_ += stop.cycles;
        switch (stop.reason) {
            case Interpreter::Reason::halt:
                return Ended::halt;
            case Interpreter::Reason::frame:
                return Ended::frame;
            case Interpreter::Reason::line:
                end_scanline();
                return Ended::line;
            case Interpreter::Reason::phase:
                phase_ = stop.phase;
                break;
            case Interpreter::Reason::trap:
                throw std::runtime_error(stop.trap);
            case Interpreter::Reason::budget:
                throw std::runtime_error(fmt::format("a procedure does not end, at bundle {}",
                                                     machine_.program_counter()));
        }
    }
}

void VliwRenderer::end_scanline() {
    if (line_locked_ && cycles_ > kScanlineCycles) {
        throw std::runtime_error(
            fmt::format("a scanline of {} cycles, procedure {}", cycles_, machine_.procedure()));
    }
    longest_ = std::max(longest_, cycles_);
    cycles_ = 0;
    machine_.set_aux(static_cast<std::size_t>(scanlines_) < aux.size()
                         ? aux[static_cast<std::size_t>(scanlines_)]
                         : std::uint16_t{0});
    ++scanlines_;
}

std::uint16_t VliwRenderer::symbol(std::string_view name) const {
    const auto found = symbols_.find(name);
    if (found == symbols_.end()) {
        throw std::runtime_error(fmt::format("no symbol {}", name));
    }
    return static_cast<std::uint16_t>(found->second);
}

Cost VliwRenderer::cost(std::string_view from_label, std::string_view to_label) const {
    Cost cost;
    for (std::size_t at = symbol(from_label); at < symbol(to_label); ++at) {
        const isa::vliw::Bundle& bundle = program_->bundles.at(at);
        ++cost.bundles;
        cost.cycles += cycles_of(bundle);
        cost.operations += operations_in(bundle);
    }
    return cost;
}

std::uint16_t VliwRenderer::read(std::int64_t lane, std::uint32_t address) const {
    return machine_.read(lane, address);
}

std::uint16_t VliwRenderer::read(std::int64_t lane, std::string_view name, int offset) const {
    return read(lane, static_cast<std::uint32_t>(symbol(name) + offset));
}

int VliwRenderer::passes(std::string_view counter) const {
    return read(0, counter) + (read(0, counter, 1) << 16);
}

void VliwRenderer::write(std::int64_t lane, std::uint32_t address,
                         std::span<const std::uint16_t> words) {
    machine_.write(lane, address, words);
}

void VliwRenderer::write(std::int64_t lane, std::string_view name, int value) {
    const std::array word = {static_cast<std::uint16_t>(value)};
    write(lane, symbol(name), word);
}

std::string complaint_about(std::string_view file, const Defines& options) {
    try {
        const VliwRenderer renderer(file, options, 1);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

}  // namespace rasterloom::test
