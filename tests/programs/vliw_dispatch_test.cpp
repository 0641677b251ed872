// SPDX-License-Identifier: MIT
// dispatch.s and duplicate.s: the matrix that comes by the auxiliary input, and who sends a polygon
// that several lanes hold.
#include "programs/vliw_renderer.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

constexpr int kMatrixWords = 12;

constexpr std::array<std::string_view, 1> kFinish = {"finish.s"};

// Pictures of nothing, one a frame.
VliwRenderer idle_renderer() {
    return {kFinish, "geometry:\n setp finish\n line\n", "begin", {{"line_locked", 1}}, 4};
}

Words matrix_of(const VliwRenderer& renderer, int lane) {
    Words words;
    for (int i = 0; i < kMatrixWords; ++i) {
        words.push_back(renderer.read(lane, "matrix", i));
    }
    return words;
}

// Some of its words look like markers.
Words matrix(int seed) {
    Words words(kMatrixWords);
    std::iota(words.begin(), words.end(), static_cast<std::uint16_t>(1000 * seed));
    words[0] = 0x8000;
    words[5] = 0x8001;
    words[11] = 0x8001;
    return words;
}

void append(Words& to, const Words& words) {
    to.insert(to.end(), words.begin(), words.end());
}

TEST(VliwMatrix, ComesByOneIntegerAScanlineForTheNextPicture) {
    for (const int marker : {0x8000, 0x8001}) {
        VliwRenderer renderer = idle_renderer();
        renderer.aux = {static_cast<std::uint16_t>(marker)};
        append(renderer.aux, matrix(1));
        ASSERT_FALSE(renderer.run());
        EXPECT_EQ(matrix_of(renderer, 0), Words(kMatrixWords)) << "not before the picture is done";
        renderer.run();
        EXPECT_EQ(matrix_of(renderer, 0), matrix(1));
        EXPECT_EQ(matrix_of(renderer, 3), matrix(1));
    }
}

TEST(VliwMatrix, StaysUntilAnotherHasCome) {
    VliwRenderer renderer = idle_renderer();
    renderer.aux = {0x8000};
    append(renderer.aux, matrix(1));
    for (int frame = 0; frame < 3; ++frame) {
        renderer.run();
    }
    EXPECT_EQ(matrix_of(renderer, 0), matrix(1));
    renderer.aux.resize(static_cast<std::size_t>(renderer.scanlines()));
    renderer.aux.resize((renderer.aux.size() / 525 + 1) * 525);
    renderer.aux.push_back(0x8001);
    append(renderer.aux, matrix(2));
    renderer.run();
    renderer.run();
    EXPECT_EQ(matrix_of(renderer, 0), matrix(2));
}

TEST(VliwMatrix, IsNotBegunByAnythingButAMarker) {
    VliwRenderer renderer = idle_renderer();
    renderer.aux = {0x0000, 0x7fff, 0x8002, 0xffff, 0x0001, 0x1234};
    renderer.aux.resize(40, 0x4321);
    renderer.run();
    renderer.run();
    EXPECT_EQ(matrix_of(renderer, 0), Words(kMatrixWords));
}

TEST(VliwMatrix, SetsTheRowRightThatIsShown) {
    VliwRenderer renderer = idle_renderer();
    renderer.aux = Words(100);
    renderer.aux.push_back(0x8000);
    while (renderer.scanlines() < 102) {
        ASSERT_EQ(renderer.run_scanline(), Ended::line);
    }
    EXPECT_EQ(renderer.read(0, "scanline"), 1) << "after the marker's, which is scanline 0";
}

TEST(VliwDispatch, WaitsForTheEndOfTheVisibleRowsWithANewPicture) {
    VliwRenderer renderer = idle_renderer();
    renderer.run();
    EXPECT_EQ(renderer.scanlines(), 1 + 512);
}

TEST(VliwDispatch, WaitsForThePictureBeforeToBeShown) {
    VliwRenderer renderer = idle_renderer();
    renderer.run();
    renderer.run();
    EXPECT_EQ(renderer.scanlines(), 1 + 512 + 525);
}

constexpr std::array<std::string_view, 1> kDuplicate = {"duplicate.s"};

// Whether each of these lanes of a ring of `lanes` sends a polygon whose leftmost column is
// `first`.
std::vector<bool> senders(const std::vector<int>& numbers, int lanes, int first, int copies) {
    constexpr std::string_view kStub =
        "test_sends:\n wake\n ld r1, 0x1000\n tge r0, r0\n sends r1, r2, r3, r4\n"
        " tget r5\n st r5, 0x1001\n halt\n";
    VliwRenderer renderer(kDuplicate, kStub, "test_sends", {{"duplication", copies}},
                          static_cast<std::int64_t>(numbers.size()));
    const std::array word = {static_cast<std::uint16_t>(first)};
    std::int64_t lane = 0;
    for (const int number : numbers) {
        renderer.write(lane, "lane", number);
        renderer.write(lane, "lanes", lanes);
        renderer.write(lane++, 0x1000, word);
    }
    renderer.run();
    std::vector<bool> result;
    for (lane = 0; lane < renderer.lanes(); ++lane) {
        result.push_back(renderer.read(lane, 0x1001) != 0);
    }
    return result;
}

std::vector<int> every(int step, int lanes) {
    std::vector<int> numbers;
    for (int number = 0; number < lanes; number += step) {
        numbers.push_back(number);
    }
    return numbers;
}

void expect_last_copies_before(int first, int copies, int lanes, std::vector<int> numbers) {
    for (const int back : {1, lanes / copies, lanes / copies + 1}) {
        numbers.push_back((std::max(first, 0) - back + lanes) % lanes);
    }
    std::vector<bool> expected;
    for (const int number : numbers) {
        expected.push_back((std::max(first, 0) - number - 1 + lanes) % lanes < lanes / copies);
    }
    EXPECT_EQ(senders(numbers, lanes, first, copies), expected)
        << copies << " copies on " << lanes << " lanes, column " << first;
}

TEST(VliwDuplication, LetsTheLastCopyBeforeTheFirstDestinationSend) {
    for (const int copies : {2, 4, 8}) {
        for (int first = -3; first < 16; ++first) {
            expect_last_copies_before(first, copies, 16, every(1, 16));
        }
    }
    for (const int copies : {2, 3, 6, 12, 24, 48}) {
        expect_last_copies_before(20, copies, 48, every(1, 48));
    }
}

TEST(VliwDuplication, LetsOneCopySendOnRingsLongerThanASignedWord) {
    expect_last_copies_before(700, 2, 40000, every(997, 40000));
    expect_last_copies_before(3, 3, 65535, every(997, 65535));
    expect_last_copies_before(767, 4, 65536, every(997, 65536));
}

TEST(VliwDuplication, LetsEveryLaneSendWithoutCopies) {
    EXPECT_EQ(senders(every(1, 16), 16, 5, 1), std::vector<bool>(16, true));
}

}  // namespace
}  // namespace rasterloom::test
