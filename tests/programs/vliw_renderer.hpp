// SPDX-License-Identifier: MIT
// Stages of the VLIW's renderers on the interpreter, for tests: assembled with stubs for their
// neighbours, started at any procedure.
#pragma once

#include "isa/image.hpp"
#include "isa/vliw/interpreter.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::test {

using Defines = std::map<std::string, std::int64_t, std::less<>>;
using Words = std::vector<std::uint16_t>;

constexpr int kDescriptorWords = 42;
using DescriptorWords = std::array<std::uint16_t, kDescriptorWords>;

enum class Ended : std::uint8_t { line, halt, frame };
enum class Form : std::uint8_t { as_written, packed };

// What stands between two labels, executed once.
struct Cost {
    std::int64_t bundles = 0;
    std::int64_t cycles = 0;
    std::int64_t operations = 0;
};

class VliwRenderer {
  public:
    // Files of programs/vliw behind options.s, memory.s and dispatch.s; then `stubs`, lines of
    // source. The program begins at `first`. Throws std::runtime_error with the assembler's words.
    VliwRenderer(std::span<const std::string_view> files, std::string_view stubs,
                 std::string_view first, const Defines& defines, std::int64_t lanes,
                 Form form = Form::packed);

    // A whole program of programs/vliw.
    VliwRenderer(std::string_view file, const Defines& defines, std::int64_t lanes,
                 Form form = Form::packed);

    // To the end of the scanline, or a halt or frame before it. Throws for a trap, a procedure that
    // does not end, and on a line-locked machine for a scanline of more than 910 cycles, which only
    // packed programs keep to.
    Ended run_scanline();
    // To the next halt (true) or frame (false). Throws, too, if none comes.
    bool run();

    std::uint16_t symbol(std::string_view name) const;
    Cost cost(std::string_view from_label, std::string_view to_label) const;
    std::uint16_t read(std::int64_t lane, std::uint32_t address) const;
    std::uint16_t read(std::int64_t lane, std::string_view name, int offset = 0) const;
    // A counter of 32 bits that is the same on all lanes, such as near_passes.
    int passes(std::string_view counter) const;
    void write(std::int64_t lane, std::uint32_t address, std::span<const std::uint16_t> words);
    void write(std::int64_t lane, std::string_view name, int value);

    isa::vliw::Interpreter& machine() { return machine_; }
    std::int64_t lanes() const { return machine_.lanes(); }
    // By phase, of what has been run.
    std::int64_t bundles(int phase) const { return bundles_.at(static_cast<std::size_t>(phase)); }
    std::int64_t scanlines() const { return scanlines_; }
    std::int64_t longest_scanline() const { return longest_; }

    // What the auxiliary input brings on the scanlines to come; 0 behind the last.
    Words aux;

  private:
    VliwRenderer(const isa::Image& image, std::int64_t lanes);
    void end_scanline();

    std::map<std::string, std::uint32_t, std::less<>> symbols_;
    std::shared_ptr<const isa::vliw::Program> program_;
    isa::vliw::Interpreter machine_;
    bool line_locked_;
    int phase_ = 0;
    std::array<std::int64_t, 7> bundles_{};
    std::int64_t scanlines_ = 0;
    std::int64_t cycles_ = 0;  // of the present scanline
    std::int64_t longest_ = 0;
};

// What the assembler says about a whole program with these options; empty: nothing.
std::string complaint_about(std::string_view file, const Defines& options);

}  // namespace rasterloom::test
