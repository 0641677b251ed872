// SPDX-License-Identifier: MIT
#include "machine/observe/output_folder.hpp"

#include "tests/temporary_folder.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include <gtest/gtest.h>

namespace rasterloom::observe {
namespace {

namespace fs = std::filesystem;

class OutputFolderTest : public testing::Test {
  protected:
    static void write(const fs::path& path, const std::string& text) {
        std::ofstream(path) << text;
    }
    static std::string read(const fs::path& path) {
        std::ifstream file(path);
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }
    std::size_t entries() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(root_), fs::directory_iterator()));
    }

    TemporaryFolder temporary_;
    fs::path root_ = temporary_.path();
};

TEST_F(OutputFolderTest, LeavesNothingBehindUnlessCommitted) {
    {
        const OutputFolder folder(root_ / "new" / "deep" / "out");
        write(folder.file("a.csv"), "half");
        EXPECT_FALSE(fs::exists(root_ / "new" / "deep" / "out"));
    }
    EXPECT_EQ(entries(), 0U);
}

TEST_F(OutputFolderTest, BecomesTheFinalFolder) {
    OutputFolder folder(root_ / "deep" / "out" / "");
    write(folder.file("a.csv"), "whole");
    folder.commit();
    EXPECT_EQ(read(root_ / "deep" / "out" / "a.csv"), "whole");
}

TEST_F(OutputFolderTest, ReplacesFilesOfTheSameNameOnly) {
    fs::create_directories(root_ / "out");
    write(root_ / "out" / "a.csv", "old");
    write(root_ / "out" / "notes.txt", "mine");
    {
        OutputFolder folder(root_ / "out");
        write(folder.file("a.csv"), "new");
        EXPECT_EQ(read(root_ / "out" / "a.csv"), "old");
        folder.commit();
    }
    EXPECT_EQ(read(root_ / "out" / "a.csv"), "new");
    EXPECT_EQ(read(root_ / "out" / "notes.txt"), "mine");
    EXPECT_EQ(entries(), 1U);
}

TEST_F(OutputFolderTest, RefusesAFileInItsPlace) {
    write(root_ / "out", "a file");
    EXPECT_THROW(OutputFolder(root_ / "out"), std::runtime_error);
    EXPECT_THROW(OutputFolder(root_ / "out" / "below"), std::runtime_error);
}

TEST_F(OutputFolderTest, WritesSingleFilesWholeOrNotAtAll) {
    write_file_whole(root_ / "x.bin", "bytes");
    EXPECT_EQ(read(root_ / "x.bin"), "bytes");
    EXPECT_THROW(write_file_whole(root_ / "none" / "x.bin", "bytes"), std::runtime_error);
    EXPECT_EQ(entries(), 1U);
}

TEST_F(OutputFolderTest, RemovesWhatAKilledWriterOfTheFileHasLeft) {
    write(root_ / ".x.bin.partial-123", "half");
    write(root_ / ".y.bin.partial-123", "somebody else's");
    write(root_ / "x.bin", "whole");
    remove_unfinished(root_ / "x.bin");
    EXPECT_FALSE(fs::exists(root_ / ".x.bin.partial-123"));
    EXPECT_EQ(read(root_ / "x.bin"), "whole");
    EXPECT_EQ(entries(), 2U);
    EXPECT_NO_THROW(remove_unfinished(root_ / "none" / "x.bin"));
}

}  // namespace
}  // namespace rasterloom::observe
