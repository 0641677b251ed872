// SPDX-License-Identifier: MIT
#include "machine/observe/output_folder.hpp"

#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

namespace rasterloom::observe {

namespace fs = std::filesystem;

namespace {

// Before the number of the process that writes.
std::string partial_name(const fs::path& path) {
    return fmt::format(".{}.partial-", path.filename().string());
}

fs::path beside(const fs::path& path) {
    return path.parent_path() / fmt::format("{}{}", partial_name(path), ::getpid());
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& final_folder) {
    final_ = fs::absolute(final_folder).lexically_normal();
    if (!final_.has_filename()) {
        final_ = final_.parent_path();
    }
    partial_ = beside(final_);
    std::error_code error;
    if (fs::exists(final_, error) && !fs::is_directory(final_, error)) {
        throw OutputError(
            fmt::format("{}: is a file; expected a folder to write to", final_.string()));
    }
    for (fs::path parent = final_.parent_path(); !parent.empty() && !fs::exists(parent, error);
         parent = parent.parent_path()) {
        made_parents_.push_back(parent);
    }
    fs::remove_all(partial_, error);
    fs::create_directories(partial_, error);
    if (error) {
        throw OutputError(
            fmt::format("{}: cannot make a folder here: {}", final_.string(), error.message()));
    }
}

OutputFolder::~OutputFolder() {
    remove_uncommitted();
}

void OutputFolder::remove_uncommitted() {
    std::error_code ignored;
    fs::remove_all(partial_, ignored);
    for (const fs::path& parent : made_parents_) {
        fs::remove(parent, ignored);  // refused while something is in it
    }
}

void OutputFolder::abandon() {
    ending_.lock();
    constexpr int kTries = 100;  // the other thread may add a file while the folder is removed
    std::error_code ignored;
    for (int i = 0; i < kTries && fs::exists(partial_, ignored); ++i) {
        remove_uncommitted();
    }
    remove_uncommitted();
}

void OutputFolder::commit() {
    const std::lock_guard ending(ending_);
    if (!fs::exists(final_)) {
        fs::rename(partial_, final_);
        return;
    }
    for (const auto& entry : fs::directory_iterator(partial_)) {
        fs::rename(entry.path(), final_ / entry.path().filename());
    }
}

void write_file_whole(const fs::path& path, std::string_view content) {
    const fs::path partial = beside(fs::absolute(path));
    std::ofstream file(partial, std::ios::binary);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    std::error_code error;
    if (file) {
        fs::rename(partial, path, error);
    }
    if (!file || error) {
        std::error_code ignored;
        fs::remove(partial, ignored);
        throw OutputError(fmt::format("{}: cannot be written", path.string()));
    }
}

void remove_unfinished(const fs::path& path) {
    std::error_code ignored;
    std::vector<fs::path> unfinished;
    for (const auto& entry : fs::directory_iterator(fs::absolute(path).parent_path(), ignored)) {
        if (entry.path().filename().string().starts_with(partial_name(path))) {
            unfinished.push_back(entry.path());
        }
    }
    for (const fs::path& file : unfinished) {
        fs::remove(file, ignored);
    }
}

}  // namespace rasterloom::observe
