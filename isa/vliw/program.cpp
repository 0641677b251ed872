// SPDX-License-Identifier: MIT
#include "isa/vliw/program.hpp"

#include "isa/diagnostic.hpp"
#include "isa/disassembler.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::isa::vliw {
namespace {

[[noreturn]] void refuse(const Image& image, std::size_t address, std::string_view what) {
    const SourceLocation* where = image.source_of(static_cast<std::uint32_t>(address));
    throw std::invalid_argument(fmt::format("{}: the bundle at {} {}",
                                            where == nullptr ? image.name : to_string(*where),
                                            address, what));
}

}  // namespace

Program::Program(const Image& image) : entry(static_cast<std::uint16_t>(image.entry)) {
    for (const Segment& segment : image.segments) {
        const std::size_t first = segment.address / kBytesPerBundle;
        if (segment.address % kBytesPerBundle != 0 || segment.bytes.size() % kBytesPerBundle != 0) {
            throw std::invalid_argument(
                fmt::format("{}: the {} bytes at address {} are no whole number of bundles",
                            image.name, segment.bytes.size(), first));
        }
        const auto words = words_of_bytes(segment.bytes, 16);
        bundles.resize(first + words.size() / kWordsPerBundle);
        for (std::size_t i = first; i < bundles.size(); ++i) {
            const auto bundle = decode(
                std::span(words).subspan((i - first) * kWordsPerBundle).first<kWordsPerBundle>());
            if (!bundle) {
                refuse(image, i, "is none: it has an operation or a bit that does not exist");
            }
            if (const auto what = conflict(*bundle)) {
                refuse(image, i, *what);
            }
            bundles[i] = *bundle;
        }
    }
    if (image.entry >= bundles.size()) {
        throw std::invalid_argument(
            fmt::format("{}: no bundle at the entry, address {}", image.name, image.entry));
    }
}

}  // namespace rasterloom::isa::vliw
