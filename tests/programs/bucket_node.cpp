// SPDX-License-Identifier: MIT
#include "programs/bucket_node.hpp"

#include "isa/assembler.hpp"
#include "isa/pdp11/pdp11.hpp"
#include "machine/emulation/bucket_loader.hpp"
#include "machine/emulation/node_memory.hpp"
#include "machine/fabric/polygon.hpp"
#include "machine/node/registers.hpp"

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

using Message = std::vector<std::uint8_t>;

Message message_of(int kind, int sign, const std::vector<int>& words) {
    Message bytes;
    const auto put = [&](int word) {
        bytes.push_back(static_cast<std::uint8_t>(word & 0xff));
        bytes.push_back(static_cast<std::uint8_t>(word >> 8 & 0xff));
    };
    put(kind);
    put(sign);
    for (const int word : words)
        put(word);
    return bytes;
}

Message message_of(const host::ScreenTriangle& triangle) {
    std::vector<int> words;
    for (const host::ScreenVertex& v : triangle.vertices)
        words.insert(words.end(), {v.x, v.y, v.depth, v.shade, v.u, v.v});
    return message_of(1, 1, words);
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
            messages_.push_back(message_of(3, -1, {tile.x0, tile.y0, tile.x1, tile.y1}));
            for (const host::ScreenTriangle& triangle : triangles)
                messages_.push_back(message_of(triangle));
        }
        messages_.push_back(message_of(2, 0, {}));
    }
    frames_left_ = frames.size();
    while (true) {
        isa::Stop stop = core_->run(100'000);
        cycles_ += stop.cycles;
        if (stop.reason == isa::StopReason::io) {
            stop = core_->step(*this);
            cycles_ += stop.cycles;
        }
        if (stop.reason == isa::StopReason::tap) {
            meter_.tapped({0, core_->program_counter(), cycles_, Time::zero(), *core_});
        } else if (stop.reason == isa::StopReason::halt) {
            return;
        } else if (stop.reason != isa::StopReason::budget) {
            throw std::runtime_error(fmt::format("the program stops at {:06o}: {}",
                                                 core_->program_counter(),
                                                 stop.trap ? stop.trap->what : ""));
        }
    }
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
