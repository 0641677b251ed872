// SPDX-License-Identifier: MIT
#include "machine/host/png.hpp"

#include "machine/host/atomic_file.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>
#include <png.h>

namespace rasterloom::host {
namespace {

// libpng's simplified interface, freed whatever happens.
struct Image {
    Image() { image.version = PNG_IMAGE_VERSION; }
    ~Image() { png_image_free(&image); }
    Image(const Image&) = delete;
    Image& operator=(const Image&) = delete;

    [[noreturn]] void fail() const { throw std::runtime_error(image.message); }

    png_image image{};
};

}  // namespace

std::vector<std::uint8_t> encode_png(const Picture& picture) {
    Image writer;
    writer.image.width = static_cast<png_uint_32>(picture.width);
    writer.image.height = static_cast<png_uint_32>(picture.height);
    writer.image.format = picture.channels == 1 ? PNG_FORMAT_GRAY : PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(writer.image);
    std::vector<std::uint8_t> bytes(size);
    if (png_image_write_to_memory(&writer.image, bytes.data(), &size, 0, picture.pixels.data(), 0,
                                  nullptr) == 0)
        writer.fail();
    bytes.resize(size);
    return bytes;
}

Picture decode_png(std::span<const std::uint8_t> bytes) {
    Image reader;
    if (png_image_begin_read_from_memory(&reader.image, bytes.data(), bytes.size()) == 0)
        reader.fail();
    const bool is_grey = (reader.image.format & PNG_FORMAT_FLAG_COLOR) == 0;
    reader.image.format = is_grey ? PNG_FORMAT_GRAY : PNG_FORMAT_RGB;
    Picture picture(static_cast<int>(reader.image.width), static_cast<int>(reader.image.height),
                    is_grey ? 1 : 3);
    const png_color black{0, 0, 0};
    if (png_image_finish_read(&reader.image, &black, picture.pixels.data(), 0, nullptr) == 0)
        reader.fail();
    return picture;
}

void write_png(const std::filesystem::path& path, const Picture& picture) {
    write_file_atomically(path, encode_png(picture));
}

Picture read_png(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw std::runtime_error(
            fmt::format("{}: cannot be opened, expected a PNG file", path.string()));
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
    try {
        return decode_png(bytes);
    } catch (const std::runtime_error& problem) {
        throw std::runtime_error(
            fmt::format("{}: not a PNG file: {}", path.string(), problem.what()));
    }
}

}  // namespace rasterloom::host
