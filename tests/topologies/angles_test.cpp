// SPDX-License-Identifier: MIT
#include "topologies/angles.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace rasterloom::topology {
namespace {

TEST(Angles, SineAndCosineAgreeWithTheCLibrary) {
    for (int k = -200000; k <= 200000; ++k) {
        const double x = k * 0.000731;
        ASSERT_NEAR(sine(x), std::sin(x), 1e-15) << x;
        ASSERT_NEAR(cosine(x), std::cos(x), 1e-15) << x;
    }
}

TEST(Angles, SineAndCosineOfDegreesAgreeWithTheCLibrary) {
    for (int k = -7200; k <= 7200; ++k) {
        const double d = k * 0.1;
        ASSERT_NEAR(sin_degrees(d), std::sin(d * kPi / 180), 3e-15) << d;
        ASSERT_NEAR(cos_degrees(d), std::cos(d * kPi / 180), 3e-15) << d;
    }
}

TEST(Angles, MultiplesOfNinetyDegreesAreExact) {
    for (int k = -8; k <= 8; ++k) {
        constexpr int kSine[] = {0, 1, 0, -1};
        EXPECT_EQ(sin_degrees(90 * k), kSine[(k + 8) % 4]);
        EXPECT_EQ(cos_degrees(90 * k), kSine[(k + 9) % 4]);
    }
}

TEST(Angles, ArcTangentAgreesWithTheCLibraryInAllQuadrants) {
    for (int y = -60; y <= 60; ++y) {
        for (int x = -60; x <= 60; ++x) {
            if (x != 0 || y != 0) {
                ASSERT_NEAR(arc_tangent2(y * 0.37, x * 0.91), std::atan2(y * 0.37, x * 0.91),
                            1e-15);
            }
        }
    }
    EXPECT_EQ(arc_tangent2(0, 0), 0);
    EXPECT_EQ(atan2_degrees(1, 0), 90);
    EXPECT_EQ(atan2_degrees(-1, 0), -90);
    EXPECT_EQ(atan2_degrees(0, -1), 180);
}

TEST(Angles, ArcCosineAgreesWithTheCLibraryAndClampsItsArgument) {
    for (int k = -10000; k <= 10000; ++k) {
        ASSERT_NEAR(arc_cosine(k / 10000.0), std::acos(k / 10000.0), 1e-15) << k;
    }
    EXPECT_EQ(acos_degrees(1.0000001), 0);
    EXPECT_EQ(acos_degrees(-1.0000001), 180);
}

TEST(Angles, BinaryAnglesWrapAndRoundToTheNearest) {
    EXPECT_EQ(to_angle16(0), 0);
    EXPECT_EQ(to_angle16(180), 32768);
    EXPECT_EQ(to_angle16(-90), 49152);
    EXPECT_EQ(to_angle16(359.999), 0);
    EXPECT_EQ(to_angle16(720 + 45), 8192);
    for (int k = 0; k < 65536; k += 7) {
        ASSERT_EQ(to_angle16(angle16_degrees(static_cast<Angle16>(k))), k);
    }
}

TEST(Angles, SphericalCoordinatesTurnBackIntoTheSameDirection) {
    for (int phi = 0; phi < 360; phi += 7) {
        for (int theta = 1; theta < 180; theta += 3) {
            const Spherical s = to_spherical(from_spherical(phi, theta));
            ASSERT_NEAR(s.phi, phi, 1e-11);
            ASSERT_NEAR(s.theta, theta, 1e-12);
        }
    }
    EXPECT_EQ(to_spherical({0, 0, -2}).theta, 180);
    EXPECT_EQ(to_spherical({0, 0, -2}).phi, 0);
    EXPECT_THROW(normalized({0, 0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace rasterloom::topology
