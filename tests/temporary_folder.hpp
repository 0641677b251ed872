// SPDX-License-Identifier: MIT
// A folder of a test's own, gone with the test: tests run side by side, and so may whole suites.
#pragma once

#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>

#include <stdlib.h>

namespace rasterloom {

class TemporaryFolder {
  public:
    // Throws std::system_error when there is no room for it.
    TemporaryFolder() {
        std::string pattern =
            (std::filesystem::temp_directory_path() / "rasterloom-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr)
            throw std::system_error(errno, std::generic_category(), pattern);
        path_ = pattern;
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace rasterloom
