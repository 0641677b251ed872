// SPDX-License-Identifier: MIT
// Arrows of dependency point one way: a box may include itself and the boxes below it.
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace rasterloom {
namespace {

namespace fs = std::filesystem;

// From the top of the house to its foundation.
constexpr std::array<std::string_view, 10> kBoxes{
    "machine/cli",    "machine/emulation", "machine/config", "machine/observe", "machine/host",
    "machine/fabric", "machine/node",      "machine/kernel", "topologies",      "isa"};

std::optional<std::size_t> box_of(std::string_view path) {
    for (std::size_t i = 0; i < kBoxes.size(); ++i) {
        if (path.starts_with(kBoxes[i]) && path.substr(kBoxes[i].size()).starts_with('/')) {
            return i;
        }
    }
    return std::nullopt;
}

bool is_source(const fs::path& path) {
    return path.extension() == ".hpp" || path.extension() == ".cpp";
}

// The paths in a file's #include "..." lines.
std::vector<std::string> quoted_includes(std::istream& file) {
    constexpr std::string_view kStart = "#include \"";
    std::vector<std::string> includes;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with(kStart)) {
            const std::size_t end = line.find('"', kStart.size());
            includes.push_back(line.substr(kStart.size(), end - kStart.size()));
        }
    }
    return includes;
}

std::vector<fs::path> sources_of(std::string_view box) {
    std::vector<fs::path> files;
    const fs::path folder = fs::path(RASTERLOOM_SOURCE_DIR) / box;
    if (!fs::exists(folder)) {
        return files;
    }
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (is_source(entry.path())) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

TEST(Architecture, IncludesPointDownTheHouseOnly) {
    std::size_t checked = 0;
    for (std::size_t box = 0; box < kBoxes.size(); ++box) {
        for (const fs::path& file : sources_of(kBoxes[box])) {
            std::ifstream stream(file);
            for (const std::string& include : quoted_includes(stream)) {
                ++checked;
                const auto target = box_of(include);
                EXPECT_TRUE(target.has_value())
                    << file << " includes \"" << include << "\", which is in no box";
                EXPECT_GE(target.value_or(box), box)
                    << file << " includes \"" << include << "\" from a box above it";
            }
        }
    }
    EXPECT_GT(checked, 10U);
}

TEST(Architecture, NobodyIncludesAnImplementation) {
    for (const std::string_view box : kBoxes) {
        for (const fs::path& file : sources_of(box)) {
            std::ifstream stream(file);
            for (const std::string& include : quoted_includes(stream)) {
                EXPECT_FALSE(include.ends_with(".cpp")) << file << " includes " << include;
            }
        }
    }
}

TEST(Architecture, EveryFileNamesItsLicence) {
    for (const std::string_view box : kBoxes) {
        for (const fs::path& file : sources_of(box)) {
            std::ifstream stream(file);
            std::string line;
            std::getline(stream, line);
            EXPECT_EQ(line, "// SPDX-License-Identifier: MIT") << file;
        }
    }
}

}  // namespace
}  // namespace rasterloom
