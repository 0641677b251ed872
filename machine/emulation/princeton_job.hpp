// SPDX-License-Identifier: MIT
// The host's part for the renderers of programs/vliw, whatever they draw: which lanes draw which
// columns, the checks of their communication, and the picture out of their frame buffers. The
// scene's screen is the upper left part of the machine's.
#pragma once

#include "machine/emulation/job.hpp"
#include "machine/emulation/princeton_check.hpp"
#include "machine/emulation/princeton_screen.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>

namespace rasterloom::emulation {

class PrincetonJob : public HostJob {
  public:
    // The blueprint must outlive the job.
    explicit PrincetonJob(const Blueprint& blueprint);

    void check_communication(Machine& machine) override;
    bool has_video(const Machine& machine) const override;
    host::Picture collect(const Machine& machine) const override;
    std::optional<host::Picture> video(const Machine& machine) const override;
    int background() const override { return 0; }

  protected:
    const config::MachineDescription& description() const { return description_; }
    const isa::Image& image() const { return image_; }
    const ColumnMap& columns() const { return columns_; }
    // With the next picture, an integer a scanline: the program's frame `frame` is to have this
    // matrix. By it the program knows, too, which scanline is the first.
    static void send(LockstepMachine& lockstep, std::int64_t frame,
                     const std::array<std::int16_t, 12>& matrix);
    host::Picture on_screen(const host::Picture& whole) const;

    // What a renderer's symbols do not allow, as the configuration's error.
    template <typename Action>
    auto by_symbols(const Action& action) const {
        try {
            return action();
        } catch (const std::invalid_argument& problem) {
            throw description_.error("nodes.program", {}, problem.what(),
                                     "a program that draws, such as vliw/sort_middle.s");
        }
    }

  private:
    ColumnMap make_columns(std::int64_t lanes, const host::TriangleView& screen) const;
    void check_screen(const char* key, std::int64_t asked, int most) const;

    const config::MachineDescription& description_;
    const isa::Image& image_;
    ColumnMap columns_;
    std::optional<CommunicationCheck> check_;
};

std::unique_ptr<HostJob> make_princeton_mesh_job(const Blueprint& blueprint);
std::unique_ptr<HostJob> make_princeton_box_job(const Blueprint& blueprint);

}  // namespace rasterloom::emulation
