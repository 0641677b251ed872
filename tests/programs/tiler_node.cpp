// SPDX-License-Identifier: MIT
#include "programs/tiler_node.hpp"

#include "isa/assembler.hpp"
#include "isa/pdp11/pdp11.hpp"
#include "machine/emulation/tiler_loader.hpp"
#include "machine/node/frame_buffer.hpp"
#include "machine/node/registers.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::test {

namespace {

constexpr std::uint32_t kReceive =
    kPortRegisters + static_cast<std::uint32_t>(PortRegister::rxaddr);
constexpr std::uint32_t kSelectRow = 0166000;
constexpr std::uint32_t kClear = 0166002;
constexpr int kStackPointer = 6;
constexpr std::int64_t kLongestRun = 2'000'000'000;  // cycles

constexpr std::uint32_t own(NodeRegister reg) {
    return kNodeRegisters + static_cast<std::uint32_t>(reg);
}

struct Program {
    isa::Image image;
    std::shared_ptr<const isa::PreparedProgram> prepared;
};

const Program& program(const TilerVariant& variant) {
    static std::map<TilerVariant, Program> programs;
    Program& made = programs[variant];
    if (!made.prepared) {
        isa::AssemblerOptions options;
        options.defines = {{"full", variant.full ? 1 : 0},
                           {"skip_deltas", variant.skip_deltas ? 1 : 0},
                           {"frame_buffer_bus", variant.bus ? 1 : 0}};
        const isa::Isa& isa = isa::pdp11::pdp11_isa();
        made.image =
            isa::assemble_image(isa, RASTERLOOM_SOURCE_DIR "/programs/pdp11/tiler.s", options);
        made.prepared = isa.prepare(made.image, isa::CostChoice{"parks", {}});
    }
    return made;
}

}  // namespace

std::string name_of(const TilerVariant& variant) {
    return fmt::format("{}{}{}", variant.full ? "full" : "thesis",
                       variant.skip_deltas ? ", skipping deltas" : "", variant.bus ? ", bus" : "");
}

const isa::Image& tiler_image(const TilerVariant& variant) {
    return program(variant).image;
}

TilerNode::TilerNode(const TilerVariant& variant, const topology::PixelGrid& grid, int width,
                     int height, int background)
    : variant_(variant),
      grid_(grid),
      core_(isa::pdp11::pdp11_isa().make_core(program(variant).prepared, {})),
      depth_(static_cast<std::size_t>(grid.rows * grid.columns)),
      image_(depth_.size()) {
    load_tiler(*core_, tiler_image(variant), grid, {width, height, background});
    core_->set_program_counter(tiler_image(variant).entry);
}

void TilerNode::draw(std::span<const Polygon> polygons) {
    draw_frames(std::vector<std::vector<Polygon>>{{polygons.begin(), polygons.end()}});
}

void TilerNode::draw_frames(std::span<const std::vector<Polygon>> frames) {
    for (const std::vector<Polygon>& polygons : frames) {
        waiting_.insert(waiting_.end(), polygons.begin(), polygons.end());
        waiting_.emplace_back();
        ++frames_left_;
    }
    while (cycles_ < kLongestRun) {
        isa::Stop stop = core_->run(10'000'000);
        if (stop.reason == isa::StopReason::io) {
            const std::int64_t spent = stop.cycles;
            stop = core_->step(*this);
            stop.cycles += spent;
        }
        cycles_ += stop.cycles;
        if (section_ != nullptr) {
            section_->cycles += stop.cycles;
        }
        if (stop.reason == isa::StopReason::tap) {
            note_tap();
        }
        if (stop.reason == isa::StopReason::trap) {
            throw std::runtime_error(
                fmt::format("trap at {:06o}: {}", stop.trap->pc, stop.trap->what));
        }
        if (stop.reason == isa::StopReason::halt) {
            keep_row();
            return;
        }
    }
    throw std::runtime_error("the program does not come to an end");
}

int TilerNode::grey(int row, int column) const {
    return image_.at(index(row, column)) >> 7;
}

void TilerNode::watch_taps() {
    std::vector<std::uint32_t> addresses;
    for (const auto& [symbol, address] : tiler_image(variant_).symbols) {
        if (symbol.starts_with("tap_")) {
            addresses.push_back(address);
            taps_[address] = symbol;
        }
    }
    core_->set_taps(addresses);
}

void TilerNode::note_tap() {
    const std::string& name = taps_.at(core_->program_counter());
    section_ = &sections_[name];
    ++section_->passes;
    if (name.starts_with("tap_polygon")) {
        vertices_.push_back(word(*tiler_image(variant_).symbol("vertex_count")));
    } else if (name.starts_with("tap_segment")) {
        lengths_.push_back(0);
    } else if (name.starts_with("tap_pixels") && !name.starts_with("tap_pixels_done")) {
        lengths_.back() = static_cast<int>(core_->reg(kStackPointer));
    }
}

std::uint16_t TilerNode::word(std::uint32_t address) const {
    const auto memory = core_->memory();
    return static_cast<std::uint16_t>(memory[address] | memory[address + 1] << 8);
}

isa::Bus::Read TilerNode::read(std::uint32_t address, int bytes) {
    if (bytes == 2 && address == own(NodeRegister::phase)) {
        return {Status::ok, frames_left_ == 0 ? 0177777U : 0U};
    }
    return {};
}

isa::Bus::Status TilerNode::write(std::uint32_t address, std::uint32_t value, int bytes) {
    if (bytes != 2) {
        return Status::fault;
    }
    if (address == kReceive) {
        receive(value);
    } else if (address == kSelectRow) {
        select(value);
    } else if (address == kClear) {
        clear(static_cast<std::uint16_t>(value));
    } else if (address == own(NodeRegister::credit)) {
        frames_left_ += static_cast<std::int16_t>(value);
    } else if (variant_.bus && row_ >= 0 && address >= kBusImageWindow) {
        image_.at(index(row_, static_cast<int>(address - kBusImageWindow) / 2)) =
            static_cast<std::int16_t>(value);
    } else if (address != own(NodeRegister::waitfor)) {
        return Status::fault;
    }
    return Status::ok;
}

void TilerNode::receive(std::uint32_t address) {
    std::vector<std::uint8_t> bytes;
    const auto add = [&](int value) {
        bytes.push_back(static_cast<std::uint8_t>(value & 0xff));
        bytes.push_back(static_cast<std::uint8_t>(value >> 8 & 0xff));
    };
    if (waiting_.empty()) {
        throw std::runtime_error("the program waits for a message that never comes");
    }
    const auto& vertices = waiting_.front().vertices;
    add(static_cast<int>(vertices.empty() ? PolygonMessage::end_of_frame
                                          : PolygonMessage::polygon));
    add(static_cast<int>(vertices.size()));
    for (const PolygonVertex& v : vertices) {
        add(v.x);
        add(v.y);
        add(v.z);
        add(v.shade);
    }
    waiting_.pop_front();
    core_->write_memory(address, bytes);
}

void TilerNode::keep_row() {
    for (int c = 0; row_ >= 0 && c < grid_.columns; ++c) {
        const auto offset = 2 * static_cast<std::uint32_t>(c);
        depth_.at(index(row_, c)) = static_cast<std::int16_t>(word(kDepthWindow + offset));
        if (!variant_.bus) {
            image_.at(index(row_, c)) = static_cast<std::int16_t>(word(kImageWindow + offset));
        }
    }
}

void TilerNode::select(std::uint32_t row) {
    keep_row();
    row_ = static_cast<int>(row);
    if (row_ >= grid_.rows) {
        throw std::runtime_error(fmt::format("row {} of {}", row, grid_.rows));
    }
    std::vector<std::uint8_t> depths, shades;
    for (int c = 0; c < grid_.columns; ++c) {
        const auto put = [](std::vector<std::uint8_t>& bytes, std::int16_t value) {
            bytes.push_back(static_cast<std::uint8_t>(value & 0xff));
            bytes.push_back(static_cast<std::uint8_t>(value >> 8 & 0xff));
        };
        put(depths, depth_.at(index(row_, c)));
        put(shades, image_.at(index(row_, c)));
    }
    core_->write_memory(kDepthWindow, depths);
    if (!variant_.bus) {
        core_->write_memory(kImageWindow, shades);
    }
}

void TilerNode::clear(std::uint16_t shade) {
    row_ = -1;
    std::fill(depth_.begin(), depth_.end(), static_cast<std::int16_t>(kFarthestDepth));
    std::fill(image_.begin(), image_.end(), static_cast<std::int16_t>(shade));
}

std::string difference(const TilerNode& node, const host::DepthPicture& reference) {
    const topology::PixelGrid& grid = node.grid();
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const int x = grid.x_start + column * grid.x_step;
            const int y = grid.y_start + row * grid.y_step;
            const auto pixel = static_cast<std::size_t>(
                (reference.picture.height - 1 - y) * reference.picture.width + x);
            const int depth = node.depth(row, column);
            const int grey = node.grey(row, column);
            if (depth != reference.depth[pixel] || grey != reference.picture.pixels[pixel]) {
                return fmt::format("pixel ({}, {}): depth {}, grey {}; expected {}, {}", x, y,
                                   depth, grey, reference.depth[pixel],
                                   reference.picture.pixels[pixel]);
            }
        }
    }
    return {};
}

std::string difference_of(const TilerVariant& variant, const topology::PixelGrid& grid,
                          std::span<const Polygon> polygons, int width, int height) {
    constexpr int kBackground = 9;
    TilerNode node(variant, grid, width, height, kBackground);
    node.draw(polygons);
    host::PolygonRenderOptions options;
    options.width = width;
    options.height = height;
    options.background = kBackground;
    options.precision = variant.full ? host::Precision::full : host::Precision::thesis;
    return difference(node, host::render_polygons(polygons, options));
}

}  // namespace rasterloom::test
