// SPDX-License-Identifier: MIT
// Animated PNG (PNG specification, third edition): frames of one size, shown in turn, for ever. A
// viewer that knows nothing of it shows the first frame.
//
//     signature IHDR acTL  fcTL IDAT...  fcTL fdAT...  fcTL fdAT...  IEND
#pragma once

#include "machine/host/picture.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace rasterloom::host {

// `delay_ms`: 1 to 65535 milliseconds a frame. Throws std::invalid_argument for no frames or frames
// that differ in size.
std::vector<std::uint8_t> encode_apng(std::span<const Picture> frames, int delay_ms);

// Whole or not at all. Throws std::runtime_error, naming the file.
void write_apng(const std::filesystem::path& path, std::span<const Picture> frames, int delay_ms);

}  // namespace rasterloom::host
