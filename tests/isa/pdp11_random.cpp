// SPDX-License-Identifier: MIT
#include "tests/isa/pdp11_random.hpp"

#include "isa/pdp11/instruction_table.hpp"

namespace rasterloom::isa::testing {
namespace {

// Instruction words whose operand takes a word more.
bool has_extension(unsigned spec) {
    return (spec & 060U) == 060U || (spec & 067U) == 027U;
}

}  // namespace

std::uint16_t RandomPdp11::value() {
    constexpr std::array<std::uint16_t, 6> kExtremes = {0, 1, 0177777, 0100000, 077777, 0200};
    switch (below(8)) {
        case 0:
            return static_cast<std::uint16_t>(below(9) - 4U);
        case 1:
            return kExtremes[below(kExtremes.size())];
        case 2:
            return word();
        default:
            return static_cast<std::uint16_t>(0400U + 2U * below(067000));
    }
}

std::vector<std::uint16_t> RandomPdp11::instruction() {
    using pdp11::Format;
    const auto table = pdp11::instruction_table();
    while (true) {
        const InstructionRow& row = table[below(static_cast<std::uint32_t>(table.size()))];
        const unsigned first = (row.match | (word() & ~row.mask)) & 0177777U;
        if (left_out(first))
            continue;
        std::vector<std::uint16_t> words = {static_cast<std::uint16_t>(first)};
        const auto format = static_cast<Format>(row.format);
        const auto extend = [&](unsigned spec) {
            if (has_extension(spec))
                words.push_back(value());
        };
        if (format == Format::twofold)
            extend((first >> 6) & 077U);
        if (format == Format::twofold || format == Format::single ||
            format == Format::register_dst || format == Format::register_src) {
            extend(first & 077U);
        }
        // Far jumps lead into random data; most branches shall stay near.
        if (format == Format::branch && below(4) != 0) {
            words[0] = static_cast<std::uint16_t>((first & 0177400U) | ((below(16) - 6U) & 0377U));
        }
        return words;
    }
}

std::vector<std::uint16_t> RandomPdp11::code(std::size_t instructions) {
    std::vector<std::uint16_t> all;
    for (std::size_t i = 0; i < instructions; ++i) {
        const auto words = instruction();
        all.insert(all.end(), words.begin(), words.end());
    }
    return all;
}

std::vector<std::uint8_t> RandomPdp11::memory() {
    std::vector<std::uint8_t> bytes(pdp11::kIoPage);
    for (std::size_t i = 0; i < bytes.size(); i += 2) {
        const std::uint16_t w = value();
        bytes[i] = static_cast<std::uint8_t>(w);
        bytes[i + 1] = static_cast<std::uint8_t>(w >> 8);
    }
    return bytes;
}

RandomStart random_start(RandomPdp11& random, std::size_t instructions) {
    RandomStart start;
    for (auto& r : start.r)
        r = random.value();
    if (random.below(16) != 0)
        start.r[6] = static_cast<std::uint16_t>(01000U + 2U * random.below(060000));
    start.r[7] = static_cast<std::uint16_t>(01000U + 2U * random.below(060000));
    start.psw =
        static_cast<std::uint16_t>(random.below(16) | (random.below(8) == 0 ? 020U : 0U) | 0340U);
    start.code = random.code(instructions);
    return start;
}

bool left_out(unsigned word) {
    const unsigned single = word & 0177700U;
    return word == 0 || word == 1 || word == 5 || single == 0006500 || single == 0006600 ||
           single == 0106500 || single == 0106600;
}

}  // namespace rasterloom::isa::testing
