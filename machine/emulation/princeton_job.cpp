// SPDX-License-Identifier: MIT
#include "machine/emulation/princeton_job.hpp"

#include "machine/emulation/princeton_picture.hpp"
#include "machine/emulation/scene_kind.hpp"
#include "machine/host/triangle_texture.hpp"

#include <algorithm>
#include <exception>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace rasterloom::emulation {

namespace {

// What dispatch.s knows the beginning of a matrix by; the lowest bit is the frame's parity.
constexpr std::uint16_t kMatrixMarker = 0x8000;

}  // namespace

PrincetonJob::PrincetonJob(const Blueprint& blueprint)
    : description_(blueprint.description), image_(*blueprint.image) {
    const host::TriangleView screen = by_symbols([&] { return program_view(image_); });
    columns_ = make_columns(static_cast<std::int64_t>(blueprint.topology.nodes.size()), screen);
    check_screen("screen.width", description_.screen.width, screen.width);
    check_screen("screen.height", description_.screen.height, screen.height);
}

ColumnMap PrincetonJob::make_columns(std::int64_t lanes, const host::TriangleView& screen) const {
    const ColumnMap usual = columns_as_lanes(lanes, screen.width);
    if (!description_.screen.map) {
        return usual;
    }
    const config::FileReference& file = *description_.screen.map;
    const int width = static_cast<int>(std::min<std::int64_t>(screen.width, lanes));
    try {
        ColumnMap columns = columns_of_map(topology::region_map_file(
            file.path.string(), width, screen.height, static_cast<topology::RegionIndex>(lanes)));
        if (columns != usual && !takes_any_columns(image_)) {
            throw std::invalid_argument(
                "this program looks for column i on lane i, expected such a map, or sort-middle "
                "with dense 0 and no stride");
        }
        return columns;
    } catch (const std::exception& problem) {
        throw description_.error("screen.map", {}, problem.what());
    }
}

void PrincetonJob::check_communication(Machine& machine) {
    const LockstepArray& array = machine.lockstep()->array();
    by_symbols([&] { check_.emplace(image_, columns_); });
    machine.lockstep()->inspect([&](const PhaseRecord& ending, int next) {
        return check_->phase_ended(array, ending.phase, next);
    });
}

bool PrincetonJob::has_video(const Machine& machine) const {
    return machine.lockstep()->settings().line_locked && has_frame_buffers(image_);
}

host::Picture PrincetonJob::collect(const Machine& machine) const {
    return on_screen(shown_picture(machine.lockstep()->array(), image_, columns_).picture);
}

std::optional<host::Picture> PrincetonJob::video(const Machine& machine) const {
    if (!has_video(machine)) {
        return std::nullopt;
    }
    const LockstepMachine& lockstep = *machine.lockstep();
    host::Picture picture(static_cast<int>(description_.screen.width),
                          static_cast<int>(description_.screen.height), 3);
    for (int y = 0; y < picture.height; ++y) {
        const std::span<const std::uint16_t> line = lockstep.video_line(y);
        for (std::size_t lane = 0; lane < line.size(); ++lane) {
            const auto column = columns_[lane];
            if (column && *column < picture.width) {
                const host::Colour colour = host::colour_of(line[lane]);
                std::copy(colour.begin(), colour.end(), &picture.at(*column, y));
            }
        }
    }
    return picture;
}

void PrincetonJob::send(LockstepMachine& lockstep, std::int64_t frame,
                        const std::array<std::int16_t, 12>& matrix) {
    std::vector<std::uint16_t> words{static_cast<std::uint16_t>(kMatrixMarker | (frame & 1))};
    for (const std::int16_t word : matrix) {
        words.push_back(static_cast<std::uint16_t>(word));
    }
    lockstep.send(std::move(words));
}

host::Picture PrincetonJob::on_screen(const host::Picture& whole) const {
    host::Picture part(static_cast<int>(description_.screen.width),
                       static_cast<int>(description_.screen.height), whole.channels);
    for (int y = 0; y < part.height; ++y) {
        const auto* row = &whole.pixels[static_cast<std::size_t>(y * whole.width * whole.channels)];
        std::copy_n(row, part.width * part.channels,
                    &part.pixels[static_cast<std::size_t>(y * part.width * part.channels)]);
    }
    return part;
}

void PrincetonJob::check_screen(const char* key, std::int64_t asked, int most) const {
    if (asked > most) {
        throw description_.error(key, std::to_string(asked), "the program's screen is smaller",
                                 fmt::format("at most {}", most));
    }
}

std::unique_ptr<HostJob> make_princeton_job(const Blueprint& blueprint) {
    return scene_kind(blueprint.description) == SceneKind::boxes
               ? make_princeton_box_job(blueprint)
               : make_princeton_mesh_job(blueprint);
}

}  // namespace rasterloom::emulation
