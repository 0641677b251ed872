// SPDX-License-Identifier: MIT
#include "tests/emulation/metered_tiler.hpp"

#include "isa/pdp11/pdp11.hpp"
#include "machine/emulation/tiler_loader.hpp"
#include "machine/fabric/polygon_message.hpp"
#include "machine/node/registers.hpp"
#include "tests/programs/metered_run.hpp"

namespace rasterloom::test {

namespace {

constexpr std::uint32_t kReceive =
    kPortRegisters + static_cast<std::uint32_t>(PortRegister::rxaddr);

constexpr std::uint32_t own(NodeRegister which) {
    return kNodeRegisters + static_cast<std::uint32_t>(which);
}

}  // namespace

MeteredTiler::MeteredTiler(const Program& program, const topology::PixelGrid& grid, int width,
                           int height)
    : core_(isa::pdp11::pdp11_isa().make_core(program.prepared, {})),
      frame_buffer_(*core_, {.rows = grid.rows, .columns = grid.columns}),
      taps_(program.image),
      meter_(taps_, frame_buffer_) {
    load_tiler(*core_, program.image, grid, {width, height, 0});
    core_->set_program_counter(program.image.entry);
}

void MeteredTiler::draw(const Frames& frames, bool metered) {
    for (const auto& frame : frames) {
        for (const Polygon& polygon : frame) {
            write_polygon(messages_.emplace_back(), polygon, 0);
        }
        write_end_of_frame(messages_.emplace_back(), 0);
    }
    frames_left_ = frames.size();
    core_->set_taps(metered ? taps_.addresses() : std::vector<std::uint32_t>());
    run_metered(*core_, *this, meter_, cycles_);
}

isa::Bus::Read MeteredTiler::read(std::uint32_t address, int) {
    if (address != own(NodeRegister::phase)) {
        return {};
    }
    return {Status::ok, frames_left_ == 0 ? 0177777U : 0U};
}

isa::Bus::Status MeteredTiler::write(std::uint32_t address, std::uint32_t value, int) {
    if (address == kReceive) {
        core_->write_memory(value, messages_.front());
        messages_.pop_front();
    } else if (address == kFbRow) {
        frame_buffer_.select(static_cast<int>(value));
    } else if (address == kFbClear) {
        frame_buffer_.clear(static_cast<std::uint16_t>(value));
    } else if (address == own(NodeRegister::credit)) {
        --frames_left_;
    } else if (address != own(NodeRegister::waitfor)) {
        return Status::fault;
    }
    return Status::ok;
}

}  // namespace rasterloom::test
