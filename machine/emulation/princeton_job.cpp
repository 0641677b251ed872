// SPDX-License-Identifier: MIT
// The host's part for the renderers of programs/vliw: an object as integer triangles on the lanes,
// its place in every frame, and the picture out of their frame buffers. The scene's screen is the
// upper left part of the machine's.
#include "machine/emulation/array_settings.hpp"
#include "machine/emulation/job.hpp"
#include "machine/emulation/princeton_check.hpp"
#include "machine/emulation/princeton_loader.hpp"
#include "machine/emulation/princeton_picture.hpp"
#include "machine/emulation/princeton_scene.hpp"
#include "machine/host/triangle_renderer.hpp"
#include "machine/host/triangle_texture.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::emulation {

namespace {

using config::MachineDescription;

// What dispatch.s knows the beginning of a matrix by; the lowest bit is the frame's parity.
constexpr std::uint16_t kMatrixMarker = 0x8000;

host::Picture upper_left(const host::Picture& whole, const config::ScreenDescription& screen) {
    host::Picture part(static_cast<int>(screen.width), static_cast<int>(screen.height),
                       whole.channels);
    for (int y = 0; y < part.height; ++y) {
        const auto* row = &whole.pixels[static_cast<std::size_t>(y * whole.width * whole.channels)];
        std::copy_n(row, part.width * part.channels,
                    &part.pixels[static_cast<std::size_t>(y * part.width * part.channels)]);
    }
    return part;
}

// What a renderer's symbols do not allow, as the configuration's error.
template <typename Action>
auto by_symbols(const MachineDescription& description, const Action& action) {
    try {
        return action();
    } catch (const std::invalid_argument& problem) {
        throw description.error("nodes.program", {}, problem.what(),
                                "a program that draws, such as vliw/sort_middle.s");
    }
}

class PrincetonJob final : public HostJob {
  public:
    explicit PrincetonJob(const Blueprint& blueprint)
        : description_(blueprint.description),
          image_(*blueprint.image),
          scene_(make_princeton_scene(description_)),
          lights_(host::make_lights(description_.scene->light)),
          view_(by_symbols(description_, [&] { return program_view(image_); })),
          distance_(host::fitting_distance(scene_, description_.scene->rotate.axis, view_)),
          columns_(columns_as_lanes(static_cast<std::int64_t>(blueprint.topology.nodes.size()),
                                    view_.width)) {
        check_screen("screen.width", description_.screen.width, view_.width);
        check_screen("screen.height", description_.screen.height, view_.height);
    }

    void load(Machine& machine) override {
        LockstepMachine& lockstep = *machine.lockstep();
        by_symbols(description_, [&] {
            load_princeton(lockstep.array(), image_, scene_, view_at(0), lights_, columns_);
        });
        send(lockstep, 1);
    }

    void check_communication(Machine& machine) override {
        const LockstepArray& array = machine.lockstep()->array();
        by_symbols(description_, [&] { check_.emplace(image_, columns_); });
        machine.lockstep()->inspect([&](const PhaseRecord& ending, int next) {
            return check_->phase_ended(array, ending.phase, next);
        });
    }

    // Line-locked, a matrix comes while the picture before is drawn; else when that is complete.
    void frame_ended(Machine& machine, std::int64_t frame) override {
        LockstepMachine& lockstep = *machine.lockstep();
        if (lockstep.settings().line_locked) {
            send(lockstep, frame + 2);
        } else {
            load_matrix(lockstep.array(), image_, view_at(frame + 1).matrix);
        }
    }

    bool has_video(const Machine& machine) const override {
        return machine.lockstep()->settings().line_locked && has_frame_buffers(image_);
    }

    host::Picture collect(const Machine& machine) const override {
        return upper_left(shown_picture(machine.lockstep()->array(), image_, columns_).picture,
                          description_.screen);
    }

    std::optional<host::Picture> video(const Machine& machine) const override {
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

    host::Picture reference(std::int64_t frame) const override {
        return upper_left(host::render_triangles(scene_, view_at(frame), lights_).picture,
                          description_.screen);
    }

    int background() const override { return 0; }

    std::string remarks() const override {
        const std::size_t visible = host::render_triangles(scene_, view_at(0), lights_).visible;
        return fmt::format("Object          {} triangles, {} of them visible in the first frame",
                           scene_.triangles.size(), visible);
    }

  private:
    void check_screen(const char* key, std::int64_t asked, int most) const {
        if (asked > most) {
            throw description_.error(key, std::to_string(asked), "the program's screen is smaller",
                                     fmt::format("at most {}", most));
        }
    }

    host::TriangleView view_at(std::int64_t frame) const {
        host::TriangleView view = view_;
        view.matrix = make_princeton_view(description_, distance_, frame).matrix;
        return view;
    }

    void send(LockstepMachine& lockstep, std::int64_t frame) const {
        std::vector<std::uint16_t> words{static_cast<std::uint16_t>(kMatrixMarker | (frame & 1))};
        for (const std::int16_t word : view_at(frame).matrix) {
            words.push_back(static_cast<std::uint16_t>(word));
        }
        lockstep.send(std::move(words));
    }

    const MachineDescription& description_;
    const isa::Image& image_;
    host::TriangleScene scene_;
    host::TriangleLights lights_;
    host::TriangleView view_;  // without a matrix
    int distance_;
    ColumnMap columns_;
    std::optional<CommunicationCheck> check_;
};

}  // namespace

std::unique_ptr<HostJob> make_princeton_job(const Blueprint& blueprint) {
    return std::make_unique<PrincetonJob>(blueprint);
}

}  // namespace rasterloom::emulation
