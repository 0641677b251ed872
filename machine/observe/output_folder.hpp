// SPDX-License-Identifier: MIT
// Where a run's files go. They are written into a hidden folder beside the final one and moved when
// all of them are complete: a run that fails leaves nothing under the final name.
#pragma once

#include <filesystem>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::observe {

// A file or folder cannot be written; the message names it.
class OutputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

class OutputFolder {
  public:
    // Makes the hidden folder. Throws OutputError when that is not possible.
    explicit OutputFolder(const std::filesystem::path& final_folder);
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;
    // Removes everything that was not committed, folders on the way included.
    ~OutputFolder();

    // Where to write the file that will be called `name`.
    std::filesystem::path file(const std::string& name) const { return partial_ / name; }
    const std::filesystem::path& final_folder() const { return final_; }

    // Moves every file to the final folder, which is made when it does not exist; files there with
    // other names stay.
    void commit();

    // Removes everything that was not committed, folders on the way included, though another thread
    // may be writing it. To be called from any thread when the process is about to end; the folder
    // is never committed then.
    void abandon();

  private:
    void remove_uncommitted();

    std::mutex ending_;  // held by who commits or abandons; for ever by who abandons
    std::filesystem::path final_;
    std::filesystem::path partial_;
    std::vector<std::filesystem::path> made_parents_;  // innermost first
};

// Writes a whole file under a temporary name and renames it. Throws OutputError.
void write_file_whole(const std::filesystem::path& path, std::string_view content);

// Removes the temporary files of writers of `path` that were killed. For who knows that nobody is
// writing it.
void remove_unfinished(const std::filesystem::path& path);

}  // namespace rasterloom::observe
