// SPDX-License-Identifier: MIT
#include "isa/image_files.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

#include <fmt/format.h>

namespace rasterloom::isa {
namespace {

constexpr std::uint32_t kHeaderBytes = 16;
constexpr std::uint32_t kSharedText = 0410;
constexpr std::uint32_t kSpace = 65536;

// Symbol types of nlist entries: the section in the low bits, external above them.
constexpr unsigned kTypeMask = 037;
constexpr unsigned kUndefined = 0;
constexpr unsigned kLastSection = 4;  // absolute 1, text 2, data 3, bss 4
constexpr unsigned kExternal = 040;

std::vector<std::uint8_t> read_bytes(const std::filesystem::path& path) {
    std::error_code ignored;
    std::ifstream stream(path, std::ios::binary);
    if (!stream || std::filesystem::is_directory(path, ignored)) {
        throw ImageError(fmt::format("{}: cannot read this file", path.string()));
    }
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

class AoutReader {
  public:
    AoutReader(std::string_view name, std::span<const std::uint8_t> bytes)
        : name_(name), bytes_(bytes) {}

    Image read() {
        read_header();
        Image image;
        image.name = std::string(name_);
        image.entry = word(10);
        const std::uint32_t data_address =
            magic_ == kSharedText ? (text_ + 017777) & ~017777U : text_;
        if (data_address + data_ + bss_ > kSpace) {
            fail(fmt::format("text, data and bss end at {}, above the 65536 bytes there are",
                             data_address + data_ + bss_));
        }
        if (image.entry >= data_address + data_ + bss_) {
            fail(fmt::format("the entry 0{:o} is outside of the program", image.entry));
        }
        Segment program;
        program.bytes.resize(data_address + data_ + bss_);
        std::copy_n(bytes_.begin() + kHeaderBytes, text_, program.bytes.begin());
        std::copy_n(bytes_.begin() + kHeaderBytes + text_, data_,
                    program.bytes.begin() + data_address);
        image.segments.push_back(std::move(program));
        read_symbols(image);
        return image;
    }

  private:
    [[noreturn]] void fail(std::string_view what) const {
        throw ImageError(fmt::format("{}: {}", name_, what));
    }

    std::uint32_t word(std::size_t at) const {
        return bytes_[at] | std::uint32_t{bytes_[at + 1]} << 8;
    }

    void read_header() {
        if (bytes_.size() < kHeaderBytes) {
            fail(fmt::format("not an a.out file: {} bytes, its header alone has {}", bytes_.size(),
                             kHeaderBytes));
        }
        magic_ = word(0);
        if (magic_ == 0411 || magic_ == 0405 || magic_ == 0430 || magic_ == 0431) {
            fail(
                fmt::format("a.out with magic 0{:o} (separate instruction and data spaces, or "
                            "overlays) cannot be "
                            "loaded; 0407 or 0410 is expected",
                            magic_));
        }
        if (magic_ != 0407 && magic_ != kSharedText) {
            fail(fmt::format("not an a.out file: it begins with 0{:o}, 0407 or 0410 is expected",
                             magic_));
        }
        text_ = word(2);
        data_ = word(4);
        bss_ = word(6);
        symbol_bytes_ = word(8);
        const std::uint32_t relocation = word(14) == 0 ? text_ + data_ : 0;
        symbols_at_ = kHeaderBytes + text_ + data_ + relocation;
        if (symbols_at_ + symbol_bytes_ > bytes_.size()) {
            fail(fmt::format("truncated: {} bytes, its header speaks of {}", bytes_.size(),
                             symbols_at_ + symbol_bytes_));
        }
        if (text_ + data_ == 0) {
            fail("there is no program in it");
        }
    }

    // Old entries hold eight letters, a type word and a value; newer ones (2.11BSD, GNU) point into
    // strings that follow.
    void read_symbols(Image& image) const {
        const std::size_t strings_at = symbols_at_ + symbol_bytes_;
        const bool with_strings = bytes_.size() >= strings_at + 4;
        const std::size_t size = with_strings ? 8 : 12;
        if (symbol_bytes_ % size != 0) {
            fail(fmt::format("{} bytes of symbols are no whole number of entries of {}",
                             symbol_bytes_, size));
        }
        for (std::size_t at = symbols_at_; at < strings_at; at += size) {
            const std::string name = with_strings ? long_name(at, strings_at) : short_name(at);
            const unsigned type = with_strings ? bytes_[at + 4] : word(at + 8);
            const std::uint32_t value = word(at + size - 2);
            if ((type & kTypeMask) == kUndefined && (type & kExternal) != 0) {
                fail(fmt::format("symbol '{}' is undefined: this file has yet to be linked", name));
            }
            if ((type & kTypeMask) <= kLastSection && (type & ~(kTypeMask | kExternal)) == 0 &&
                !name.empty()) {
                image.symbols.insert_or_assign(name, value);
            }
        }
    }

    std::string short_name(std::size_t at) const {
        const auto first = bytes_.begin() + static_cast<std::ptrdiff_t>(at);
        return {first, std::find(first, first + 8, 0)};
    }

    std::string long_name(std::size_t at, std::size_t strings_at) const {
        // The middle-endian long of the PDP-11: high word first.
        const std::size_t offset = strings_at + (std::size_t{word(at)} << 16 | word(at + 2));
        if (offset >= bytes_.size()) {
            fail("a symbol's name lies outside of the file");
        }
        const auto first = bytes_.begin() + static_cast<std::ptrdiff_t>(offset);
        return {first, std::find(first, bytes_.end(), 0)};
    }

    std::string_view name_;
    std::span<const std::uint8_t> bytes_;
    std::uint32_t magic_ = 0;
    std::uint32_t text_ = 0;
    std::uint32_t data_ = 0;
    std::uint32_t bss_ = 0;
    std::uint32_t symbol_bytes_ = 0;
    std::size_t symbols_at_ = 0;
};

}  // namespace

Image raw_image(std::string_view name, std::span<const std::uint8_t> bytes,
                std::uint32_t load_address, std::uint32_t entry, std::uint32_t memory_bytes) {
    if (bytes.empty()) {
        throw ImageError(fmt::format("{}: the file is empty", name));
    }
    if (load_address > memory_bytes || bytes.size() > memory_bytes - load_address) {
        throw ImageError(fmt::format("{}: {} bytes from 0{:o} do not fit in {} bytes of memory",
                                     name, bytes.size(), load_address, memory_bytes));
    }
    if (entry < load_address || entry >= load_address + bytes.size()) {
        throw ImageError(
            fmt::format("{}: the entry 0{:o} is outside of the program, 0{:o} to 0{:o}", name,
                        entry, load_address, load_address + bytes.size() - 1));
    }
    Image image;
    image.name = std::string(name);
    image.entry = entry;
    image.segments.push_back({load_address, {bytes.begin(), bytes.end()}});
    return image;
}

Image aout_image(std::string_view name, std::span<const std::uint8_t> bytes) {
    return AoutReader(name, bytes).read();
}

Image read_raw_image(const std::filesystem::path& path, std::uint32_t load_address,
                     std::uint32_t entry, std::uint32_t memory_bytes) {
    return raw_image(path.string(), read_bytes(path), load_address, entry, memory_bytes);
}

Image read_aout_image(const std::filesystem::path& path) {
    return aout_image(path.string(), read_bytes(path));
}

std::vector<std::uint8_t> raw_bytes(const Image& image) {
    std::vector<std::uint8_t> bytes;
    for (const Segment& segment : image.segments) {
        bytes.resize(segment.address - image.segments.front().address);
        bytes.insert(bytes.end(), segment.bytes.begin(), segment.bytes.end());
    }
    return bytes;
}

void write_raw_image(const Image& image, const std::filesystem::path& path) {
    const std::vector<std::uint8_t> bytes = raw_bytes(image);
    const std::filesystem::path partial = path.string() + ".partial";
    std::ofstream stream(partial, std::ios::binary | std::ios::trunc);
    stream.write(reinterpret_cast<const char*>(bytes.data()),
                 static_cast<std::streamsize>(bytes.size()));
    stream.close();
    std::error_code failed;
    if (stream) {
        std::filesystem::rename(partial, path, failed);
    }
    if (!stream || failed) {
        std::error_code ignored;
        std::filesystem::remove(partial, ignored);
        throw ImageError(fmt::format("{}: cannot write this file", path.string()));
    }
}

}  // namespace rasterloom::isa
