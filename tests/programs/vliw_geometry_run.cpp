// SPDX-License-Identifier: MIT
#include "programs/vliw_geometry_run.hpp"

#include "isa/assembler.hpp"
#include "isa/vliw/scheduler.hpp"
#include "isa/vliw/vliw.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::test {

namespace {

constexpr std::string_view kMain = R"(
        callp
start:  setp    geometry
        line
communicate:
        halt
        .include "geometry.s"
        .end    start
)";
constexpr std::int64_t kMostBundles = 2'000'000;

struct Assembled {
    isa::Image image;
    std::shared_ptr<const isa::vliw::Program> program;
};

Assembled assembled(bool textured, bool packed) {
    isa::AssemblerOptions options;
    options.include_dirs = {RASTERLOOM_SOURCE_DIR "/programs/vliw"};
    options.defines["textured"] = textured ? 1 : 0;
    isa::Assembly assembly =
        isa::assemble_text(isa::vliw::vliw_isa(), "geometry_main.s", kMain, options);
    if (!assembly.ok()) {
        throw std::runtime_error(to_string(assembly.diagnostics));
    }
    const isa::Image image = packed ? isa::vliw::pack(assembly.image).image : assembly.image;
    return {image, std::make_shared<const isa::vliw::Program>(image)};
}

const Assembled& program(const VliwGeometryOptions& options) {
    static std::map<std::pair<bool, bool>, Assembled> programs;
    const std::pair key{options.textured, options.packed};
    if (!programs.contains(key)) {
        programs.emplace(key, assembled(options.textured, options.packed));
    }
    return programs.at(key);
}

// Tables as memory.s defines them.
std::vector<std::uint16_t> reciprocals() {
    std::vector<std::uint16_t> table{65535};
    for (int z = 1; z < 0x8000; ++z) {
        table.push_back(
            static_cast<std::uint16_t>(std::min(std::round(std::exp2(28) / z), 65535.0)));
    }
    return table;
}

std::vector<std::uint16_t> roots() {
    std::vector<std::uint16_t> table;
    for (int m = 128; m < 512; ++m) {
        table.push_back(static_cast<std::uint16_t>(std::round(std::exp2(18) / std::sqrt(2.0 * m))));
    }
    return table;
}

template <typename Range>
std::vector<std::uint16_t> as_words(const Range& values) {
    std::vector<std::uint16_t> words;
    for (const auto value : values) {
        words.push_back(static_cast<std::uint16_t>(value));
    }
    return words;
}

}  // namespace

std::vector<std::uint16_t> words_of(const VliwPolygon& polygon) {
    std::vector<std::uint16_t> words;
    for (const VliwVertex& vertex : polygon.vertices) {
        std::ranges::copy(as_words(vertex.place), std::back_inserter(words));
        std::ranges::copy(as_words(vertex.normal), std::back_inserter(words));
        words.push_back(static_cast<std::uint16_t>(vertex.u << 8 | vertex.v));
    }
    std::ranges::copy(polygon.colour, std::back_inserter(words));
    return words;
}

VliwGeometryRun::VliwGeometryRun(const VliwView& view, const VliwLights& lights,
                                 const std::vector<VliwDatabase>& lanes, const Options& options)
    : options_(options),
      image_(program(options).image),
      machine_(program(options).program, static_cast<std::int64_t>(lanes.size())) {
    std::size_t most = 0;
    for (const VliwDatabase& polygons : lanes) {
        most = std::max(most, polygons.size());
    }
    for (int lane = 0; const VliwDatabase& polygons : lanes) {
        load_lane(lane, view, lights, polygons);
        poke(lane, symbol("most"), {static_cast<std::uint16_t>(most)});
        before_.push_back(fast_memory(lane));
        ++lane;
    }
    run();
}

std::uint32_t VliwGeometryRun::symbol(std::string_view name) const {
    const auto value = image_.symbol(name);
    if (!value) {
        throw std::runtime_error(fmt::format("no symbol {}", name));
    }
    return *value;
}

std::uint16_t VliwGeometryRun::word(int lane, std::uint32_t address) const {
    return machine_.read(lane, address);
}

void VliwGeometryRun::poke(int lane, std::uint32_t address,
                           const std::vector<std::uint16_t>& words) {
    machine_.write(lane, address, words);
}

// The database lies behind the array, with a gap that must stay as it is before, between and
// behind them.
void VliwGeometryRun::load_lane(int lane, const VliwView& view, const VliwLights& lights,
                                const VliwDatabase& polygons) {
    const std::uint32_t array = symbol("scratch_end") + 10;
    const std::uint32_t array_end =
        array + static_cast<std::uint32_t>(options_.room) * symbol("kDescriptor");
    const std::uint32_t database = array_end + 10;
    const std::uint32_t first = symbol("source_count");
    poke(lane, first, std::vector<std::uint16_t>(0x8000 - first, 0xdead));
    for (std::uint32_t address = database; const VliwPolygon& polygon : polygons) {
        poke(lane, address, words_of(polygon));
        address += symbol("kPolygon");
    }
    poke(lane, symbol("reciprocals"), reciprocals());
    poke(lane, symbol("roots"), roots());
    poke(lane, symbol("polygons"),
         as_words(
             std::array{static_cast<std::uint32_t>(polygons.size()), database, array, array_end}));
    poke(lane, symbol("matrix"), as_words(view.matrix));
    poke(lane, symbol("focal"), as_words(std::array{view.focal, view.near}));
    poke(lane, symbol("ambient"), as_words(std::array{lights.ambient}));
    poke(lane, symbol("sun"), as_words(lights.sun));
    poke(lane, symbol("sun_diffuse"),
         as_words(std::array{lights.sun_diffuse, lights.sun_specular}));
    poke(lane, symbol("lamp"), as_words(lights.lamp));
    poke(lane, symbol("lamp_diffuse"),
         as_words(std::array{lights.lamp_diffuse, lights.lamp_specular, lights.shininess}));
}

std::string VliwGeometryRun::procedure_name() const {
    for (const char* name : {"geometry", "transform", "light", "communicate"}) {
        if (image_.symbol(name) == machine_.procedure()) {
            return name;
        }
    }
    return "start";
}

void VliwGeometryRun::run() {
    using Reason = isa::vliw::Interpreter::Reason;
    while (machine_.bundles_executed() < kMostBundles) {
        const std::string name = procedure_name();
        const std::int64_t bundles = machine_.bundles_executed();
        const std::int64_t operations = machine_.operations_executed();
        const auto stop = machine_.run(kMostBundles);
        Cost& cost = costs_[name];
        ++cost.calls;
        cost.bundles += machine_.bundles_executed() - bundles;
        cost.operations += machine_.operations_executed() - operations;
        cost.longest = std::max(cost.longest, machine_.bundles_executed() - bundles);
        if (stop.reason == Reason::halt) {
            reached_communication_ = name == "communicate";
            return;
        }
        if (name == "geometry" && options_.next_view) {
            for (int lane = 0; lane < machine_.lanes(); ++lane) {
                poke(lane, symbol("matrix"), as_words(options_.next_view->matrix));
            }
        }
        if (stop.reason != Reason::line) {
            throw std::runtime_error(
                fmt::format("{} at bundle {}: {}", name, machine_.program_counter(), stop.trap));
        }
    }
    throw std::runtime_error("the geometry stage does not end");
}

std::vector<VliwDescriptor> VliwGeometryRun::descriptors(int lane) const {
    std::vector<VliwDescriptor> result;
    std::uint32_t address = word(lane, symbol("source_at"));
    for (int i = 0; i < word(lane, symbol("source_count")); ++i) {
        VliwDescriptor& descriptor = result.emplace_back();
        for (std::uint32_t k = 0; k < symbol("kDescriptor"); ++k) {
            descriptor.push_back(word(lane, address++));
        }
    }
    return result;
}

bool VliwGeometryRun::kept_its_place(int lane) const {
    std::vector<std::uint16_t> now = fast_memory(lane);
    std::vector<std::uint16_t> before = before_[static_cast<std::size_t>(lane)];
    const auto forget = [&](std::uint32_t from, std::uint32_t to) {
        for (auto* memory : {&now, &before}) {
            std::fill(memory->begin() + from, memory->begin() + to, std::uint16_t{0});
        }
    };
    forget(symbol("geometry_scratch"), symbol("other_scratch"));
    forget(symbol("source_count"), symbol("source_count") + 1);
    forget(symbol("error"), symbol("error") + 1);
    forget(word(lane, symbol("source_at")), word(lane, symbol("source_end")));
    return now == before;
}

std::vector<std::uint16_t> VliwGeometryRun::fast_memory(int lane) const {
    std::vector<std::uint16_t> words;
    for (std::uint32_t address = 0; address < isa::vliw::kBankWords; ++address) {
        words.push_back(word(lane, address));
    }
    return words;
}

}  // namespace rasterloom::test
