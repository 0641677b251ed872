// SPDX-License-Identifier: MIT
// The I/O page of a node: addresses of its registers (programs/README.md, "The node a PDP-11
// program sees").
#pragma once

#include <cstdint>
#include <optional>

namespace rasterloom {

inline constexpr int kMaxPorts = 16;
inline constexpr std::uint32_t kPortRegisters = 0164000;  // port k's stand 020 k higher
inline constexpr std::uint32_t kPortStride = 020;
inline constexpr std::uint32_t kNodeRegisters = 0165000;
inline constexpr std::uint32_t kFrameBufferRegisters = 0166000;

// The values are the offsets within a port's registers...
enum class PortRegister : std::uint8_t {
    txstat = 0,
    txaddr = 2,
    txlen = 4,
    txused = 6,
    rxstat = 010,
    rxlen = 012,
    rxaddr = 014,
};

// ...and within the node's own.
enum class NodeRegister : std::uint8_t {
    node = 0,
    ports = 2,
    rxany = 4,
    waitfor = 6,
    txroom = 010,
    credit = 012,
    phase = 014,
    mark = 016,
    fault = 020,
};

// Of the frame buffer; both can only be written.
inline constexpr std::uint32_t kFbRow = kFrameBufferRegisters;
inline constexpr std::uint32_t kFbClear = kFrameBufferRegisters + 2;

// TXSTAT and RXSTAT.
inline constexpr std::uint32_t kStatNoLink = 0100000;
inline constexpr std::uint32_t kStatReady = 0200;
inline constexpr std::uint32_t kStatInterruptEnable = 0100;

// WAITFOR. The bits below kWaitPhase stand for room at the port of that number.
inline constexpr std::uint32_t kWaitMessage = 0100000;
inline constexpr std::uint32_t kWaitPhase = 040000;
inline constexpr std::uint32_t kWaitRoom = 037777;

inline constexpr std::uint32_t kNoPort = 0177777;  // what RXANY shows when nothing waits

inline constexpr int kInterruptLevel = 5;
constexpr std::uint32_t receive_vector(int port) {
    return 0300U + 010U * static_cast<std::uint32_t>(port);
}
constexpr std::uint32_t transmit_vector(int port) {
    return receive_vector(port) + 4U;
}

struct RegisterAddress {
    std::optional<int> port;  // empty: a register of the node's own
    std::uint8_t offset = 0;  // even
};

// Which register block an even byte address lies in; nothing for an address outside both or an odd
// one.
constexpr std::optional<RegisterAddress> decode_register(std::uint32_t address) {
    if (address % 2 != 0) {
        return std::nullopt;
    }
    if (address >= kPortRegisters && address < kPortRegisters + kMaxPorts * kPortStride) {
        const std::uint32_t offset = address - kPortRegisters;
        return RegisterAddress{static_cast<int>(offset / kPortStride),
                               static_cast<std::uint8_t>(offset % kPortStride)};
    }
    if (address >= kNodeRegisters &&
        address <= kNodeRegisters + static_cast<std::uint32_t>(NodeRegister::fault)) {
        return RegisterAddress{std::nullopt, static_cast<std::uint8_t>(address - kNodeRegisters)};
    }
    return std::nullopt;
}

}  // namespace rasterloom
