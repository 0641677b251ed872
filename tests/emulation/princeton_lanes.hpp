// SPDX-License-Identifier: MIT
// Lanes with a program that has the names of programs/vliw.
#pragma once

#include "isa/assembler.hpp"
#include "isa/vliw/program.hpp"
#include "isa/vliw/vliw.hpp"
#include "machine/emulation/princeton_loader.hpp"

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace rasterloom {

inline constexpr const char* kNothing =
    "        .include \"memory.s\"\nstart:  halt\n        .end start\n";

// A program in programs/vliw.
inline isa::Image princeton_image(const std::string& source) {
    isa::AssemblerOptions folders;
    folders.include_dirs = {RASTERLOOM_SOURCE_DIR "/programs/vliw"};
    isa::Assembly assembly = isa::assemble_text(isa::vliw::vliw_isa(), "lanes.s", source, folders);
    if (!assembly.ok())
        throw std::runtime_error(to_string(assembly.diagnostics));
    return std::move(assembly.image);
}

class PrincetonLanes {
  public:
    explicit PrincetonLanes(std::int64_t lanes, const std::string& source = kNothing)
        : image_(princeton_image(source)),
          array_(std::make_shared<isa::vliw::Program>(image_), {.lanes = lanes}) {}

    void load(const host::TriangleScene& scene, const host::TriangleView& view = {},
              const host::TriangleLights& lights = {}) {
        load_princeton(array_, image_, scene, view, lights, columns());
    }

    ColumnMap columns() const { return columns_as_lanes(array_.lanes(), at("screen_columns")); }

    LockstepArray& array() { return array_; }
    const isa::Image& image() const { return image_; }
    std::uint32_t at(const std::string& symbol) const { return image_.symbol(symbol).value(); }
    // The word that a symbol names, or one behind it.
    std::uint16_t word(std::int64_t lane, const std::string& symbol, std::uint32_t offset = 0) {
        return array_.read(lane, at(symbol) + offset);
    }

  private:
    isa::Image image_;
    LockstepArray array_;
};

}  // namespace rasterloom
