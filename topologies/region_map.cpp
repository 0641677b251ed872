// SPDX-License-Identifier: MIT
#include "topologies/region_map.hpp"

#include "topologies/text_line.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::topology {

namespace {

constexpr int kMostPixels = 4096;  // each way

// The pixels of both; none when they do not meet.
std::optional<PixelBox> common(const PixelBox& a, const PixelBox& b) {
    const PixelBox both{std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1),
                        std::min(a.y1, b.y1)};
    if (both.x0 > both.x1 || both.y0 > both.y1)
        return std::nullopt;
    return both;
}

// Rectangles laid on a screen one after the other.
class Canvas {
  public:
    Canvas(const std::string& name, int width, int height, std::span<const RegionMap::Share> shares)
        : name_(name),
          width_(width),
          height_(height),
          shares_(shares),
          share_at_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), kNone) {}

    void lay(std::size_t number) {
        const auto& [region, box, line] = shares_[number];
        if (box.x1 >= width_ || box.y1 >= height_)
            throw TextFileError(fmt::format(
                "{}:{}: the rectangle ({},{}) ({},{}) reaches beyond the screen of {} x {} pixels, "
                "expected x up to {} and y up to {}",
                name_, line, box.x0, box.y0, box.x1, box.y1, width_, height_, width_ - 1,
                height_ - 1));
        for (int y = box.y0; y <= box.y1; ++y)
            for (int x = box.x0; x <= box.x1; ++x) {
                std::size_t& share = share_at_[place(x, y)];
                if (share != kNone)
                    throw TextFileError(fmt::format(
                        "{}:{}: pixel ({},{}) is given to processor {}, but line {} "
                        "has given it to processor {}; expected each pixel once",
                        name_, line, x, y, region, shares_[share].line, shares_[share].region));
                share = number;
            }
    }

    std::vector<RegionIndex> row(int y) const {
        std::vector<RegionIndex> regions;
        for (int x = 0; x < width_; ++x) {
            const std::size_t share = share_at_[place(x, y)];
            if (share == kNone)
                throw TextFileError(fmt::format(
                    "{}: pixel ({},{}) is given to no processor; expected each pixel once", name_,
                    x, y));
            regions.push_back(shares_[share].region);
        }
        return regions;
    }

  private:
    static constexpr std::size_t kNone = ~std::size_t{0};

    std::size_t place(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }

    const std::string& name_;
    int width_;
    int height_;
    std::span<const RegionMap::Share> shares_;
    std::vector<std::size_t> share_at_;  // of each pixel
};

std::vector<RegionRange> ranges_of(std::vector<RegionIndex>& regions) {
    std::sort(regions.begin(), regions.end());
    std::vector<RegionRange> ranges;
    for (const RegionIndex region : regions) {
        if (ranges.empty() || region > ranges.back().last + 1)
            ranges.push_back({region, region});
        else
            ranges.back().last = region;
    }
    return ranges;
}

}  // namespace

RegionMap::RegionMap(const std::string& name, int width, int height, RegionIndex regions,
                     std::span<const Share> shares)
    : width_(width), height_(height), rectangles_(regions) {
    if (width < 1 || height < 1 || width > kMostPixels || height > kMostPixels)
        throw std::invalid_argument(
            fmt::format("screen map: a screen of {} x {} pixels, expected 1 to {} each way", width,
                        height, kMostPixels));
    Canvas canvas(name, width, height, shares);
    for (std::size_t number = 0; number < shares.size(); ++number) {
        if (shares[number].region >= regions)
            throw std::invalid_argument(fmt::format("screen map: region {}, expected 0 to {}",
                                                    shares[number].region, regions - 1));
        canvas.lay(number);
        rectangles_[shares[number].region].push_back(shares[number].box);
    }
    for (int y = 0; y < height; ++y)
        add_row(canvas.row(y));
}

void RegionMap::add_row(std::vector<RegionIndex> row) {
    if (bands_.empty() || bands_.back().region != row) {
        std::vector<std::uint16_t> run_end(row.size());
        for (std::size_t x = row.size(); x-- > 0;)
            run_end[x] = x + 1 < row.size() && row[x] == row[x + 1]
                             ? run_end[x + 1]
                             : static_cast<std::uint16_t>(x + 1);
        bands_.push_back({std::move(row), std::move(run_end)});
    }
    band_of_row_.push_back(static_cast<std::uint16_t>(bands_.size() - 1));
}

RegionIndex RegionMap::region_at(int x, int y) const {
    return bands_[band_of_row_[static_cast<std::size_t>(y)]].region[static_cast<std::size_t>(x)];
}

std::vector<RegionRange> RegionMap::regions_in(const PixelBox& box) const {
    const auto on_screen = common(box, {0, 0, width_ - 1, height_ - 1});
    if (!on_screen)
        return {};
    std::vector<RegionIndex> regions;
    const auto last_band = band_of_row_[static_cast<std::size_t>(on_screen->y1)];
    for (std::size_t b = band_of_row_[static_cast<std::size_t>(on_screen->y0)]; b <= last_band; ++b)
        for (auto x = static_cast<std::size_t>(on_screen->x0);
             x <= static_cast<std::size_t>(on_screen->x1); x = bands_[b].run_end[x])
            regions.push_back(bands_[b].region[x]);
    return ranges_of(regions);
}

std::int64_t RegionMap::pixels_in(const PixelBox& box, RegionIndex region) const {
    std::int64_t sum = 0;
    for (const PixelBox& rectangle : rectangles_[region])
        if (const auto both = common(box, rectangle))
            sum += both->pixels();
    return sum;
}

RegionMap column_map(int width, int height, RegionIndex regions) {
    const auto strips = std::min<std::int64_t>(width, regions);
    std::vector<RegionMap::Share> shares;
    const auto begin_of = [&](std::int64_t strip) {
        return static_cast<int>(strip * width / strips);
    };
    for (std::int64_t strip = 0; strip < strips; ++strip)
        shares.push_back({static_cast<RegionIndex>(strip),
                          {begin_of(strip), 0, begin_of(strip + 1) - 1, height - 1}});
    return {"columns", width, height, regions, shares};
}

RegionMap read_region_map(std::istream& in, const std::string& name, int width, int height,
                          RegionIndex regions) {
    std::vector<RegionMap::Share> shares;
    for_each_line(in, name, [&](TextLine& line) {
        const auto region = line.whole("the processor", 0, std::int64_t{regions} - 1);
        shares.push_back({static_cast<RegionIndex>(region), line.box(), line.number()});
        line.expect_end("the second corner");
    });
    if (shares.empty())
        throw TextFileError(
            fmt::format("{}: nothing in the file, expected lines 'processor (x,y) (x,y)'", name));
    return {name, width, height, regions, shares};
}

RegionMap region_map_file(const std::string& path, int width, int height, RegionIndex regions) {
    std::ifstream in = open_text_file(path, "a map of the screen to processors");
    return read_region_map(in, path, width, height, regions);
}

std::string region_map_as_text(const RegionMap& map) {
    fmt::memory_buffer text;
    for (RegionIndex region = 0; region < map.regions(); ++region)
        for (const PixelBox& box : map.rectangles_of(region))
            fmt::format_to(std::back_inserter(text), "{} ({},{}) ({},{})\n", region, box.x0, box.y0,
                           box.x1, box.y1);
    return fmt::to_string(text);
}

}  // namespace rasterloom::topology
