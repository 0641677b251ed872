// SPDX-License-Identifier: MIT
#include "machine/emulation/tiler_taps.hpp"

#include "machine/node/frame_buffer.hpp"

#include <array>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::emulation {

namespace {

constexpr std::string_view kPrefix = "tap_";
// A program may have several of one kind: tap_vertex, tap_vertex_2.
constexpr std::array<std::pair<std::string_view, TilerTap>, 7> kNames{
    std::pair{"idle", TilerTap::idle},        // the longer name first
    std::pair{"digest", TilerTap::digest},    //
    std::pair{"polygon", TilerTap::polygon},  //
    std::pair{"vertex", TilerTap::vertex},    //
    std::pair{"segment", TilerTap::segment},  //
    std::pair{"pixels_done", TilerTap::pixels_done},
    std::pair{"pixels", TilerTap::pixels}};

constexpr int kDepthPointer = 5;  // r5
constexpr int kPixelCount = 6;    // sp

std::optional<TilerTap> kind_of(std::string_view label) {
    label.remove_prefix(kPrefix.size());
    for (const auto& [name, kind] : kNames) {
        if (label == name || (label.starts_with(name) && label[name.size()] == '_')) {
            return kind;
        }
    }
    return std::nullopt;
}

}  // namespace

TilerTaps::TilerTaps(const isa::Image& image) {
    std::set<TilerTap> found;
    for (const auto& [name, value] : image.symbols) {
        if (!name.starts_with(kPrefix)) {
            continue;
        }
        const auto kind = kind_of(name);
        if (!kind) {
            throw std::invalid_argument(fmt::format(
                "{}: the label {} names no section of a tiler; expected tap_idle, "
                "tap_digest, tap_polygon, tap_vertex, tap_segment, tap_pixels or tap_pixels_done, "
                "with _ and something behind if there are several",
                image.name, name));
        }
        found.insert(*kind);
        if (kinds_.emplace(value, *kind).first->second != *kind) {
            throw std::invalid_argument(
                fmt::format("{}: the label {} stands where another section begins: a section needs "
                            "an instruction of its own",
                            image.name, name));
        }
    }
    for (const auto& [name, kind] : kNames) {
        if (!found.contains(kind) && kind != TilerTap::digest) {
            throw std::invalid_argument(
                fmt::format("{}: appendix C needs the label {}{}, which the program has not",
                            image.name, kPrefix, name));
        }
    }
    const auto count = image.symbol("vertex_count");
    if (!count) {
        throw std::invalid_argument(fmt::format(
            "{}: appendix C needs the symbol vertex_count, which the program has not", image.name));
    }
    vertex_count_ = *count;
}

std::vector<std::uint32_t> TilerTaps::addresses() const {
    std::vector<std::uint32_t> all;
    for (const auto& [address, kind] : kinds_) {
        all.push_back(address);
    }
    return all;
}

int TilerTaps::vertices(const isa::Core& core) const {
    const auto memory = core.memory();
    return memory[vertex_count_] | memory[vertex_count_ + 1] << 8;
}

TilerTaps::Run TilerTaps::run(const isa::Core& core) {
    return {(static_cast<int>(core.reg(kDepthPointer)) - static_cast<int>(kDepthWindow)) / 2,
            static_cast<int>(core.reg(kPixelCount))};
}

}  // namespace rasterloom::emulation
