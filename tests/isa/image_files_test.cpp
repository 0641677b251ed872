// SPDX-License-Identifier: MIT
#include "isa/image_files.hpp"

#include "tests/isa/assembling.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <rapidcheck.h>

namespace rasterloom::isa {
namespace {

using testing::assemble;
using testing::bytes_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Bytes = std::vector<std::uint8_t>;

// A file of words, low byte first, and bytes after them.
Bytes file_of(std::initializer_list<unsigned> words, const Bytes& more = {}) {
    Bytes bytes;
    for (const unsigned word : words) {
        bytes.push_back(static_cast<std::uint8_t>(word & 0xff));
        bytes.push_back(static_cast<std::uint8_t>(word >> 8));
    }
    bytes.insert(bytes.end(), more.begin(), more.end());
    return bytes;
}

template <typename Function>
std::string refusal(Function function) {
    try {
        function();
    } catch (const ImageError& error) {
        return error.what();
    }
    return "no error";
}

std::string aout_refusal(const Bytes& bytes) {
    return refusal([&] { aout_image("x.out", bytes); });
}

TEST(AoutImage, PutsDataBehindTextAndClearsBss) {
    const Image image =
        aout_image("x.out", file_of({0407, 4, 2, 2, 0, 2, 0, 1}, {1, 2, 3, 4, 5, 6}));
    EXPECT_THAT(bytes_of(image), ElementsAre(1, 2, 3, 4, 5, 6, 0, 0));
    EXPECT_EQ(image.entry, 2U);
}

TEST(AoutImage, BeginsDataOfSharedTextAtTheNextPage) {
    const Bytes loaded =
        bytes_of(aout_image("x.out", file_of({0410, 2, 2, 0, 0, 0, 0, 1}, {1, 2, 3, 4})));
    ASSERT_EQ(loaded.size(), 020002U);
    EXPECT_EQ(loaded[020000], 3);
}

TEST(AoutImage, ReadsTheSymbolsOfOldFiles) {
    const Image image =
        aout_image("x.out", file_of({0407, 2, 0, 0, 12, 0, 0, 1},
                                    {7, 0, 's', 't', 'a', 'r', 't', 0, 0, 0, 042, 0, 6, 0}));
    EXPECT_EQ(image.symbol("start"), 6U);
}

TEST(AoutImage, RefusesWhatItCannotLoadAndSaysWhy) {
    EXPECT_THAT(aout_refusal({1, 2, 3}), HasSubstr("x.out: not an a.out file: 3 bytes"));
    EXPECT_THAT(aout_refusal(file_of({0177, 0, 0, 0, 0, 0, 0, 0})),
                HasSubstr("it begins with 0177, 0407 or 0410"));
    EXPECT_THAT(aout_refusal(file_of({0411, 2, 0, 0, 0, 0, 0, 1}, {1, 2})),
                HasSubstr("separate instruction and data"));
    EXPECT_THAT(aout_refusal(file_of({0407, 100, 0, 0, 0, 0, 0, 1}, {1, 2})),
                HasSubstr("truncated: 18 bytes"));
    EXPECT_THAT(aout_refusal(file_of({0407, 2, 0, 0, 0, 8, 0, 1}, {1, 2})),
                HasSubstr("the entry 010 is outside"));
    EXPECT_THAT(aout_refusal(file_of({0407, 2, 0, 65535, 0, 0, 0, 1}, {1, 2})),
                HasSubstr("above the 65536 bytes"));
    EXPECT_THAT(aout_refusal(file_of({0407, 0, 0, 4, 0, 0, 0, 1})), HasSubstr("no program"));
    EXPECT_THAT(aout_refusal(file_of({0407, 2, 0, 0, 12, 0, 0, 1},
                                     {7, 0, 'f', 0, 0, 0, 0, 0, 0, 0, 040, 0, 0, 0})),
                HasSubstr("symbol 'f' is undefined"));
    EXPECT_THAT(aout_refusal(file_of({0407, 2, 0, 0, 8, 0, 0, 1},
                                     {7, 0, 0, 0, 99, 0, 2, 0, 0, 0, 4, 0, 0, 0})),
                HasSubstr("name lies outside"));
}

TEST(AoutImage, NeverFailsOtherwiseOnAnyBytes) {
    const bool held = rc::check([](Bytes bytes, bool with_magic) {
        if (with_magic && bytes.size() >= 2) {
            bytes[0] = 07;
            bytes[1] = 1;
        }
        aout_refusal(bytes);
    });
    EXPECT_TRUE(held);
}

TEST(AoutImage, NeverFailsOtherwiseOnADamagedFile) {
    std::ifstream file(
        std::filesystem::path(RASTERLOOM_SOURCE_DIR) / "tests/isa/golden/program.aout",
        std::ios::binary);
    const Bytes original{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    ASSERT_FALSE(original.empty());
    const bool held = rc::check([&](std::uint16_t at, std::uint8_t value, std::uint16_t length) {
        Bytes bytes = original;
        bytes[at % bytes.size()] = value;
        bytes.resize(length % (bytes.size() + 1));
        aout_refusal(bytes);
    });
    EXPECT_TRUE(held);
}

TEST(RawImage, StandsAtItsLoadAddress) {
    const Image image = raw_image("x.bin", Bytes{1, 2, 3}, 01000, 01002);
    ASSERT_EQ(image.segments.size(), 1U);
    EXPECT_EQ(image.segments[0].address, 01000U);
    EXPECT_EQ(image.entry, 01002U);
}

TEST(RawImage, RefusesWhatDoesNotFit) {
    EXPECT_THAT(refusal([] { raw_image("x.bin", {}, 0, 0); }),
                HasSubstr("x.bin: the file is empty"));
    EXPECT_THAT(refusal([] { raw_image("x.bin", Bytes(3), 7, 7, 8); }),
                HasSubstr("3 bytes from 07 do not fit in 8"));
    EXPECT_THAT(refusal([] { raw_image("x.bin", Bytes(2), 010, 012); }),
                HasSubstr("the entry 012 is outside"));
    EXPECT_THAT(refusal([] { read_raw_image("no/such.bin", 0, 0); }),
                HasSubstr("no/such.bin: cannot read"));
}

TEST(RawImage, ComesBackAsItWasWritten) {
    const Image image = assemble(". = 1000\nmov #1, r1\n. = . + 4\nhalt\n").image;
    const std::filesystem::path path =
        std::filesystem::path(RASTERLOOM_BINARY_DIR) / "image_files_test.bin";
    write_raw_image(image, path);
    EXPECT_EQ(bytes_of(read_raw_image(path, 01000, 01000)), raw_bytes(image));
    EXPECT_EQ(raw_bytes(image).size(), 10U);
    std::filesystem::remove(path);
    EXPECT_THAT(refusal([&] { write_raw_image(image, "no/such/folder.bin"); }),
                HasSubstr("cannot write this file"));
}

}  // namespace
}  // namespace rasterloom::isa
