// SPDX-License-Identifier: MIT
// The program's scan conversion of random triangles on a processor that owns a whole small screen:
// which pixels, which intensity, no crack and no pixel twice; against exact arithmetic on the same
// vertices.
#include "programs/bare_node.hpp"
#include "programs/strothotte_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

constexpr int kSide = 64;  // pixels

struct Vertex {
    int x = 0;  // 1/64 pixel
    int y = 0;
    int z = 0;  // s2.13
    int i = 0;  // 7.7
};
using Triangle = std::array<Vertex, 3>;

// A processor that owns the columns from `first` to `last` of every row. What lies left of them
// goes through port 0, right of them through port 1.
class Screen {
  public:
    explicit Screen(int first = 0, int last = kSide - 1) : node_({}) {
        node_.set_word("screen_width", kSide);
        node_.set_word("screen_height", kSide);
        node_.set_word("last_column", kSide - 1);
        node_.set_word("last_row", kSide - 1);
        node_.set_word("row_table", kRows);
        node_.set_word("row_count", kSide);
        node_.set_word("depth_start", kDepths);
        node_.set_word("depth_groups", kSide * kSide / 8);
        node_.set_word("grey_start", kGreys);
        node_.set_word("grey_groups", kSide * kSide / 16);
        node_.set_word("block_size", 44);
        node_.set_word("pool_next", kPool);
        node_.set_word("pool_last", kPool + 20 * 44);
        node_.set_word("free_count", 21);
        for (int y = 0; y < kSide; ++y) {
            const std::array<int, 7> row{first,
                                         last,
                                         last - first + 1,
                                         kDepths + 2 * (kSide * y + first),
                                         kGreys + kSide * y + first,
                                         0177770,
                                         0177771};
            for (int i = 0; i < 7; ++i) {
                node_.set_word(static_cast<std::uint32_t>(kRows + 16 * y + 2 * i),
                               row[static_cast<std::size_t>(i)]);
            }
        }
        clear();
    }

    void clear() { node_.call("clear_pixels"); }

    void draw(const Triangle& triangle) {
        const std::uint32_t message = kPool - 100;
        for (std::uint32_t v = 0; v < 3; ++v) {
            const std::uint32_t at = message + BareNode::symbol("t_body") + 8 * v;
            node_.set_word(at, triangle[v].x);
            node_.set_word(at + 2, triangle[v].y);
            node_.set_word(at + 4, triangle[v].z);
            node_.set_word(at + 6, triangle[v].i);
        }
        node_.set_word("draw_list", static_cast<int>(message));
        node_.set_word(message - 4, 0);
        const int blocks = node_.word("free_count");
        node_.call("begin_triangle");
        EXPECT_EQ(node_.word("scanning"), 0);
        EXPECT_EQ(node_.word("free_count"), blocks + 1) << "blocks lost or won";
        EXPECT_EQ(node_.credit(), static_cast<int>(node_.sent().size()));
        // The triangle's own block is not the pool's: take it out again.
        node_.set_word("free_list", node_.word(message - 4));
        node_.set_word("free_count", blocks);
    }

    // Takes in a SPAN message that another processor sent.
    void take(const BareNode::Sent& sent) {
        ASSERT_EQ(sent.bytes.at(0), BareNode::symbol("kind_span"));
        const BareNode::Registers block = node_.call("get_block");
        node_.set_bytes(block[5], sent.bytes);
        node_.call("span_in", block);
    }
    const std::vector<BareNode::Sent>& sent() const { return node_.sent(); }

    bool covered(int x, int y) const { return depth(x, y) != 077777; }
    int depth(int x, int y) const {
        return static_cast<std::int16_t>(
            node_.word(static_cast<std::uint32_t>(kDepths + 2 * (kSide * y + x))));
    }
    int grey(int x, int y) const {
        return node_.byte(static_cast<std::uint32_t>(kGreys + kSide * y + x));
    }
    std::int64_t cycles() const { return node_.cycles(); }

  private:
    static constexpr int kRows = 040000;
    static constexpr int kDepths = kRows + 16 * kSide;
    static constexpr int kGreys = kDepths + 2 * kSide * kSide;
    static constexpr int kPool = 0120000;
    BareNode node_;
};

// Horizontal distance in pixels from the pixel's centre to the nearer side of the triangle on its
// row: positive inside.
double depth_inside(const Triangle& t, int x, int y) {
    double left = std::numeric_limits<double>::max();
    double right = std::numeric_limits<double>::lowest();
    const double cy = 64 * y + 32;
    for (std::size_t e = 0; e < 3; ++e) {
        const Vertex& a = t[e];
        const Vertex& b = t[(e + 1) % 3];
        const bool crosses = (a.y <= cy && cy < b.y) || (b.y <= cy && cy < a.y);
        if (crosses) {
            const double at = a.x + (cy - a.y) * (b.x - a.x) / (b.y - a.y);
            left = std::min(left, at);
            right = std::max(right, at);
        }
    }
    const double cx = 64 * x + 32;
    return left > right ? -1e9 : std::min(cx - left, right - cx) / 64;
}

// Value of a plane through the vertices at the pixel's centre, and the steepness of that plane a
// pixel.
struct Plane {
    double value = 0;
    double steepness = 0;
};
Plane plane_at(const Triangle& t, int Vertex::*what, int x, int y) {
    const double x1 = t[1].x - t[0].x, y1 = t[1].y - t[0].y, x2 = t[2].x - t[0].x,
                 y2 = t[2].y - t[0].y;
    const double v1 = t[1].*what - t[0].*what, v2 = t[2].*what - t[0].*what;
    const double area = x1 * y2 - x2 * y1;
    const double gx = (v1 * y2 - v2 * y1) / area, gy = (x1 * v2 - x2 * v1) / area;
    return {t[0].*what + gx * (64 * x + 32 - t[0].x) + gy * (64 * y + 32 - t[0].y),
            64 * (std::fabs(gx) + std::fabs(gy))};
}

class Triangles {
  public:
    explicit Triangles(unsigned seed) : random_(seed) {}
    int between(int low, int high) {
        return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1));
    }
    Vertex vertex(int low, int high) {
        return {between(64 * low, 64 * high), between(64 * low, 64 * high), between(-9000, 9000),
                between(0, 32640)};
    }
    Triangle triangle() {
        switch (between(0, 4)) {
            case 0: {  // small
                const int x = between(-2, 60), y = between(-2, 60);
                Triangle t{vertex(0, 6), vertex(0, 6), vertex(0, 6)};
                for (Vertex& v : t) {
                    v.x += 64 * x;
                    v.y += 64 * y;
                }
                return t;
            }
            case 1: {  // a sliver
                Triangle t{vertex(0, 63), vertex(0, 63), {}};
                t[2] = t[0];
                t[2].x += between(-40, 40);
                t[2].i = between(0, 32640);
                return t;
            }
            case 2:  // mostly beside the screen
                return {vertex(-90, 150), vertex(-90, 150), vertex(-90, 150)};
            default:
                return {vertex(-5, 70), vertex(-5, 70), vertex(-5, 70)};
        }
    }

  private:
    std::mt19937 random_;
};

void expect_triangle(const Screen& screen, const Triangle& t) {
    constexpr double kEdge = 1.0 / 24;  // pixels: beside an edge either answer is right
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const double inside = depth_inside(t, x, y);
            if (std::fabs(inside) < kEdge) {
                continue;
            }
            ASSERT_EQ(screen.covered(x, y), inside > 0) << x << ", " << y;
            if (inside > 0) {
                const Plane grey = plane_at(t, &Vertex::i, x, y);
                const Plane depth = plane_at(t, &Vertex::z, x, y);
                ASSERT_NEAR(screen.grey(x, y), grey.value / 128, 1.0 + grey.steepness / 128 / 12)
                    << x << ", " << y;
                ASSERT_NEAR(screen.depth(x, y), depth.value, 4 + depth.steepness / 12)
                    << x << ", " << y;
            }
        }
    }
}

TEST(StrothotteScan, DrawsTheRightPixelsWithTheRightIntensities) {
    Screen screen;
    Triangles make(1981);
    for (int round = 0; round < 1500; ++round) {
        const Triangle t = make.triangle();
        screen.clear();
        screen.draw(t);
        expect_triangle(screen, t);
        if (testing::Test::HasFatalFailure()) {
            for (const Vertex& v : t) {
                ADD_FAILURE() << "round " << round << ": " << v.x << " " << v.y << " " << v.z << " "
                              << v.i;
            }
            return;
        }
    }
}

TEST(StrothotteScan, CoversAPolygonsPixelsOnceEachWhateverItsTriangles) {
    Screen screen;
    Triangles make(482);
    for (int round = 0; round < 60; ++round) {
        // A fan about an inner point: all edges but the outermost are shared.
        const Vertex middle = make.vertex(20, 44);
        const std::array<Vertex, 5> rim{
            Vertex{64 * 32, -64 * 4, 0, 0}, Vertex{64 * 70, 64 * 20, 0, 0},
            Vertex{64 * 50, 64 * 66, 0, 0}, Vertex{64 * 12, 64 * 63, 0, 0},
            Vertex{-64 * 5, 64 * 25, 0, 0}};
        std::vector<int> times(kSide * kSide);
        std::vector<double> inside(kSide * kSide, -1e9);
        for (std::size_t e = 0; e < rim.size(); ++e) {
            const Triangle t{middle, rim[e], rim[(e + 1) % rim.size()]};
            screen.clear();
            screen.draw(t);
            for (int p = 0; p < kSide * kSide; ++p) {
                times[static_cast<std::size_t>(p)] += screen.covered(p % kSide, p / kSide) ? 1 : 0;
            }
        }
        const auto in_rim = [&](int x, int y) {
            double least = 1e9;
            for (std::size_t e = 0; e < rim.size(); ++e) {
                const Vertex &a = rim[e], &b = rim[(e + 1) % rim.size()];
                const double ex = b.x - a.x, ey = b.y - a.y;
                least = std::min(least, (ex * (64 * y + 32 - a.y) - ey * (64 * x + 32 - a.x)) /
                                            std::hypot(ex, ey));
            }
            return least;
        };
        for (int p = 0; p < kSide * kSide; ++p) {
            const double margin = in_rim(p % kSide, p / kSide);
            if (margin > 8) {
                ASSERT_EQ(times[static_cast<std::size_t>(p)], 1) << p % kSide << ", " << p / kSide;
            } else if (margin < -8) {
                ASSERT_EQ(times[static_cast<std::size_t>(p)], 0) << p % kSide << ", " << p / kSide;
            }
        }
    }
}

TEST(StrothotteScan, NeverWrapsAnIntensityInSteepTriangles) {
    Screen screen;
    Triangles make(3);
    for (int round = 0; round < 400; ++round) {
        const int x = make.between(0, 63 * 64), y = make.between(0, 50 * 64);
        const int least = make.between(0, 1) * 128, most = 255 * 128;
        const Triangle t{Vertex{x, y, 0, least},
                         Vertex{x + make.between(1, 400), y + make.between(0, 800), 0, most},
                         Vertex{x + make.between(-200, 200), y + make.between(0, 800), 0,
                                make.between(0, 1) * most}};
        screen.clear();
        screen.draw(t);
        expect_triangle(screen, t);
        ASSERT_FALSE(testing::Test::HasFatalFailure()) << "round " << round;
    }
}

TEST(StrothotteScan, HandsOverPartsOfScanlinesAsIfOneProcessorHadDrawnThem) {
    Screen whole;
    Triangles make(20);
    for (int round = 0; round < 150; ++round) {
        const Triangle t = make.triangle();
        whole.clear();
        whole.draw(t);
        Screen left(0, 22);
        Screen middle(23, 37);
        Screen right(38, kSide - 1);
        middle.draw(t);
        for (const BareNode::Sent& sent : middle.sent()) {
            (sent.port == 0 ? left : right).take(sent);
        }
        ASSERT_TRUE(left.sent().empty() && right.sent().empty());
        for (int p = 0; p < kSide * kSide; ++p) {
            const int x = p % kSide;
            const int y = p / kSide;
            const Screen& owner = x <= 22 ? left : x <= 37 ? middle : right;
            ASSERT_EQ(owner.depth(x, y), whole.depth(x, y)) << x << ", " << y;
            ASSERT_EQ(owner.grey(x, y), whole.grey(x, y)) << x << ", " << y;
        }
    }
}

TEST(StrothotteScan, KeepsTheFirstOfTwoTrianglesAtOneDepth) {
    Screen screen;
    const auto flat = [](int grey) {
        return Triangle{Vertex{0, 0, 700, grey * 128}, Vertex{4096, 0, 700, grey * 128},
                        Vertex{0, 4096, 700, grey * 128}};
    };
    screen.draw(flat(40));
    screen.draw(flat(90));
    EXPECT_EQ(screen.grey(5, 5), 40);
}

TEST(StrothotteScan, KeepsTheNearerOfTwoTrianglesInEitherOrder) {
    Screen screen;
    const Triangle back{Vertex{0, 0, 5000, 100 * 128}, Vertex{4096, 0, 5000, 100 * 128},
                        Vertex{0, 4096, 5000, 100 * 128}};
    const Triangle front{Vertex{640, 640, -5000, 200 * 128}, Vertex{1920, 640, -5000, 200 * 128},
                         Vertex{640, 1920, -5000, 200 * 128}};
    screen.draw(back);
    screen.draw(front);
    EXPECT_EQ(screen.grey(12, 12), 200);
    EXPECT_EQ(screen.grey(2, 2), 100);
    screen.clear();
    screen.draw(front);
    screen.draw(back);
    EXPECT_EQ(screen.grey(12, 12), 200);
    EXPECT_EQ(screen.grey(2, 2), 100);
}

}  // namespace
}  // namespace rasterloom::test
