// SPDX-License-Identifier: MIT
#include "machine/emulation/node_memory.hpp"

#include <stdexcept>
#include <string>

#include <fmt/format.h>

namespace rasterloom {

namespace {

void put(std::vector<std::uint8_t>& bytes, std::size_t index, std::int64_t word) {
    const auto value = static_cast<std::uint16_t>(word);
    bytes.at(index) = static_cast<std::uint8_t>(value & 0xff);
    bytes.at(index + 1) = static_cast<std::uint8_t>(value >> 8);
}

std::uint8_t byte_of(const isa::Image& image, std::uint32_t address) {
    for (const isa::Segment& segment : image.segments) {
        if (address >= segment.address && address - segment.address < segment.bytes.size()) {
            return segment.bytes[address - segment.address];
        }
    }
    return 0;
}

}  // namespace

std::uint32_t require_symbol(const isa::Image& image, std::string_view symbol) {
    const auto value = image.symbol(symbol);
    if (!value) {
        throw std::invalid_argument(fmt::format(
            "{}: the program has no symbol '{}', which its loader fills", image.name, symbol));
    }
    return *value;
}

std::uint16_t word_at(std::span<const std::uint8_t> memory, std::uint32_t address) {
    if (std::size_t{address} + 2 > memory.size()) {
        throw std::out_of_range(
            fmt::format("address {:06o} lies beyond the node's memory", address));
    }
    return static_cast<std::uint16_t>(memory[address] | memory[address + 1] << 8);
}

NodeMemory::NodeMemory(const isa::Image& image, std::string_view first, std::string_view end,
                       std::string_view tables)
    : image_(image) {
    constants_.address = require_symbol(image, first);
    const std::uint32_t beyond = require_symbol(image, end);
    for (std::uint32_t a = constants_.address; a < beyond; ++a) {
        constants_.bytes.push_back(byte_of(image, a));
    }
    tables_.address = require_symbol(image, tables);
}

void NodeMemory::set(std::string_view symbol, std::int64_t value, std::uint32_t offset) {
    set_at(address_of(symbol) + offset, value);
}

std::uint32_t NodeMemory::address_of(std::string_view symbol) const {
    return require_symbol(image_, symbol);
}

void NodeMemory::set_at(std::uint32_t address, std::int64_t value) {
    if (address < constants_.address ||
        address - constants_.address + 2 > constants_.bytes.size()) {
        throw std::logic_error(
            fmt::format("address {:06o} is not one that the loader fills", address));
    }
    put(constants_.bytes, address - constants_.address, value);
}

void NodeMemory::append(std::int64_t word) {
    tables_.bytes.resize(tables_.bytes.size() + 2);
    put(tables_.bytes, tables_.bytes.size() - 2, word);
}

void NodeMemory::replace(std::uint32_t address, std::int64_t word) {
    put(tables_.bytes, address - tables_.address, word);
}

}  // namespace rasterloom
