// SPDX-License-Identifier: MIT
#include "machine/observe/page/packed.hpp"

#include <new>
#include <vector>

#include <zlib.h>

namespace rasterloom::observe {

namespace {

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string base64(std::span<const std::uint8_t> bytes) {
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        std::uint32_t group = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            group = group << 8U | (at + i < bytes.size() ? bytes[at + i] : 0U);
        }
        for (std::size_t i = 0; i < 4; ++i) {
            const bool padding = at + i > bytes.size();
            text += padding ? '=' : kDigits[group >> (18U - 6U * i) & 63U];
        }
    }
    return text;
}

std::string packed(std::string_view bytes) {
    uLongf size = compressBound(bytes.size());
    std::vector<std::uint8_t> smaller(size);
    if (compress2(smaller.data(), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(),
                  Z_DEFAULT_COMPRESSION) != Z_OK) {
        throw std::bad_alloc();  // the only reason there is with a buffer of that size
    }
    return base64(std::span(smaller).first(size));
}

}  // namespace rasterloom::observe
