// SPDX-License-Identifier: MIT
// sort_middle.s as a whole, from the database to the picture.
#include "programs/vliw_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

constexpr int kLanes = 32;  // the left edge of the screen
constexpr int kRows = 512;
constexpr int kPolygonWords = 24;
constexpr std::uint32_t kDatabaseAt = 0x1000;
constexpr std::uint32_t kSourceAt = 0x2000;
constexpr std::uint32_t kReceiveAt = 0x4000;
constexpr std::uint32_t kReceiveEnd = 0x6000;
constexpr int kNear = 4097;
constexpr int kFocal = 11200;
constexpr int kOne = 1 << 14;  // s1.14

using Database = std::vector<Words>;  // polygons

std::uint16_t word(std::int64_t value) {
    return static_cast<std::uint16_t>(value);
}

// Facing the viewer, at the screen's left edge.
Database random_database(int count, std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto below = [&random](int n) {
        return static_cast<int>(random() % static_cast<unsigned>(n));
    };
    Database database;
    for (int i = 0; i < count; ++i) {
        const int z = 6000 + below(6000);
        const auto column = static_cast<double>(below(kLanes));
        const double row = below(kRows);
        Words polygon;
        for (int vertex = 0; vertex < 3; ++vertex) {
            const double x = column + (vertex == 2 ? 8 : 0);
            const double y = row + (vertex == 0 ? -12 : 12);
            polygon.insert(polygon.end(), {word(std::lround((x - 384) * 16 / kFocal * z)),
                                           word(std::lround((256 - y) * 16 / kFocal * z)), word(z),
                                           0, 0, word(-kOne), word(below(65536))});
        }
        polygon.insert(polygon.end(), {word(below(65536)), word(below(256) << 8), word(i % 2)});
        database.push_back(polygon);
    }
    return database;
}

void write_tables(VliwRenderer& renderer, int lane) {
    Words reciprocals(0x8000, 65535);
    for (std::size_t z = 4097; z < reciprocals.size(); ++z) {
        reciprocals[z] = word(std::lround(268435456.0 / static_cast<double>(z)));
    }
    renderer.write(lane, renderer.symbol("reciprocals"), reciprocals);
    Words texels(129 * 256);
    for (std::size_t i = 0; i < texels.size(); ++i) {
        texels[i] = word(static_cast<std::int64_t>(i % 256 % 128 + 129 * (i / 256 % 128)));
    }
    renderer.write(lane, isa::vliw::slow_address(0, 0), texels);
}

Words identity() {
    return {kOne, 0, 0, 0, kOne, 0, 0, 0, kOne, 0, 0, 0};
}

VliwRenderer renderer_of(const Database& database, const Defines& options,
                         Form form = Form::packed) {
    VliwRenderer renderer("sort_middle.s", options, kLanes, form);
    std::array<int, kLanes> counts{};
    const auto copies = options.find("duplication");
    const auto apart =
        static_cast<std::size_t>(kLanes / (copies == options.end() ? 1 : copies->second));
    for (std::size_t i = 0; i < database.size(); ++i) {
        for (std::size_t lane = i % apart; lane < kLanes; lane += apart) {
            renderer.write(static_cast<std::int64_t>(lane),
                           kDatabaseAt + static_cast<std::uint32_t>(kPolygonWords * counts[lane]++),
                           database[i]);
        }
    }
    for (int lane = 0; lane < kLanes; ++lane) {
        renderer.write(lane, "polygons", counts[static_cast<std::size_t>(lane)]);
        renderer.write(lane, "most", std::ranges::max(counts));
        renderer.write(lane, "polygons_at", kDatabaseAt);
        renderer.write(lane, "source_at", kSourceAt);
        renderer.write(lane, "source_end", kReceiveAt);
        renderer.write(lane, "receive_at", kReceiveAt);
        renderer.write(lane, "receive_end", kReceiveEnd);
        renderer.write(lane, "focal", kFocal);
        renderer.write(lane, "near", kNear);
        renderer.write(lane, "ambient", 200);
        renderer.write(lane, renderer.symbol("matrix"), identity());
        write_tables(renderer, lane);
    }
    return renderer;
}

// The words of what is shown.
Words picture(const VliwRenderer& renderer) {
    Words words;
    for (int lane = 0; lane < kLanes; ++lane) {
        const std::uint32_t at = renderer.read(lane, "shown");
        for (std::uint32_t i = 0; i < 3 * kRows; ++i) {
            words.push_back(renderer.read(lane, at + i));
        }
    }
    return words;
}
Words picture_of(const Database& database, const Defines& options, Form form = Form::packed) {
    VliwRenderer renderer = renderer_of(database, options, form);
    EXPECT_FALSE(renderer.run());
    return picture(renderer);
}

class VliwSortMiddle : public ::testing::TestWithParam<int> {};

TEST_P(VliwSortMiddle, DrawsTheSamePictureWhateverItsOptions) {
    const int textured = GetParam();
    const Database database = random_database(60, 1);
    const Words plain = picture_of(database, {{"textured", textured}});
    EXPECT_GT(std::ranges::count_if(plain, [](std::uint16_t word) { return word != 0; }), 10000);
    EXPECT_EQ(picture_of(database, {{"textured", textured}}, Form::as_written), plain);
    for (Defines options : std::vector<Defines>{{{"line_locked", 1}},
                                                {{"stride", 8}},
                                                {{"stride", 4}, {"line_locked", 1}},
                                                {{"dense", 0}},
                                                {{"dense", 0}, {"stride", 2}},
                                                {{"duplication", 2}},
                                                {{"duplication", 8}, {"stride", 4}}}) {
        options.emplace("textured", textured);
        EXPECT_EQ(picture_of(database, options), plain) << options.begin()->first;
    }
}

INSTANTIATE_TEST_SUITE_P(Shaded, VliwSortMiddle, ::testing::Values(0));
INSTANTIATE_TEST_SUITE_P(Textured, VliwSortMiddle, ::testing::Values(1));

TEST(VliwSortMiddleLineLocked, DrawsByTheMatrixThatHasCome) {
    VliwRenderer renderer = renderer_of(random_database(20, 2), {{"line_locked", 1}});
    renderer.aux = {0x8000};
    Words moved = identity();
    moved[11] = 50;  // away from the viewer
    renderer.aux.insert(renderer.aux.end(), moved.begin(), moved.end());
    renderer.run();
    const Words first = picture(renderer);
    renderer.run();
    const Words second = picture(renderer);
    EXPECT_NE(second, first);
    EXPECT_NE(second, Words(second.size()));
    renderer.run();
    EXPECT_EQ(picture(renderer), second);
}

}  // namespace
}  // namespace rasterloom::test
