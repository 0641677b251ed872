// SPDX-License-Identifier: MIT
// A folder that one process at a time writes to.
#pragma once

#include <filesystem>

namespace rasterloom::observe {

class FolderLock {
  public:
    // Makes the folder. Throws OutputError when that is not possible or another process holds it.
    // The lock ends with the process, however that ends; where a file system knows no locks, nobody
    // is kept out.
    explicit FolderLock(const std::filesystem::path& folder);
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    ~FolderLock();

  private:
    int descriptor_ = -1;
};

}  // namespace rasterloom::observe
