// SPDX-License-Identifier: MIT
#include "tests/isa/simh.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace rasterloom::isa::testing {
namespace {

constexpr std::size_t kListed = 12;  // addresses in one command: SIMH's lines are short

std::string octal(unsigned value) {
    std::array<char, 12> text{};
    std::snprintf(text.data(), text.size(), "%o", value);
    return text.data();
}

// DEC's absolute loader format: blocks of 1, 0, length, address, bytes, checksum; a block without
// bytes ends it.
std::string absolute_tape(const std::vector<std::uint8_t>& memory) {
    std::string tape;
    const auto block = [&](std::uint32_t address, std::uint32_t first, std::uint32_t count) {
        std::string text = {1, 0};
        for (const std::uint32_t word : {count + 6, address}) {
            text += static_cast<char>(word & 0377U);
            text += static_cast<char>(word >> 8);
        }
        text.append(memory.begin() + first, memory.begin() + first + count);
        unsigned sum = 0;
        for (const char c : text)
            sum += static_cast<unsigned char>(c);
        tape += text + static_cast<char>(-sum & 0377U);
    };
    constexpr std::uint32_t kBlock = 4096;
    for (std::uint32_t at = 0; at < memory.size(); at += kBlock)
        block(at, at, kBlock);
    block(1, 0, 0);
    return tape;
}

void write_file(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

}  // namespace

bool SimhScript::available() {
    return std::system("command -v pdp11 >/dev/null 2>&1") == 0;
}

SimhScript::SimhScript(const std::vector<std::uint8_t>& memory) {
    write_file(folder_.path() / "memory.lda", absolute_tape(memory));
    text_ = "set cpu 11/40\nset cpu 64k\ndep STOP_TRAPS 0\ndep STOP_VECA 0\ndep STOP_SPA 0\nload " +
            (folder_.path() / "memory.lda").string() + "\n";
}

void SimhScript::deposit(std::uint32_t address, std::uint16_t word) {
    text_ += "dep " + octal(address) + " " + octal(word) + "\n";
}

void SimhScript::start(const RandomStart& start) {
    for (unsigned i = 0; i < 6; ++i)
        text_ += "dep R" + octal(i) + " " + octal(start.r[i]) + "\n";
    text_ += "dep SP " + octal(start.r[6]) + "\ndep PC " + octal(start.r[7]) + "\ndep PSW " +
             octal(start.psw) + "\ndep TRAPS 0\ndep WAIT 0\n";
    std::uint32_t address = start.r[7];
    for (const std::uint16_t word : start.code) {
        deposit(address, word);
        address += 2;
    }
}

void SimhScript::step(std::size_t instructions) {
    text_ += "step " + std::to_string(instructions) + "\n";
}

void SimhScript::examine(const std::vector<std::uint32_t>& addresses) {
    text_ += "ex R0,R1,R2,R3,R4,R5,SP,PC,PSW\n";
    for (std::size_t i = 0; i < addresses.size(); ++i) {
        text_ += (i % kListed == 0 ? (i == 0 ? "ex " : "\nex ") : ",") + octal(addresses[i]);
    }
    text_ += "\n";
    counts_.push_back(addresses.size());
}

std::vector<SimhState> SimhScript::run() {
    write_file(folder_.path() / "script", text_ + "quit\n");
    const std::string command = "pdp11 " + (folder_.path() / "script").string() + " >" +
                                (folder_.path() / "out").string() + " 2>&1 </dev/null";
    if (std::system(command.c_str()) != 0)
        throw std::runtime_error("pdp11 failed: " + command);
    std::ifstream out(folder_.path() / "out");
    std::vector<unsigned> values;
    std::string line;
    // "R0:<tab>012345" or "1000:<tab>012345"; anything else is talk.
    while (std::getline(out, line)) {
        const auto colon = line.find(":\t");
        if (colon == std::string::npos || line.find(' ') < colon)
            continue;
        values.push_back(static_cast<unsigned>(std::strtoul(line.c_str() + colon + 2, nullptr, 8)));
    }
    std::vector<SimhState> states;
    auto next = values.begin();
    for (const std::size_t count : counts_) {
        if (values.end() - next < static_cast<std::ptrdiff_t>(count + 9))
            break;
        SimhState& state = states.emplace_back();
        for (auto& r : state.registers)
            r = static_cast<std::uint16_t>(*next++);
        for (std::size_t i = 0; i < count; ++i)
            state.words.push_back(static_cast<std::uint16_t>(*next++));
    }
    return states;
}

}  // namespace rasterloom::isa::testing
