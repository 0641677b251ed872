// SPDX-License-Identifier: MIT
// The frame buffer by itself, against plain arrays, and as a program on a processor sees it.
#include "machine/node/frame_buffer.hpp"

#include "machine/kernel/simulation.hpp"
#include "machine/node/processor.hpp"
#include "tests/node/script_program.hpp"

#include <array>
#include <map>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom {
namespace {

using testing::HasSubstr;
using Verb = ScriptCore::Verb;

constexpr std::size_t kMemory = 0160000;

ScriptCore idle_core(std::size_t memory = kMemory) {
    return ScriptCore({}, 1, memory);
}

void put_word(ScriptCore& core, std::uint32_t address, std::uint16_t word) {
    core.write_memory(address, std::array{static_cast<std::uint8_t>(word & 0377U),
                                          static_cast<std::uint8_t>(word >> 8U)});
}

TEST(FrameBuffer, IsTheSameAsPlainArraysUnderRandomOperations) {
    const bool same = rc::check([] {
        const int rows = *rc::gen::inRange(1, 6);
        const int columns = *rc::gen::inRange(1, 9);
        ScriptCore core = idle_core();
        FrameBuffer buffer(core, {rows, columns});
        std::map<std::pair<int, int>, std::pair<int, int>> pixels;
        const auto clear = [&](int image) {
            for (int row = 0; row < rows; ++row) {
                for (int column = 0; column < columns; ++column) {
                    pixels[{row, column}] = {077777, image};
                }
            }
        };
        clear(0);
        int selected = 0;
        buffer.select(selected);
        for (int i = *rc::gen::inRange(0, 40); i > 0; --i) {
            const int what = *rc::gen::inRange(0, 8);
            const auto word = *rc::gen::arbitrary<std::int16_t>();
            if (what == 0) {
                buffer.clear(static_cast<std::uint16_t>(word));
                clear(word);
            } else if (what < 4) {
                selected = *rc::gen::inRange(0, rows);
                buffer.select(selected);
            } else {
                const int column = *rc::gen::inRange(0, columns);
                const bool depth = what < 6;
                put_word(
                    core,
                    (depth ? kDepthWindow : kImageWindow) + 2 * static_cast<std::uint32_t>(column),
                    static_cast<std::uint16_t>(word));
                auto& pixel = pixels[{selected, column}];
                (depth ? pixel.first : pixel.second) = word;
            }
        }
        for (const auto& [place, pixel] : pixels) {
            RC_ASSERT(buffer.depth(place.first, place.second) == pixel.first);
            RC_ASSERT(buffer.image(place.first, place.second) == pixel.second);
        }
    });
    EXPECT_TRUE(same);
}

TEST(FrameBuffer, TouchesNothingOfTheMemoryButItsColumns) {
    ScriptCore core = idle_core();
    const std::vector<std::uint8_t> ones(kMemory, 1);
    core.write_memory(0, ones);
    FrameBuffer buffer(core, {2, 3});
    buffer.select(1);
    buffer.clear(0x1234);
    for (std::uint32_t address = 0; address < kMemory; ++address) {
        const bool inside = (address >= kDepthWindow && address < kDepthWindow + 6) ||
                            (address >= kImageWindow && address < kImageWindow + 6);
        ASSERT_EQ(core.memory()[address] != 1, inside) << std::oct << address;
    }
}

TEST(FrameBuffer, OverTheBusLeavesTheImageWindowsMemoryAlone) {
    ScriptCore core = idle_core(kDepthWindow + 8);  // the image window need not be there
    FrameBuffer buffer(core, {2, 4, true});
    buffer.select(1);
    buffer.write_image(3, 0x8001);
    buffer.select(0);
    EXPECT_EQ(buffer.image(1, 3), static_cast<std::int16_t>(0x8001));
    EXPECT_EQ(buffer.image(0, 3), 0);
}

TEST(FrameBuffer, RefusesSizesThatDoNotFit) {
    ScriptCore core = idle_core();
    EXPECT_THROW(FrameBuffer(core, {0, 1}), std::invalid_argument);
    EXPECT_THROW(FrameBuffer(core, {65537, 1}), std::invalid_argument);
    EXPECT_THROW(FrameBuffer(core, {1, 0}), std::invalid_argument);
    EXPECT_THROW(FrameBuffer(core, {1, 1025}), std::invalid_argument);
    EXPECT_NO_THROW(FrameBuffer(core, {1, 1024}));
    ScriptCore small = idle_core(kImageWindow + 7);
    EXPECT_NO_THROW(FrameBuffer(small, {1, 3}));
    EXPECT_THROW(FrameBuffer(small, {1, 4}), std::invalid_argument);
}

// Acts every microsecond, so that whoever needs exact time has to give up control.
class Ticker final : public Component {
  public:
    Ticker() : Component("ticker") {}
    void start() override { wake_at(Time::zero(), 0); }
    void handle(const Event&) override {
        if (now() < Time::zero() + Duration::milliseconds(1)) {
            wake_at(now() + Duration::microseconds(1), 0);
        }
    }
};

struct Bare {
    explicit Bare(const Script& script, std::optional<FrameBuffer::Settings> frame_buffer,
                  std::size_t memory = kMemory) {
        Processor::Settings settings;
        settings.clock = Clock::with_period(Duration::nanoseconds(300));
        settings.supervised = false;
        settings.frame_buffer = frame_buffer;
        processor = &simulation.add<Processor>(
            "node/P0", std::make_unique<ScriptCore>(script.program(), 1, memory), settings);
    }
    std::string failure() {
        simulation.seal();
        const RunResult result = simulation.run();
        return result.failure == nullptr ? "no failure" : result.failure->message();
    }
    Simulation simulation;
    Processor* processor;
};

TEST(ProcessorFrameBuffer, SelectsAndClearsRowsForOneCycleEach) {
    Script s;
    s.write(kFbClear, 0x0700).write(kFbRow, 2).set(0, 5).op(Verb::poke, 0, 0, kImageWindow + 2);
    s.op(Verb::poke, 0, 0, kDepthWindow + 3).write(kFbRow, 0).halt();
    Bare bare(s, FrameBuffer::Settings{3, 4});
    EXPECT_EQ(bare.failure(), "no failure");
    EXPECT_EQ(bare.processor->statistics().cycles, 10);
    const FrameBuffer& buffer = *bare.processor->frame_buffer();
    EXPECT_EQ(buffer.image(2, 1), 0x0705);
    EXPECT_EQ(buffer.depth(2, 1), 0x05ff);
    EXPECT_EQ(buffer.image(0, 1), 0x0700);
    EXPECT_EQ(buffer.depth(1, 1), 077777);
}

TEST(ProcessorFrameBuffer, LetsNobodyCatchUpForARow) {
    Script s;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        s.write(kFbRow, i % 3);
    }
    Bare bare(s.halt(), FrameBuffer::Settings{3, 4});
    bare.simulation.add<Ticker>();
    EXPECT_EQ(bare.failure(), "no failure");
    EXPECT_LT(bare.simulation.events_handled(), 1010U);  // the ticker's and a handful
}

TEST(ProcessorFrameBuffer, EndsTheRunWhenTheProgramMisusesIt) {
    EXPECT_THAT(Bare(Script().write(kFbRow, 3), FrameBuffer::Settings{3, 4}).failure(),
                HasSubstr("FBROW 000003: the frame buffer has rows 0 to 000002"));
    EXPECT_THAT(Bare(Script().write(kFbRow, 3), std::nullopt).failure(),
                HasSubstr("FBROW 000003 on a node without a frame buffer"));
    EXPECT_THAT(Bare(Script().write(kFbClear, 0), std::nullopt).failure(),
                HasSubstr("FBCLEAR 000000 on a node without a frame buffer"));
    for (const std::uint32_t address : {kFbRow, kFbClear}) {
        EXPECT_THAT(Bare(Script().load(0, address), FrameBuffer::Settings{3, 4}).failure(),
                    HasSubstr("bus error"));
    }
    EXPECT_THAT(Bare(Script().write(kFbClear + 2, 0), FrameBuffer::Settings{3, 4}).failure(),
                HasSubstr("bus error 166004"));
    EXPECT_THAT(Bare(Script().write(kBusImageWindow, 0), FrameBuffer::Settings{3, 4}).failure(),
                HasSubstr("bus error 170000"));
}

TEST(ProcessorFrameBuffer, NeedsAMemoryThatHoldsTheWindows) {
    EXPECT_THAT(
        [] {
            Bare(Script().halt(), FrameBuffer::Settings{3, 4}, 2048);
        },
        testing::ThrowsMessage<std::invalid_argument>(
            HasSubstr("node/P0: the frame buffer's windows of 4 columns need 55304 bytes")));
}

}  // namespace
}  // namespace rasterloom
