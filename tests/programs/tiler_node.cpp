// SPDX-License-Identifier: MIT
#include "programs/tiler_node.hpp"

#include "isa/assembler.hpp"
#include "isa/pdp11/pdp11.hpp"
#include "machine/emulation/tiler_loader.hpp"
#include "machine/fabric/polygon_message.hpp"
#include "machine/node/frame_buffer.hpp"
#include "machine/node/registers.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::test {

namespace {

constexpr std::uint32_t kSelectRow = 0166000;
constexpr std::uint32_t kClear = 0166002;
constexpr int kStackPointer = 6;
constexpr std::int64_t kLongestRun = 2'000'000'000;  // cycles

constexpr int kBackground = 9;
constexpr std::uint32_t kRunIsOver = 0177777;

constexpr std::uint32_t at_port(std::uint32_t port, PortRegister reg) {
    return kPortRegisters + port * kPortStride + static_cast<std::uint32_t>(reg);
}
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
                           {"frame_buffer_bus", variant.bus ? 1 : 0},
                           {"half_digested", variant.digests ? 1 : 0}};
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
                       variant.skip_deltas ? ", skipping deltas" : "", variant.bus ? ", bus" : "") +
           (variant.digests ? ", half-digested" : "");
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
    for (std::size_t frame = 0; frame < frames.size(); ++frame) {
        for (const Polygon& polygon : frames[frame]) {
            inputs[0].push_back(polygon_message(&polygon));
        }
        inputs[0].push_back(polygon_message(nullptr));
        run();
        if (!has_ended_frame()) {
            throw std::runtime_error("the program waits for what never comes");
        }
        announce(frame + 1 < frames.size());
    }
    run();
}

bool TilerNode::run() {
    const std::int64_t begin = cycles_;
    while (!halted_ && cycles_ - begin < kLongestRun) {
        isa::Stop stop = core_->run(10'000'000);
        const std::int64_t spent = stop.cycles;
        if (stop.reason == isa::StopReason::io) {
            stop = core_->step(*this);
            stop.cycles += spent;
        }
        cycles_ += stop.cycles;
        if (section_ != nullptr) {
            section_->cycles += stop.cycles;
        }
        switch (stop.reason) {
            case isa::StopReason::tap:
                note_tap();
                break;
            case isa::StopReason::trap:
                throw std::runtime_error(
                    fmt::format("trap at {:06o}: {}", stop.trap->pc, stop.trap->what));
            case isa::StopReason::retry:
                return cycles_ > begin;
            case isa::StopReason::halt:
                keep_row();
                halted_ = true;
                return true;
            default:
                break;
        }
    }
    if (!halted_) {
        throw std::runtime_error("the program does not come to an end");
    }
    return false;
}

void TilerNode::announce(bool another_frame) {
    phase_ = another_frame ? phase_ + 1 : kRunIsOver;
    credit_ = 1;
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
    if (bytes != 2) {
        return {};
    }
    if (address == own(NodeRegister::phase)) {
        phase_seen_ = phase_;
        return {Status::ok, phase_};
    }
    if (address == own(NodeRegister::txroom)) {
        return {Status::ok, outputs.size() < output_places ? 2U : 0U};
    }
    for (std::uint32_t port = 0; port < 2; ++port) {
        if (address == at_port(port, PortRegister::rxstat)) {
            return {Status::ok, inputs[port].empty() ? 0U : kStatReady};
        }
    }
    return {};
}

isa::Bus::Status TilerNode::write(std::uint32_t address, std::uint32_t value, int bytes) {
    if (bytes != 2) {
        return Status::fault;
    }
    for (std::uint32_t port = 0; port < 2; ++port) {
        if (address == at_port(port, PortRegister::rxaddr)) {
            return receive(inputs[port], value);
        }
    }
    if (address == at_port(1, PortRegister::txaddr)) {
        send_address_ = value;
        return Status::ok;
    }
    if (address == at_port(1, PortRegister::txlen)) {
        return send(value);
    }
    if (variant_.bus && row_ >= 0 && address >= kBusImageWindow) {
        image_.at(index(row_, static_cast<int>(address - kBusImageWindow) / 2)) =
            static_cast<std::int16_t>(value);
        return Status::ok;
    }
    return write_own(address, value);
}

isa::Bus::Status TilerNode::write_own(std::uint32_t address, std::uint32_t value) {
    if (address == kSelectRow) {
        select(value);
    } else if (address == kClear) {
        clear(static_cast<std::uint16_t>(value));
    } else if (address == own(NodeRegister::credit)) {
        credit_ += static_cast<std::int16_t>(value);
    } else if (address == own(NodeRegister::waitfor)) {
        const bool message = !inputs[0].empty() || !inputs[1].empty();
        const bool met = ((value & kWaitMessage) != 0 && message) ||
                         ((value & kWaitPhase) != 0 && phase_ != phase_seen_);
        return met ? Status::ok : Status::retry;
    } else {
        return Status::fault;
    }
    return Status::ok;
}

isa::Bus::Status TilerNode::receive(std::deque<Message>& from, std::uint32_t address) {
    if (from.empty()) {
        return Status::retry;
    }
    core_->write_memory(address, from.front());
    from.pop_front();
    return Status::ok;
}

isa::Bus::Status TilerNode::send(std::uint32_t length) {
    if (outputs.size() >= output_places) {
        throw std::runtime_error("the program sends without room");
    }
    const auto bytes = core_->memory().subspan(send_address_, length);
    outputs.emplace_back(bytes.begin(), bytes.end());
    return Status::ok;
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

TilerNode::Message polygon_message(const Polygon* polygon) {
    TilerNode::Message bytes;
    if (polygon == nullptr) {
        write_end_of_frame(bytes, 0);
    } else {
        write_polygon(bytes, *polygon, 0);
    }
    return bytes;
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

host::DepthPicture reference_of(const TilerVariant& variant, std::span<const Polygon> polygons,
                                int width, int height) {
    host::PolygonRenderOptions options;
    options.width = width;
    options.height = height;
    options.background = kBackground;
    options.precision = variant.full ? host::Precision::full : host::Precision::thesis;
    return host::render_polygons(polygons, options);
}

std::string difference_of(const TilerVariant& variant, const topology::PixelGrid& grid,
                          std::span<const Polygon> polygons, int width, int height) {
    TilerNode node(variant, grid, width, height, kBackground);
    node.draw(polygons);
    return difference(node, reference_of(variant, polygons, width, height));
}

}  // namespace rasterloom::test
