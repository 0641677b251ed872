// SPDX-License-Identifier: MIT
// Finds the files that a configuration names: beside the file that names them, or among the
// project's own.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rasterloom::config {

class Locator {
  public:
    // `data`: the folder that holds programs/ and configs/.
    explicit Locator(std::filesystem::path data) : data_(std::move(data)) {}

    const std::filesystem::path& data() const { return data_; }
    std::filesystem::path programs() const { return data_ / "programs"; }
    std::filesystem::path configs() const { return data_ / "configs"; }

    // `name` beside the file `named_in` (the working directory for command-line overrides), then in
    // `fallback` if that is given. None when it is in neither. The result is absolute.
    std::optional<std::filesystem::path> find(const std::string& name, const std::string& named_in,
                                              const std::filesystem::path& fallback) const;

    // The places that find() looks at, for messages.
    static std::string places(const std::string& named_in, const std::filesystem::path& fallback);

    // An absolute path as short as it stays valid anywhere: relative to `root` when it lies inside.
    static std::string portable(const std::filesystem::path& path,
                                const std::filesystem::path& root);

  private:
    std::filesystem::path data_;
};

// The folder given with --data, else by the environment variable RASTERLOOM_DATA, else the source
// tree that the command was built from.
Locator make_locator(const std::string& data_option);

}  // namespace rasterloom::config
