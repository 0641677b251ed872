// SPDX-License-Identifier: MIT
// The geometry stage of the Princeton Engine's programs (programs/vliw/geometry.s) on a few lanes
// of the reference interpreter, with main's place taken by a dispatcher.
#pragma once

#include "isa/image.hpp"
#include "isa/vliw/interpreter.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::test {

struct VliwVertex {
    std::array<std::int16_t, 3> place{};
    std::array<std::int16_t, 3> normal{};  // s1.14
    int u = 0;                             // 0 ... 255
    int v = 0;
};

struct VliwPolygon {
    std::array<VliwVertex, 3> vertices{};
    std::array<std::uint16_t, 3> colour{};  // colour and texture, as in the database
};

struct VliwView {
    std::array<std::int16_t, 12> matrix{1 << 14, 0, 0, 0, 1 << 14, 0, 0, 0, 1 << 14, 0, 0, 0};
    int focal = 11200;
    int near = 4097;
};

struct VliwLights {
    int ambient = 0;
    std::array<std::int16_t, 3> sun{};
    int sun_diffuse = 0;
    int sun_specular = 0;
    std::array<std::int16_t, 3> lamp{};
    int lamp_diffuse = 0;
    int lamp_specular = 0;
    int shininess = 0;
};

using VliwDatabase = std::vector<VliwPolygon>;      // a lane's
using VliwDescriptor = std::vector<std::uint16_t>;  // 42 words

struct VliwGeometryOptions {
    bool textured = true;
    bool packed = true;
    int room = 64;                        // descriptors that a lane's array holds
    std::optional<VliwView> next_view{};  // its matrix comes as soon as the stage is at work
};

class VliwGeometryRun {
  public:
    using Options = VliwGeometryOptions;

    // Runs until main goes on with the communication or the machine halts. Throws
    // std::runtime_error for a trap, or if neither comes.
    VliwGeometryRun(const VliwView& view, const VliwLights& lights,
                    const std::vector<VliwDatabase>& lanes, const Options& options = {});

    bool reached_communication() const { return reached_communication_; }
    int error(int lane) const { return word(lane, symbol("error")); }
    // Of lane's array, as many as its source_count says.
    std::vector<VliwDescriptor> descriptors(int lane) const;
    // Whether the run has left alone what is not its: all fast memory but the lane's array, its
    // count, `error` and the geometry's scratch.
    bool kept_its_place(int lane) const;

    // Bundles and operations between the procedure's beginning and its `line`, by its name.
    struct Cost {
        int calls = 0;
        std::int64_t bundles = 0;
        std::int64_t operations = 0;
        std::int64_t longest = 0;  // bundles of one call
    };
    const std::map<std::string, Cost>& costs() const { return costs_; }

  private:
    std::uint32_t symbol(std::string_view name) const;
    std::uint16_t word(int lane, std::uint32_t address) const;
    std::vector<std::uint16_t> fast_memory(int lane) const;
    void poke(int lane, std::uint32_t address, const std::vector<std::uint16_t>& words);
    void load_lane(int lane, const VliwView& view, const VliwLights& lights,
                   const VliwDatabase& polygons);
    void run();
    std::string procedure_name() const;

    Options options_;
    const isa::Image& image_;
    isa::vliw::Interpreter machine_;
    std::vector<std::vector<std::uint16_t>> before_;  // fast memory of the lanes
    bool reached_communication_ = false;
    std::map<std::string, Cost> costs_;
};

std::vector<std::uint16_t> words_of(const VliwPolygon& polygon);

}  // namespace rasterloom::test
