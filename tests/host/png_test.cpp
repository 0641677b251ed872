// SPDX-License-Identifier: MIT
#include "machine/host/png.hpp"

#include "tests/temporary_folder.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom::host {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class Png : public ::testing::Test {
  protected:
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(folder_), {}));
    }

    TemporaryFolder temporary_;
    std::filesystem::path folder_ = temporary_.path();
};

RC_GTEST_PROP(PngBytes, ComeBackAsTheyWent, ()) {
    Picture picture(*rc::gen::inRange(1, 20), *rc::gen::inRange(1, 20), *rc::gen::element(1, 3));
    for (auto& pixel : picture.pixels)
        pixel = static_cast<std::uint8_t>(*rc::gen::inRange(0, 256));
    RC_ASSERT(decode_png(encode_png(picture)) == picture);
}

TEST_F(Png, LeavesOneFileUnderItsFinalName) {
    const Picture picture(5, 3, 1, 42);
    write_png(folder_ / "a.png", picture);
    EXPECT_EQ(read_png(folder_ / "a.png"), picture);
    EXPECT_EQ(files(), 1U);
}

TEST_F(Png, ReplacesAnOlderFile) {
    write_png(folder_ / "a.png", Picture(5, 3, 1, 42));
    write_png(folder_ / "a.png", Picture(2, 2, 3, 9));
    EXPECT_EQ(read_png(folder_ / "a.png"), Picture(2, 2, 3, 9));
}

TEST_F(Png, SaysWhichFileCannotBeWrittenAndLeavesNothing) {
    const auto path = folder_ / "nowhere" / "a.png";
    EXPECT_THAT([&] { write_png(path, Picture(2, 2)); },
                ThrowsMessage<std::runtime_error>(
                    AllOf(HasSubstr(path.string()), HasSubstr("No such file"))));
    std::filesystem::create_directory(folder_ / "a.png");
    std::ofstream(folder_ / "a.png" / "inside") << "x";
    EXPECT_THROW(write_png(folder_ / "a.png", Picture(2, 2)), std::runtime_error);
    EXPECT_EQ(files(), 1U);
}

TEST_F(Png, SaysWhichFileCannotBeRead) {
    EXPECT_THAT([&] { read_png(folder_ / "b.png"); },
                ThrowsMessage<std::runtime_error>(HasSubstr("b.png")));
    std::ofstream(folder_ / "c.png") << "not a picture";
    EXPECT_THAT(
        [&] { read_png(folder_ / "c.png"); },
        ThrowsMessage<std::runtime_error>(AllOf(HasSubstr("c.png"), HasSubstr("not a PNG file"))));
}

}  // namespace
}  // namespace rasterloom::host
