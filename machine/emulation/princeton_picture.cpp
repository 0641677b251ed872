// SPDX-License-Identifier: MIT
#include "machine/emulation/princeton_picture.hpp"

#include "machine/emulation/node_memory.hpp"

#include <span>
#include <utility>

namespace rasterloom {

namespace {

using Words = std::vector<std::uint16_t>;

// The pixel's words, as memory.s lays them out.
void put(PrincetonPicture& result, int x, int y, std::span<const std::uint16_t> pixel) {
    if (pixel[0] == 0)
        return;
    const auto upper = [](std::uint16_t word) { return static_cast<std::uint8_t>(word >> 8); };
    const auto lower = [](std::uint16_t word) { return static_cast<std::uint8_t>(word & 0xff); };
    result.depth[static_cast<std::size_t>(y * result.picture.width + x)] =
        static_cast<std::uint32_t>(pixel[0]) << 8 | upper(pixel[1]);
    result.picture.at(x, y, 0) = lower(pixel[1]);
    result.picture.at(x, y, 1) = upper(pixel[2]);
    result.picture.at(x, y, 2) = lower(pixel[2]);
}

class Collector {
  public:
    Collector(const LockstepArray& array, const isa::Image& image)
        : array_(array), image_(image), pixel_words_(at("kPixel")) {
        const host::TriangleView screen = program_view(image);
        result_.picture = host::Picture(screen.width, screen.height, 3);
        result_.depth.assign(
            static_cast<std::size_t>(screen.width) * static_cast<std::size_t>(screen.height), 0);
    }

    void take_columns(const ColumnMap& columns) {
        const std::uint32_t shown = at("shown");
        Words words(static_cast<std::size_t>(result_.picture.height) * pixel_words_);
        for (std::size_t lane = 0; lane < columns.size(); ++lane)
            if (const auto column = columns[lane]) {
                const auto index = static_cast<std::int64_t>(lane);
                array_.read(index, array_.read(index, shown), words);
                for (int y = 0; y < result_.picture.height; ++y)
                    put(result_, *column, y, pixel(words, static_cast<std::size_t>(y)));
            }
    }

    // Pixel p of a region's band, counted down its columns, is with member p mod m.
    void take_composited() {
        const std::size_t group = at("group");
        const std::size_t columns = at("kRegionColumns");
        const std::size_t rows = at("band_rows");
        const std::size_t members = static_cast<std::size_t>(array_.lanes()) / group;
        const std::size_t sets = (columns * rows + members - 1) / members;
        const std::vector<Words> lanes = gathered(at("bands") * sets);
        for (int x = 0; x < result_.picture.width; ++x)
            for (int y = 0; y < result_.picture.height; ++y) {
                const auto column = static_cast<std::size_t>(x);
                const auto row = static_cast<std::size_t>(y);
                const std::size_t p = column % columns * rows + row % rows;
                put(result_, x, y,
                    pixel(lanes[column / columns + group * (p % members)],
                          row / rows * sets + p / members));
            }
    }

    PrincetonPicture result() { return std::move(result_); }

  private:
    std::uint32_t at(const char* symbol) const { return require_symbol(image_, symbol); }

    std::span<const std::uint16_t> pixel(const Words& words, std::size_t index) const {
        return std::span(words).subspan(index * pixel_words_, pixel_words_);
    }

    // [lane]: that many pixels.
    std::vector<Words> gathered(std::size_t pixels) const {
        std::vector<Words> lanes(static_cast<std::size_t>(array_.lanes()),
                                 Words(pixels * pixel_words_));
        for (std::size_t lane = 0; lane < lanes.size(); ++lane)
            array_.read(static_cast<std::int64_t>(lane), slow_word(0, 0) + at("kGathered"),
                        lanes[lane]);
        return lanes;
    }

    const LockstepArray& array_;
    const isa::Image& image_;
    std::size_t pixel_words_;
    PrincetonPicture result_;
};

}  // namespace

PrincetonPicture shown_picture(const LockstepArray& array, const isa::Image& image,
                               const ColumnMap& columns) {
    Collector collector(array, image);
    if (has_frame_buffers(image))
        collector.take_columns(columns);
    else
        collector.take_composited();
    return collector.result();
}

}  // namespace rasterloom
