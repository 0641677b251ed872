// SPDX-License-Identifier: MIT
#include "programs/bucket_node.hpp"

#include "isa/assembler.hpp"
#include "isa/pdp11/pdp11.hpp"
#include "machine/emulation/bucket_loader.hpp"
#include "machine/emulation/node_memory.hpp"
#include "machine/fabric/polygon.hpp"
#include "machine/fabric/triangle_message.hpp"
#include "machine/node/registers.hpp"
#include "tests/programs/metered_run.hpp"

#include <array>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::test {

namespace {

constexpr std::uint32_t kSelectRow = 0166000;
constexpr std::uint32_t kClear = 0166002;
constexpr std::uint32_t kRunIsOver = 0177777;
constexpr std::uint32_t kReceive =
    kPortRegisters + static_cast<std::uint32_t>(PortRegister::rxaddr);

constexpr std::uint32_t own(NodeRegister which) {
    return kNodeRegisters + static_cast<std::uint32_t>(which);
}

struct Program {
    isa::Image image;
    std::shared_ptr<const isa::PreparedProgram> prepared;
};

const Program& program(bool textured) {
    static std::array<Program, 2> programs;
    Program& made = programs[textured ? 1 : 0];
    if (!made.prepared) {
        isa::AssemblerOptions options;
        options.defines = {{"textured", textured ? 1 : 0}};
        const isa::Isa& isa = isa::pdp11::pdp11_isa();
        made.image =
            isa::assemble_image(isa, RASTERLOOM_SOURCE_DIR "/programs/pdp11/bucket.s", options);
        made.prepared = isa.prepare(made.image, isa::CostChoice{"parks", {}});
    }
    return made;
}

}  // namespace

const isa::Image& bucket_image(bool textured) {
    return program(textured).image;
}

HandedOver::HandedOver(int columns, int rows, int background)
    : width(columns),
      depth(static_cast<std::size_t>(columns * rows), static_cast<std::int16_t>(kFarthestDepth)),
      image(depth.size(), static_cast<std::int16_t>(background * kShadeUnit)) {}

BucketNode::BucketNode(int columns, int rows, int background, const host::TileTexture* texture)
    : program_(&bucket_image(texture != nullptr)),
      core_(isa::pdp11::pdp11_isa().make_core(program(texture != nullptr).prepared, {})),
      frame_buffer_(*core_, {.rows = rows, .columns = columns}),
      taps_(*program_),
      meter_(taps_, frame_buffer_) {
    load_bucket(*core_, *program_, background, texture);
    core_->set_program_counter(program_->entry);
    core_->set_taps(taps_.addresses());
}

void BucketNode::draw(const std::vector<std::vector<TileLoad>>& frames, HandedOver& screen) {
    screen_ = &screen;
    for (const auto& frame : frames) {
        for (const auto& [tile, triangles] : frame) {
            write_tile(messages_.emplace_back(), tile);
            for (const host::ScreenTriangle& triangle : triangles)
                write_triangle(messages_.emplace_back(), corners_of(triangle));
        }
        write_end_of_tiles(messages_.emplace_back());
    }
    frames_left_ = frames.size();
    run_metered(*core_, *this, meter_, cycles_);
}

isa::Bus::Read BucketNode::read(std::uint32_t address, int) {
    if (address != own(NodeRegister::phase))
        return {};
    return {Status::ok, frames_left_ == 0 ? kRunIsOver : 0U};
}

isa::Bus::Status BucketNode::write(std::uint32_t address, std::uint32_t value, int) {
    if (address == kReceive) {
        core_->write_memory(value, messages_.front());
        messages_.pop_front();
    } else if (address == kSelectRow) {
        frame_buffer_.select(static_cast<int>(value));
    } else if (address == kClear) {
        hand_over();
        frame_buffer_.clear(static_cast<std::uint16_t>(value));
    } else if (address == own(NodeRegister::credit)) {
        --frames_left_;
    } else if (address != own(NodeRegister::waitfor)) {
        return Status::fault;
    }
    return Status::ok;
}

int BucketNode::word(const char* symbol) const {
    return static_cast<std::int16_t>(word_at(core_->memory(), require_symbol(*program_, symbol)));
}

void BucketNode::hand_over() {
    const int left = word("tile_left");
    const int top = word("tile_top");
    const int columns = word("tile_right") - left + 1;
    const int rows = word("tile_bottom") - top + 1;
    if (columns <= 0)
        return;
    if (columns > frame_buffer_.columns() || rows > frame_buffer_.rows())
        throw std::runtime_error(fmt::format("a tile of {} x {} pixels", columns, rows));
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const auto pixel =
                static_cast<std::size_t>((top + row) * screen_->width + left + column);
            screen_->depth.at(pixel) = frame_buffer_.depth(row, column);
            screen_->image.at(pixel) = frame_buffer_.image(row, column);
        }
    }
    ++screen_->tiles;
}

}  // namespace rasterloom::test
