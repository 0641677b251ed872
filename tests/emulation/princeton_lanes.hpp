// SPDX-License-Identifier: MIT
// Lanes that have the memory of programs/vliw and nothing to do.
#pragma once

#include "isa/assembler.hpp"
#include "isa/vliw/program.hpp"
#include "isa/vliw/vliw.hpp"
#include "machine/emulation/princeton_loader.hpp"

#include <memory>
#include <stdexcept>
#include <string>

namespace rasterloom {

// With the programs' names; `options`: lines in front.
inline isa::Image memory_image(const std::string& options = {}) {
    isa::AssemblerOptions folders;
    folders.include_dirs = {RASTERLOOM_SOURCE_DIR "/programs/vliw"};
    const std::string source = options +
                               "        .include \"memory.s\"\n"
                               "start:  halt\n"
                               "        .end start\n";
    const isa::Assembly assembly =
        isa::assemble_text(isa::vliw::vliw_isa(), "nothing.s", source, folders);
    if (!assembly.ok())
        throw std::runtime_error("memory.s: " + assembly.diagnostics.front().message);
    return assembly.image;
}

class PrincetonLanes {
  public:
    explicit PrincetonLanes(std::int64_t lanes, const std::string& options = {})
        : image_(memory_image(options)),
          array_(std::make_shared<isa::vliw::Program>(image_), {.lanes = lanes}) {}

    void load(const host::TriangleScene& scene, const host::TriangleView& view = {},
              const host::TriangleLights& lights = {}) {
        load_princeton(array_, image_, scene, view, lights, columns_as_lanes(array_.lanes()));
    }

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
