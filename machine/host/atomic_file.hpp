// SPDX-License-Identifier: MIT
// Files that appear whole or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace rasterloom::host {

// Writes beside the final name, then renames. Throws std::runtime_error, naming the file, and
// leaves neither a half-written file nor a changed old one.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

}  // namespace rasterloom::host
