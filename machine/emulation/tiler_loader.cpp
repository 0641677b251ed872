// SPDX-License-Identifier: MIT
#include "machine/emulation/tiler_loader.hpp"

#include "machine/emulation/node_memory.hpp"
#include "machine/fabric/polygon.hpp"
#include "machine/node/frame_buffer.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

namespace rasterloom {

namespace {

// One axis of a grid: coordinate start + i * step for 0 <= i < count.
struct Axis {
    int start = 0;
    int step = 1;
    int count = 0;

    int at(int index) const { return start + index * step; }
    // The first index whose coordinate is not below c; count when there is none.
    int first_from(int c) const {
        const int steps = c <= start ? 0 : (c - start + step - 1) / step;
        return std::min(steps, count);
    }
    // The last index whose coordinate is not above c; -1 when there is none.
    int last_to(int c) const { return c < start ? -1 : std::min((c - start) / step, count - 1); }
    // As the program's tables show how far a coordinate is from the grid: 0 where nothing needs to
    // be done about step or distance.
    int distance_code(int distance) const { return step == 1 && distance == 0 ? 0 : distance + 1; }
};

void check_axis(const Axis& axis, std::string_view name, std::string_view items, int screen) {
    if (axis.step < 1 || axis.count < 1 || axis.start < 0 || axis.at(axis.count - 1) >= screen) {
        throw std::invalid_argument(fmt::format(
            "a processor's grid of {} {}, from {} = {} in steps of {}: expected 1 at least, within "
            "the screen's {}",
            axis.count, items, name, axis.start, axis.step, screen));
    }
}

void check_screen(const isa::Image& image, const TilerScreen& screen) {
    const auto most = static_cast<int>(require_symbol(image, "max_size"));
    if (screen.width < 1 || screen.height < 1 || screen.width > most || screen.height > most) {
        throw std::invalid_argument(
            fmt::format("screen: {} x {} pixels: the program {} draws 1 x 1 to {} x {}",
                        screen.width, screen.height, image.name, most, most));
    }
    if (screen.background < 0 || screen.background > 255) {
        throw std::invalid_argument(fmt::format(
            "a background of {}, expected a grey level of 0 to 255", screen.background));
    }
}

class Table {
  public:
    Table(NodeMemory& memory, std::string_view symbol)
        : memory_(memory), address_(memory.address_of(symbol)) {}
    // Of an entry above the symbol's address.
    void set(int index, int value) {
        memory_.set_at(address_ + 2 * static_cast<std::uint32_t>(index), value);
    }

  private:
    NodeMemory& memory_;
    std::uint32_t address_;
};

void set_step(NodeMemory& memory, std::string_view step, std::string_view shift, int value) {
    const auto bits = static_cast<unsigned>(value);
    memory.set(step, value);
    memory.set(shift, std::has_single_bit(bits) ? std::countr_zero(bits) : -1);
}

void add_columns(NodeMemory& memory, const Axis& axis, int width) {
    set_step(memory, "x_step", "x_shift", axis.step);
    Table first(memory, "first_pixel");
    Table lead(memory, "lead_at");
    for (int x = 0; x <= width; ++x) {
        const int column = axis.first_from(x);
        first.set(x, static_cast<int>(kDepthWindow) + 2 * column);
        if (x < width && column < axis.count) {
            lead.set(x, axis.distance_code(axis.at(column) - x));
        }
    }
}

void add_rows(NodeMemory& memory, const Axis& axis, int height) {
    set_step(memory, "y_step", "y_shift", axis.step);
    Table highest(memory, "row_below");
    Table lag(memory, "lag_at");
    for (int y = -1; y < height; ++y) {
        const int row = axis.last_to(y);
        highest.set(y + 1, row);
        if (row >= 0) {
            lag.set(y, axis.distance_code(y - axis.at(row)));
        }
    }
    Table line(memory, "line_of");
    for (int row = 0; row < axis.count; ++row) {
        line.set(row, axis.at(row));
    }
}

}  // namespace

std::vector<isa::Segment> tiler_memory(const isa::Image& image, const topology::PixelGrid& grid,
                                       const TilerScreen& screen) {
    NodeMemory memory(image, "parameters", "parameters_end", "parameters_end");
    check_screen(image, screen);
    const Axis x{grid.x_start, grid.x_step, grid.columns};
    const Axis y{grid.y_start, grid.y_step, grid.rows};
    check_axis(x, "x", "columns", screen.width);
    check_axis(y, "y", "rows", screen.height);
    if (grid.columns > kMaxFrameBufferColumns) {
        throw std::invalid_argument(
            fmt::format("{} columns of pixels for one processor: the windows of its frame buffer "
                        "have {}",
                        grid.columns, kMaxFrameBufferColumns));
    }
    memory.set("background", screen.background * kShadeUnit);
    add_columns(memory, x, screen.width);
    add_rows(memory, y, screen.height);
    std::vector<isa::Segment> segments = memory.segments();
    std::erase_if(segments, [](const isa::Segment& segment) { return segment.bytes.empty(); });
    return segments;
}

void load_tiler(isa::Core& core, const isa::Image& image, const topology::PixelGrid& grid,
                const TilerScreen& screen) {
    for (const isa::Segment& segment : tiler_memory(image, grid, screen)) {
        core.write_memory(segment.address, segment.bytes);
    }
}

int tiler_phases_per_frame(const isa::Image& image) {
    return static_cast<int>(require_symbol(image, "phases_per_frame"));
}

}  // namespace rasterloom
