// SPDX-License-Identifier: MIT
// Broken configurations end in a ConfigError with a position, whatever is broken about them.
#include "tests/config/machine_text.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rasterloom::config {
namespace {

std::string read_text(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class Mutator {
  public:
    explicit Mutator(unsigned seed) : random_(seed) {}

    std::string mutate(std::string text) {
        const auto changes = 1 + pick(4);
        for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
            change(text);
        }
        return text;
    }

  private:
    std::size_t pick(std::size_t below) { return random_() % below; }

    void change(std::string& text) {
        static constexpr std::string_view kSpice =
            "{}[]:,#&*!|>'\"%@`-? \n\t\0\xff\x80"
            "09azux.";
        const std::size_t at = pick(text.size());
        switch (pick(6)) {
            case 0:
                text.erase(at, 1 + pick(5));
                break;
            case 1:
                text.insert(at, 1, kSpice[pick(kSpice.size())]);
                break;
            case 2:
                text[at] = static_cast<char>(pick(256));
                break;
            case 3:  // a piece doubled
                text.insert(pick(text.size()), text.substr(at, 1 + pick(30)));
                break;
            case 4:  // cut short
                text.resize(at);
                break;
            default:  // a piece elsewhere
                const std::string piece = text.substr(at, 1 + pick(20));
                text.erase(at, piece.size());
                text.insert(pick(text.size() + 1), piece);
        }
    }

    std::mt19937 random_;
};

TEST(FuzzedConfiguration, IsLoadedOrRefusedWithAPosition) {
    const int rounds = std::getenv("RASTERLOOM_LONG_TESTS") != nullptr ? 200'000 : 3'000;
    const std::vector<std::string> seeds{
        read_text(RASTERLOOM_SOURCE_DIR "/configs/geodesic482.yaml"),
        read_text(RASTERLOOM_SOURCE_DIR "/configs/bare-pdp11.yaml"),
        read_text(RASTERLOOM_SOURCE_DIR "/configs/edge-list.yaml"),
        read_text(RASTERLOOM_SOURCE_DIR "/configs/hybrid64.yaml"),
        kSmallMachine +
            "scene: { object: cube, rotate: { axis: [0, 1, 0], degrees: 6 }, light: [1, 2, 3] }\n"};
    int refused = 0;
    for (int round = 0; round < rounds; ++round) {
        Mutator mutator(static_cast<unsigned>(round));
        const std::string text =
            mutator.mutate(seeds[static_cast<std::size_t>(round) % seeds.size()]);
        try {
            load_text(text);
        } catch (const ConfigError& error) {
            ++refused;
            ASSERT_FALSE(error.problem().where.source.empty()) << text;
            ASSERT_FALSE(error.problem().what.empty()) << text;
            ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << text;
        }
    }
    EXPECT_GT(refused, rounds / 10);
    EXPECT_LT(refused, rounds);
}

}  // namespace
}  // namespace rasterloom::config
