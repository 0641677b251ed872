// SPDX-License-Identifier: MIT
#include "programs/vliw_chain.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>

namespace rasterloom::test {
namespace {

constexpr std::uint32_t kSourceAt = 0x1000;
constexpr std::uint32_t kReceiveAt = 0x2800;
constexpr std::uint32_t kDatabaseAt = 0x4000;
constexpr std::uint32_t kDatabaseEnd = 0x8000;
constexpr int kFocal = 11200;
constexpr int kNear = 4097;
constexpr int kOne = 1 << 14;  // s1.14
constexpr int kNearest = 5000;
constexpr int kDepth = 9000;
constexpr int kTexelColumns = 256;
constexpr int kTexelRows = 129;

std::uint16_t word(std::int64_t value) {
    return static_cast<std::uint16_t>(value);
}

class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }

  private:
    std::mt19937 engine_;
};

struct Place {
    int x = 0;
    int y = 0;  // 1/16 pixel
    int z = 0;
};

int area(const std::array<Place, 3>& p) {
    return (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
}

std::array<Place, 3> triangle(Random& random, int size, ScreenSize screen) {
    const int x = 16 * random.below(screen.columns);
    const int y = 16 * random.below(screen.rows);
    const int z = kNearest + random.below(kDepth);
    std::array<Place, 3> places;
    do {
        for (Place& place : places) {
            place = {x + random.below(16 * size) - 8 * size, y + random.below(16 * size) - 8 * size,
                     z + random.below(1500)};
        }
    } while (std::abs(area(places)) < 512);
    if (area(places) > 0) {  // y goes down
        std::swap(places[1], places[2]);
    }
    return places;
}

ScenePolygon polygon(Random& random, int size, ScreenSize screen, bool textured) {
    ScenePolygon words{};
    std::size_t at = 0;
    for (const Place& place : triangle(random, size, screen)) {
        const double scale = static_cast<double>(place.z) / kFocal;
        const double tilt = random.below(100) / 70.0;
        for (const std::uint16_t value :
             {word(std::lround((place.x - 8 * screen.columns) * scale)),
              word(std::lround((8 * screen.rows - place.y) * scale)), word(place.z),
              word(std::lround(std::sin(tilt) * kOne)), std::uint16_t{0},
              word(std::lround(-std::cos(tilt) * kOne)), word(random.below(65536))}) {
            words.at(at++) = value;
        }
    }
    words[21] = word(random.below(65536));
    words[22] = word(random.below(256) << 8);
    words[23] = word(textured ? 1 : 0);
    return words;
}

void write_tables(VliwRenderer& renderer, int lane) {
    Words reciprocals(0x8000, 65535);
    for (std::size_t z = kNear; z < reciprocals.size(); ++z) {
        reciprocals[z] = word(std::lround(268435456.0 / static_cast<double>(z)));
    }
    renderer.write(lane, renderer.symbol("reciprocals"), reciprocals);
    Words roots;
    for (int m = 128; m < 512; ++m) {
        roots.push_back(word(std::lround(262144 / std::sqrt(2.0 * m))));
    }
    renderer.write(lane, renderer.symbol("roots"), roots);
    Words texels;
    for (int row = 0; row < kTexelRows; ++row) {
        for (int column = 0; column < kTexelColumns; ++column) {
            texels.push_back(word((column % 128 * 128 + row % 128) * 40503));
        }
    }
    renderer.write(lane, isa::vliw::slow_address(0, 0), texels);
}

// To the lane of its number, or to so many lanes as `duplication` says. How many each has.
std::vector<int> deal(VliwRenderer& renderer, const std::vector<ScenePolygon>& scene,
                      const Defines& options) {
    const auto lanes = static_cast<std::size_t>(renderer.lanes());
    const auto copies = options.find("duplication");
    const std::size_t apart =
        lanes / static_cast<std::size_t>(copies == options.end() ? 1 : copies->second);
    const int pitch = renderer.symbol("kDatabase");
    std::vector<int> counts(lanes);
    for (std::size_t i = 0; i < scene.size(); ++i) {
        for (std::size_t lane = i * 7 % apart; lane < lanes; lane += apart) {
            renderer.write(static_cast<std::int64_t>(lane),
                           kDatabaseAt + static_cast<std::uint32_t>(pitch * counts[lane]++),
                           scene[i]);
        }
    }
    return counts;
}

void write_view(VliwRenderer& renderer, int lane) {
    renderer.write(lane, "focal", kFocal);
    renderer.write(lane, "near", kNear);
    renderer.write(lane, "ambient", 20);
    renderer.write(lane, renderer.symbol("sun"), Words{0, 0, word(-kOne)});
    renderer.write(lane, "sun_diffuse", 200);
}

// Where `words_at` says on the pixel's lane.
template <typename WordsAt>
ScreenPicture picture(ScreenSize screen, const WordsAt& words_at) {
    ScreenPicture pixels;
    for (int y = 0; y < screen.rows; ++y) {
        for (int x = 0; x < screen.columns; ++x) {
            pixels.push_back(words_at(x, y));
        }
    }
    return pixels;
}

ScreenPixel pixel_at(const VliwRenderer& renderer, int lane, std::uint32_t at) {
    return {renderer.read(lane, at), renderer.read(lane, at + 1), renderer.read(lane, at + 2)};
}

}  // namespace

std::string name_of(int lanes, const Defines& options) {
    std::string name = std::to_string(lanes) + " lanes";
    for (const auto& [option, value] : options) {
        name += ", " + option + " " + std::to_string(value);
    }
    return name;
}

std::vector<ScenePolygon> random_scene(int count, int size, std::uint32_t seed, ScreenSize screen) {
    Random random(seed);
    std::vector<ScenePolygon> scene;
    for (int i = 0; i < count; ++i) {
        scene.push_back(polygon(random, size, screen, i % 2 != 0));
    }
    return scene;
}

std::vector<ScenePolygon> mixed_scene() {
    std::vector<ScenePolygon> scene = random_scene(40, 12, 1);
    std::ranges::copy(random_scene(16, 70, 2), std::back_inserter(scene));
    return scene;
}

VliwRenderer chain_of(std::string_view file, const std::vector<ScenePolygon>& scene,
                      Defines options, int lanes, Form form, ScreenSize screen) {
    options["screen_columns"] = screen.columns;
    options["screen_rows"] = screen.rows;
    VliwRenderer renderer(file, options, lanes, form);
    const std::vector<int> counts = deal(renderer, scene, options);
    for (int lane = 0; lane < lanes; ++lane) {
        renderer.write(lane, "polygons", counts[static_cast<std::size_t>(lane)]);
        renderer.write(lane, "most", std::ranges::max(counts));
        renderer.write(lane, "polygons_at", kDatabaseAt);
        renderer.write(lane, "homes_end", kDatabaseEnd);
        renderer.write(lane, "source_at", kSourceAt);
        renderer.write(lane, "source_end", kReceiveAt);
        renderer.write(lane, "receive_at", kReceiveAt);
        renderer.write(lane, "receive_end", kDatabaseAt);
        write_view(renderer, lane);
        write_tables(renderer, lane);
    }
    turn_scene(renderer, 0);
    return renderer;
}

void turn_scene(VliwRenderer& renderer, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    const double middle = kNearest + kDepth / 2.0;
    const std::uint16_t cosine = word(std::lround(std::cos(angle) * kOne));
    const double sine = std::sin(angle);
    const Words matrix = {cosine,
                          0,
                          word(std::lround(sine * kOne)),
                          0,
                          kOne,
                          0,
                          word(std::lround(-sine * kOne)),
                          0,
                          cosine,
                          word(std::lround(-sine * middle)),
                          0,
                          word(std::lround(middle * (1 - std::cos(angle))))};
    for (std::int64_t lane = 0; lane < renderer.lanes(); ++lane) {
        renderer.write(lane, renderer.symbol("matrix"), matrix);
    }
}

ScreenPicture shown_picture(const VliwRenderer& renderer, ScreenSize screen) {
    return picture(screen, [&](int x, int y) {
        return pixel_at(renderer, x, static_cast<std::uint32_t>(renderer.read(x, "shown") + 3 * y));
    });
}

ScreenPicture composited_picture(const VliwRenderer& renderer, ScreenSize screen) {
    const int group = renderer.symbol("group");
    const int columns = renderer.symbol("kRegionColumns");
    const int band_rows = renderer.symbol("band_rows");
    const int members = static_cast<int>(renderer.lanes()) / group;
    const int sets = (columns * band_rows + members - 1) / members;
    return picture(screen, [&](int x, int y) {
        const int region = x / columns;
        const int p = (x - region * columns) * band_rows + y % band_rows;
        const int offset = 3 * (y / band_rows * sets + p / members);
        return pixel_at(renderer, region + group * (p % members),
                        isa::vliw::slow_address(0, renderer.symbol("kGathered")) +
                            static_cast<std::uint32_t>(offset));
    });
}

int differences(const ScreenPicture& a, const ScreenPicture& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0, std::plus<>(),
                              std::not_equal_to<>());
}

ScreenPicture sort_middle_picture(const std::vector<ScenePolygon>& scene, Defines options,
                                  ScreenSize screen) {
    VliwRenderer renderer =
        chain_of("sort_middle.s", scene, std::move(options), screen.columns, Form::packed, screen);
    if (renderer.run()) {
        throw std::runtime_error("sort_middle.s has halted");
    }
    return shown_picture(renderer, screen);
}

}  // namespace rasterloom::test
