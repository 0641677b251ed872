// SPDX-License-Identifier: MIT
// PNG files: one picture each.
#pragma once

#include "machine/host/picture.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace rasterloom::host {

std::vector<std::uint8_t> encode_png(const Picture& picture);

// Grey files give one channel, all others three; transparency is laid over black. Throws
// std::runtime_error when the bytes are not a PNG file.
Picture decode_png(std::span<const std::uint8_t> bytes);

// Whole or not at all (atomic_file.hpp). Throws std::runtime_error, naming the file.
void write_png(const std::filesystem::path& path, const Picture& picture);

// Throws std::runtime_error, naming the file.
Picture read_png(const std::filesystem::path& path);

}  // namespace rasterloom::host
