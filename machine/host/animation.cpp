// SPDX-License-Identifier: MIT
#include "machine/host/animation.hpp"

#include "machine/host/atomic_file.hpp"
#include "machine/host/png.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <zlib.h>

namespace rasterloom::host {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kSignatureSize = 8;

void append16(Bytes& bytes, std::uint32_t value) {
    bytes.push_back(static_cast<std::uint8_t>(value >> 8));
    bytes.push_back(static_cast<std::uint8_t>(value));
}

void append32(Bytes& bytes, std::uint32_t value) {
    append16(bytes, value >> 16);
    append16(bytes, value & 0xFFFFU);
}

std::uint32_t read32(std::span<const std::uint8_t> bytes) {
    return static_cast<std::uint32_t>(bytes[0]) << 24 | static_cast<std::uint32_t>(bytes[1]) << 16 |
           static_cast<std::uint32_t>(bytes[2]) << 8 | bytes[3];
}

struct Chunk {
    std::string_view type;
    std::span<const std::uint8_t> data;
};

// A whole PNG file's chunks; the views point into `file`.
std::vector<Chunk> chunks_of(std::span<const std::uint8_t> file) {
    std::vector<Chunk> chunks;
    for (std::size_t at = kSignatureSize; at + 12 <= file.size();) {
        const std::size_t length = read32(file.subspan(at));
        chunks.push_back({{reinterpret_cast<const char*>(file.data()) + at + 4, 4},
                          file.subspan(at + 8, length)});
        at += 12 + length;
    }
    return chunks;
}

// Length, type, data, and the check sum of type and data.
void append_chunk(Bytes& file, std::string_view type, std::span<const std::uint8_t> data) {
    append32(file, static_cast<std::uint32_t>(data.size()));
    const std::size_t start = file.size();
    file.insert(file.end(), type.begin(), type.end());
    file.insert(file.end(), data.begin(), data.end());
    append32(file, static_cast<std::uint32_t>(
                       crc32(0, file.data() + start, static_cast<uInt>(file.size() - start))));
}

Bytes animation_control(std::size_t frames) {
    Bytes data;
    append32(data, static_cast<std::uint32_t>(frames));
    append32(data, 0);  // plays: for ever
    return data;
}

Bytes frame_control(std::uint32_t sequence, const Picture& frame, int delay_ms) {
    Bytes data;
    append32(data, sequence);
    append32(data, static_cast<std::uint32_t>(frame.width));
    append32(data, static_cast<std::uint32_t>(frame.height));
    append32(data, 0);  // offset x
    append32(data, 0);  // offset y
    append16(data, static_cast<std::uint32_t>(delay_ms));
    append16(data, 1000);
    append16(data, 0);  // leave the frame, replace what was there
    return data;
}

void append_later_frame(Bytes& file, const Picture& frame, int delay_ms, std::uint32_t& sequence) {
    append_chunk(file, "fcTL", frame_control(sequence++, frame, delay_ms));
    const Bytes png = encode_png(frame);
    for (const auto& chunk : chunks_of(png))
        if (chunk.type == "IDAT") {
            Bytes data;
            append32(data, sequence++);
            data.insert(data.end(), chunk.data.begin(), chunk.data.end());
            append_chunk(file, "fdAT", data);
        }
}

void check_frames(std::span<const Picture> frames, int delay_ms) {
    if (frames.empty())
        throw std::invalid_argument("an animation without frames, expected one at least");
    if (delay_ms < 1 || delay_ms > 65535)
        throw std::invalid_argument(
            fmt::format("a delay of {} ms a frame, expected 1 to 65535", delay_ms));
    for (const auto& frame : frames)
        if (frame.width != frames[0].width || frame.height != frames[0].height ||
            frame.channels != frames[0].channels)
            throw std::invalid_argument(
                "frames of different sizes, expected one size for an animation");
}

}  // namespace

std::vector<std::uint8_t> encode_apng(std::span<const Picture> frames, int delay_ms) {
    check_frames(frames, delay_ms);
    const Bytes first = encode_png(frames[0]);
    Bytes file(first.begin(), first.begin() + kSignatureSize);
    std::uint32_t sequence = 0;
    bool has_control = false;
    for (const auto& chunk : chunks_of(first)) {
        if (chunk.type == "IEND")
            break;
        if (chunk.type == "IDAT" && !has_control) {
            append_chunk(file, "acTL", animation_control(frames.size()));
            append_chunk(file, "fcTL", frame_control(sequence++, frames[0], delay_ms));
            has_control = true;
        }
        append_chunk(file, chunk.type, chunk.data);
    }
    for (const auto& frame : frames.subspan(1))
        append_later_frame(file, frame, delay_ms, sequence);
    append_chunk(file, "IEND", {});
    return file;
}

void write_apng(const std::filesystem::path& path, std::span<const Picture> frames, int delay_ms) {
    write_file_atomically(path, encode_apng(frames, delay_ms));
}

}  // namespace rasterloom::host
