// SPDX-License-Identifier: MIT
#include "machine/node/registers.hpp"

#include <gtest/gtest.h>

namespace rasterloom {
namespace {

TEST(Registers, StandWhereProgramsReadmePutsThem) {
    const auto rxaddr = decode_register(0164000 + 5 * 020 + 014);
    ASSERT_TRUE(rxaddr.has_value());
    EXPECT_EQ(rxaddr->port, 5);
    EXPECT_EQ(static_cast<PortRegister>(rxaddr->offset), PortRegister::rxaddr);
    const auto mark = decode_register(0165016);
    ASSERT_TRUE(mark.has_value());
    EXPECT_FALSE(mark->port.has_value());
    EXPECT_EQ(static_cast<NodeRegister>(mark->offset), NodeRegister::mark);
    EXPECT_EQ(receive_vector(3), 0330U);
    EXPECT_EQ(transmit_vector(3), 0334U);
}

TEST(Registers, AreNotAtOddAddressesNorBeyondTheirBlocks) {
    for (const std::uint32_t address :
         {0164001U, 0163776U, 0164400U, 0165022U, 0165001U, 0160000U}) {
        EXPECT_FALSE(decode_register(address).has_value()) << std::oct << address;
    }
    EXPECT_TRUE(decode_register(0164376).has_value());
    EXPECT_TRUE(decode_register(0165020).has_value());
}

}  // namespace
}  // namespace rasterloom
