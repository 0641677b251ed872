// SPDX-License-Identifier: MIT
#include "machine/config/locator.hpp"

#include <cstdlib>

#include <fmt/format.h>

namespace rasterloom::config {

namespace fs = std::filesystem;

namespace {

fs::path folder_of(const std::string& named_in) {
    std::error_code ignored;
    return fs::is_regular_file(named_in, ignored) ? fs::absolute(named_in).parent_path()
                                                  : fs::current_path();
}

bool is_file(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

}  // namespace

std::optional<fs::path> Locator::find(const std::string& name, const std::string& named_in,
                                      const fs::path& fallback) const {
    if (name.empty() || name.find('\0') != std::string::npos) {
        return std::nullopt;
    }
    const fs::path beside = folder_of(named_in) / name;
    if (is_file(beside)) {
        return beside.lexically_normal();
    }
    if (!fallback.empty() && is_file(fallback / name)) {
        return fs::absolute(fallback / name).lexically_normal();
    }
    return std::nullopt;
}

std::string Locator::places(const std::string& named_in, const fs::path& fallback) {
    const std::string beside = folder_of(named_in).string();
    return fallback.empty() ? beside : fmt::format("{} and {}", beside, fallback.string());
}

std::string Locator::portable(const fs::path& path, const fs::path& root) {
    const fs::path relative = path.lexically_relative(fs::absolute(root).lexically_normal());
    const bool inside = !relative.empty() && *relative.begin() != "..";
    return inside ? relative.string() : path.string();
}

Locator make_locator(const std::string& data_option) {
    if (!data_option.empty()) {
        return Locator(fs::absolute(data_option).lexically_normal());
    }
    if (const char* data = std::getenv("RASTERLOOM_DATA"); data != nullptr && *data != '\0') {
        return Locator(fs::absolute(data).lexically_normal());
    }
    return Locator(RASTERLOOM_DATA_DIR);
}

}  // namespace rasterloom::config
