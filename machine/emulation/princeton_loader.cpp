// SPDX-License-Identifier: MIT
#include "machine/emulation/princeton_loader.hpp"

#include "machine/emulation/node_memory.hpp"
#include "machine/emulation/princeton_boxes.hpp"
#include "machine/host/triangle_tables.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

namespace rasterloom {

namespace {

constexpr std::int64_t kRoomEnd = 0x8000;  // of databases and queues
constexpr std::uint16_t kNoColumn = 0x7fff;
constexpr std::int64_t kMostLanes = 65536;
constexpr std::int64_t kMostGrowth = 2;  // of a lane's polygons, sort-first
constexpr int kTextureRow = 256;         // words from a row of texels to the next

std::int64_t rounded_up(std::int64_t a, std::int64_t b) {
    return (a + b - 1) / b;
}

class Loader {
  public:
    Loader(LockstepArray& array, const isa::Image& image)
        : array_(array),
          image_(image),
          copies_(image.symbol("duplication").value_or(1)),
          has_homes_(image.symbol("sort_first").value_or(0) != 0),
          room_(static_cast<std::int64_t>(at("scratch_end"))),
          polygon_(static_cast<std::int64_t>(at("kDatabase"))),
          descriptor_(static_cast<std::int64_t>(at("kDescriptor"))) {
        if (array.lanes() % copies_ != 0)
            throw std::invalid_argument(fmt::format(
                "{} lanes for {} copies of the polygons, expected a multiple of the copies",
                array.lanes(), copies_));
    }

    void lay_out() {
        const std::uint32_t frames = at("frame_buffers");
        const std::uint32_t roots = at("roots");
        array_.set_layout(0, frames, LaneLayout::across);
        array_.set_layout(frames, roots - frames, LaneLayout::along);
        array_.set_layout(roots, static_cast<std::uint32_t>(room_) - roots, LaneLayout::shared);
        array_.set_layout(static_cast<std::uint32_t>(room_),
                          static_cast<std::uint32_t>(kRoomEnd - room_), LaneLayout::along);
        array_.set_layout(at("reciprocals"), kRoomEnd, LaneLayout::shared);
        if (image_.symbol("kRegion"))
            lay_out_region();
        else if (image_.symbol("wanted"))
            lay_out_lists();
    }

    void load_tables() {
        array_.write_all(at("roots"), host::root_table());
        array_.write_all(at("reciprocals"), host::reciprocal_table());
    }

    void load_columns(const ColumnMap& columns) {
        for (std::int64_t lane = 0; lane < array_.lanes(); ++lane) {
            set(lane, "lane", lane);
            set(lane, "column", columns[static_cast<std::size_t>(lane)].value_or(kNoColumn));
        }
        set("lanes", array_.lanes() % kMostLanes);
    }

    void load_polygons(std::span<const host::SceneTriangle> polygons) {
        const std::int64_t groups = array_.lanes() / copies_;
        const auto count = static_cast<std::int64_t>(polygons.size());
        const std::int64_t most = rounded_up(count, groups);
        check_fit(count, most);
        for (std::int64_t lane = 0; lane < array_.lanes(); ++lane) {
            std::uint32_t address = static_cast<std::uint32_t>(room_);
            std::int64_t own = 0;
            for (std::int64_t b = lane % groups; b < count; b += groups, ++own) {
                array_.write(lane, address, host::to_words(polygons[static_cast<std::size_t>(b)]));
                address += static_cast<std::uint32_t>(polygon_);
            }
            set(lane, "polygons", own);
        }
        set("most", most);
        set("polygons_at", room_);
        if (has_homes_)
            divide_homes(most);
        else
            divide_rest(room_ + most * polygon_);
    }

    // Polygons that geometry has gone over already.
    void load_boxes(std::span<const host::BoundingBox> boxes) {
        if (at("boxes") == 0)
            throw std::invalid_argument(
                "bounding boxes for a program that makes its descriptors itself, expected its "
                "option boxes to be 1");
        if (std::ssize(boxes) > kMostDrawnBoxes)
            throw std::invalid_argument(fmt::format("{} bounding boxes, expected {} at most",
                                                    boxes.size(), kMostDrawnBoxes));
        divide_rest(room_);
        const auto sources = descriptors_of(boxes);
        const std::int64_t fitting = room_for_sources(room_);
        for (std::int64_t lane = 0; lane < array_.lanes(); ++lane) {
            const auto& words = sources[static_cast<std::size_t>(lane)];
            const std::int64_t count = std::ssize(words) / descriptor_;
            if (count > fitting)
                throw std::invalid_argument(fmt::format(
                    "{} visible polygons on lane {}, expected {} at most", count, lane, fitting));
            array_.write(lane, static_cast<std::uint32_t>(room_), words);
            set(lane, "source_count", count);
        }
    }

    void load_view(const host::TriangleView& view) {
        load_matrix(view.matrix);
        set("focal", view.focal);
        set("near", view.near);
    }

    void load_matrix(const std::array<std::int16_t, 12>& matrix) {
        std::array<std::uint16_t, 12> words{};
        std::copy(matrix.begin(), matrix.end(), words.begin());
        array_.write_all(at("matrix"), words);
    }

    void load_lights(const host::TriangleLights& lights) {
        set("ambient", lights.ambient);
        set("sun_diffuse", lights.sun_diffuse);
        set("sun_specular", lights.sun_specular);
        set("lamp_diffuse", lights.lamp_diffuse);
        set("lamp_specular", lights.lamp_specular);
        set("shininess", lights.shininess);
        for (std::uint32_t k = 0; k < 3; ++k) {
            set("sun", lights.sun[k], k);
            set("lamp", lights.lamp[k], k);
        }
    }

    // It repeats: behind its last column and row the first ones follow once more.
    void load_texture(const host::Texture& texture) {
        std::vector<std::uint16_t> words(kTextureRow * host::kTextureSize + host::kTextureSize + 1);
        for (int row = 0; row <= host::kTextureSize; ++row)
            for (int column = 0; column <= host::kTextureSize; ++column)
                words[static_cast<std::size_t>(kTextureRow * row + column)] =
                    texture.at(column % host::kTextureSize, row % host::kTextureSize);
        array_.set_layout(slow_word(0, 0), static_cast<std::uint32_t>(words.size()),
                          LaneLayout::shared);
        array_.write_all(slow_word(0, 0), words);
    }

  private:
    std::uint32_t at(std::string_view symbol) const { return require_symbol(image_, symbol); }

    static std::uint16_t word(std::string_view symbol, std::int64_t value) {
        if (value < -0x8000 || value > 0xffff)
            throw std::invalid_argument(
                fmt::format("{} is {}, expected a value of 16 bits", symbol, value));
        return static_cast<std::uint16_t>(value & 0xffff);
    }

    // Lists in bank 0, as long on each lane as it will, and a word of each pixel in every other
    // bank; what is composited goes to the same place on all lanes.
    void lay_out_region() {
        const std::uint32_t lists = at("wanted");
        const std::uint32_t gathered = at("kGathered");
        const std::uint32_t end = at("kGatheredEnd");
        array_.set_layout(slow_word(0, 0) + lists, gathered - lists, LaneLayout::along);
        array_.set_layout(slow_word(0, 0) + gathered, end - gathered, LaneLayout::across);
        for (int word = 0; word < static_cast<int>(at("kPixel")); ++word)
            array_.set_layout(slow_word(word + 1, 0), isa::vliw::kBankWords, LaneLayout::across);
    }

    void lay_out_lists() {
        const std::uint32_t lists = at("wanted");
        array_.set_layout(slow_word(0, 0) + lists, isa::vliw::kBankWords - lists,
                          LaneLayout::along);
    }

    void set(std::string_view symbol, std::int64_t value, std::uint32_t offset = 0) {
        array_.write_all(at(symbol) + offset, std::array{word(symbol, value)});
    }

    void set(std::int64_t lane, std::string_view symbol, std::int64_t value) {
        array_.write(lane, at(symbol), std::array{word(symbol, value)});
    }

    void check_fit(std::int64_t count, std::int64_t most) const {
        const std::int64_t fitting =
            has_homes_
                ? (kRoomEnd - room_ - 3 * polygon_ - 2 * descriptor_) / (kMostGrowth * polygon_)
                : (kRoomEnd - room_ - 2 * descriptor_) / polygon_;
        if (most <= fitting)
            return;
        const std::int64_t lanes = copies_ * rounded_up(count, fitting);
        const std::string where = copies_ == 1 ? "" : fmt::format(", {} copies of each", copies_);
        throw std::invalid_argument(fmt::format(
            "{} polygons on {} lanes{}: {} on a lane, expected {} at most, which is {} in all; {}",
            count, array_.lanes(), where, most, fitting, fitting * (array_.lanes() / copies_),
            lanes <= kMostLanes ? fmt::format("{} lanes would do", lanes)
                                : fmt::format("not even {} lanes would do", kMostLanes)));
    }

    // [lane]: of the boxes that it is to send.
    std::vector<std::vector<std::uint16_t>> descriptors_of(
        std::span<const host::BoundingBox> boxes) const {
        std::vector<std::vector<std::uint16_t>> sources(static_cast<std::size_t>(array_.lanes()));
        const int right = static_cast<int>(at("screen_columns")) - 1;
        const int bottom = static_cast<int>(at("screen_rows")) - 1;
        for (std::int64_t b = 0; b < std::ssize(boxes); ++b) {
            auto [is_visible, box] = boxes[static_cast<std::size_t>(b)];
            if (!is_visible)
                continue;
            if (box.x0 > right || box.y0 > bottom)
                throw std::invalid_argument(fmt::format(
                    "polygon {}: visible, but its box ({},{}) ({},{}) is off the screen of {} x {} "
                    "pixels, expected a box that meets it",
                    b, box.x0, box.y0, box.x1, box.y1, right + 1, bottom + 1));
            box.x1 = std::min(box.x1, right);
            box.y1 = std::min(box.y1, bottom);
            auto& source = sources[static_cast<std::size_t>(sender_of(b, box.x0))];
            const auto words = box_descriptor(image_, b, box);
            source.insert(source.end(), words.begin(), words.end());
        }
        return sources;
    }

    // Of its copies that one sends a polygon which duplicate.s says.
    std::int64_t sender_of(std::int64_t polygon, int left) const {
        const std::int64_t lanes = array_.lanes();
        const std::int64_t apart = lanes / copies_;
        std::int64_t lane = polygon % apart;
        while ((left - lane - 1 + 2 * lanes) % lanes >= apart)
            lane += apart;
        return lane;
    }

    std::int64_t room_for_sources(std::int64_t begin) const {
        return (kRoomEnd - begin) / descriptor_ - 1;
    }

    // Behind the database: descriptors to be sent, and behind them what is received, which must
    // have room for one at least.
    void divide_rest(std::int64_t begin) {
        const std::int64_t descriptors = (kRoomEnd - begin) / descriptor_;
        const std::int64_t sent = room_for_sources(begin);
        set("source_at", begin);
        set("source_end", begin + sent * descriptor_);
        set("receive_end", begin + descriptors * descriptor_);
    }

    // Sort-first: polygons wander, so lanes have room for more than at first, and for one that
    // passes. What a lane draws are a few of its own and copies, and it makes descriptors of all.
    void divide_homes(std::int64_t most) {
        const std::int64_t homes = room_ + (kMostGrowth * most + 1) * polygon_;
        const std::int64_t drawn = (kRoomEnd - homes) / (polygon_ + descriptor_);
        const std::int64_t copies = homes + drawn * polygon_;
        set("homes_end", homes);
        set("receive_at", homes);
        set("receive_end", copies);
        set("source_at", copies);
        set("source_end", copies + drawn * descriptor_);
    }

    LockstepArray& array_;
    const isa::Image& image_;
    std::int64_t copies_;
    bool has_homes_;
    std::int64_t room_;        // its first word
    std::int64_t polygon_;     // words
    std::int64_t descriptor_;  // words
};

}  // namespace

namespace {

// What is the same whatever is drawn.
Loader with_tables(LockstepArray& array, const isa::Image& image, const ColumnMap& columns) {
    check_columns(columns, array.lanes(), program_view(image).width);
    Loader loader(array, image);
    loader.lay_out();
    loader.load_tables();
    loader.load_columns(columns);
    return loader;
}

}  // namespace

void load_princeton(LockstepArray& array, const isa::Image& image, const host::TriangleScene& scene,
                    const host::TriangleView& view, const host::TriangleLights& lights,
                    const ColumnMap& columns) {
    const host::TriangleView screen = program_view(image);
    if (scene.textures.size() > 1)
        throw std::invalid_argument(
            fmt::format("{} textures, expected one at most", scene.textures.size()));
    if (view.width != screen.width || view.height != screen.height)
        throw std::invalid_argument(fmt::format("a view of {} x {} pixels, expected {} x {}",
                                                view.width, view.height, screen.width,
                                                screen.height));
    Loader loader = with_tables(array, image, columns);
    loader.load_polygons(scene.triangles);
    loader.load_view(view);
    loader.load_lights(lights);
    if (!scene.textures.empty())
        loader.load_texture(scene.textures.front());
}

void load_princeton_boxes(LockstepArray& array, const isa::Image& image,
                          std::span<const host::BoundingBox> boxes, const ColumnMap& columns) {
    with_tables(array, image, columns).load_boxes(boxes);
}

void load_boxes(LockstepArray& array, const isa::Image& image,
                std::span<const host::BoundingBox> boxes) {
    Loader(array, image).load_boxes(boxes);
}

void load_matrix(LockstepArray& array, const isa::Image& image,
                 const std::array<std::int16_t, 12>& matrix) {
    Loader(array, image).load_matrix(matrix);
}

}  // namespace rasterloom
