// SPDX-License-Identifier: MIT
// One processor with the tiler in its memory, its frame buffer and the registers the tiler uses; no
// machine around it.
#pragma once

#include "isa/core.hpp"
#include "isa/image.hpp"
#include "isa/isa.hpp"
#include "machine/fabric/polygon.hpp"
#include "machine/host/polygon_renderer.hpp"
#include "topologies/tiling.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace rasterloom::test {

// Which of the programs that one source makes.
struct TilerVariant {
    bool full = true;
    bool skip_deltas = false;
    bool bus = false;
    bool digests = false;  // half-digested broadcast

    friend auto operator<=>(const TilerVariant&, const TilerVariant&) = default;
};
std::string name_of(const TilerVariant& variant);

const isa::Image& tiler_image(const TilerVariant& variant);

class TilerNode final : private isa::Bus {
  public:
    using Message = std::vector<std::uint8_t>;

    TilerNode(const TilerVariant& variant, const topology::PixelGrid& grid, int width, int height,
              int background = 0);

    // Draws the polygons and ends the frame. Throws std::runtime_error when the program traps,
    // stalls for ever, writes beside its windows or does not come to an end.
    void draw(std::span<const Polygon> polygons);
    void draw_frames(std::span<const std::vector<Polygon>> frames);

    // The same piece by piece: messages that wait at ports 0 and 1, those sent by port 1 and how
    // many of these there is room for.
    std::array<std::deque<Message>, 2> inputs;
    std::deque<Message> outputs;
    std::size_t output_places = 1;
    // Until it stalls or halts; whether it did anything.
    bool run();
    bool halted() const { return halted_; }
    // Whether it has given its credit back and waits for the supervisor.
    bool has_ended_frame() const { return credit_ == 0; }
    void announce(bool another_frame);

    std::int16_t depth(int row, int column) const { return depth_.at(index(row, column)); }
    // Grey level.
    int grey(int row, int column) const;
    const topology::PixelGrid& grid() const { return grid_; }
    std::int64_t cycles() const { return cycles_; }
    // Cycles from a tap to the next one, and how often it was passed, by the tap's name.
    struct Section {
        std::int64_t passes = 0;
        std::int64_t cycles = 0;
    };
    const std::map<std::string, Section>& sections() const { return sections_; }
    // Pixels of every segment, and vertices of every polygon, as the taps show them.
    const std::vector<int>& lengths() const { return lengths_; }
    const std::vector<int>& vertices() const { return vertices_; }
    // Booking of sections costs time; off at first.
    void watch_taps();

  private:
    Read read(std::uint32_t address, int bytes) override;
    Status write(std::uint32_t address, std::uint32_t value, int bytes) override;
    Status write_own(std::uint32_t address, std::uint32_t value);
    Status receive(std::deque<Message>& from, std::uint32_t address);
    Status send(std::uint32_t length);
    void select(std::uint32_t row);
    void clear(std::uint16_t shade);
    void keep_row();
    void note_tap();
    std::uint16_t word(std::uint32_t address) const;
    std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row * grid_.columns + column);
    }

    TilerVariant variant_;
    topology::PixelGrid grid_;
    std::unique_ptr<isa::Core> core_;
    bool halted_ = false;
    int credit_ = 1;
    std::uint32_t phase_ = 0;
    std::uint32_t phase_seen_ = 0;
    std::uint32_t send_address_ = 0;
    int row_ = -1;
    std::vector<std::int16_t> depth_;
    std::vector<std::int16_t> image_;
    std::int64_t cycles_ = 0;
    std::map<std::uint32_t, std::string> taps_;
    std::map<std::string, Section> sections_;
    Section* section_ = nullptr;
    std::vector<int> lengths_;
    std::vector<int> vertices_;
};

// As the host sends it; the end of the frame for none.
TilerNode::Message polygon_message(const Polygon* polygon);

// Where the processor's pixels differ from the reference, in words; empty: nowhere.
std::string difference(const TilerNode& node, const host::DepthPicture& reference);

host::DepthPicture reference_of(const TilerVariant& variant, std::span<const Polygon> polygons,
                                int width, int height);

// Draws on a fresh node with that grid and compares with the reference for the whole screen.
std::string difference_of(const TilerVariant& variant, const topology::PixelGrid& grid,
                          std::span<const Polygon> polygons, int width, int height);

}  // namespace rasterloom::test
