// SPDX-License-Identifier: MIT
// Programs in files: raw images, and a.out as the PDP-11 Unixes and GNU's pdp11-aout tools write
// it.
//
// a.out: a header of eight words (low byte first): magic, sizes in bytes of text, data, bss and
// symbols, entry, unused, and a flag that no relocation follows. Magic 0407: data stands right
// behind text; 0410: text is shared, data begins at the next 8 KiB. 0411 and up (separate
// instruction and data spaces, overlays) make no sense in one private memory.
#pragma once

#include "isa/image.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::isa {

// A file that is not what it should be: "file: what is wrong".
class ImageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// The bytes as they are, to stand at `load_address`. Throws ImageError when they pass
// `memory_bytes` or there are none.
Image raw_image(std::string_view name, std::span<const std::uint8_t> bytes,
                std::uint32_t load_address, std::uint32_t entry,
                std::uint32_t memory_bytes = 65536);

// Symbols included; bss becomes zeros. Throws ImageError for a file that is foreign, truncated, or
// not yet linked.
Image aout_image(std::string_view name, std::span<const std::uint8_t> bytes);

Image read_raw_image(const std::filesystem::path& path, std::uint32_t load_address,
                     std::uint32_t entry, std::uint32_t memory_bytes = 65536);
Image read_aout_image(const std::filesystem::path& path);

// What a raw file of the image holds: its bytes from the lowest address to the highest, gaps as
// zeros.
std::vector<std::uint8_t> raw_bytes(const Image& image);

// Writes raw_bytes; nothing is left under the name when that fails. Throws ImageError.
void write_raw_image(const Image& image, const std::filesystem::path& path);

}  // namespace rasterloom::isa
