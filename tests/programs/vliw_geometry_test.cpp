// SPDX-License-Identifier: MIT
// The geometry stage in VLIW assembly against double precision.
#include "programs/vliw_geometry_expected.hpp"
#include "programs/vliw_geometry_run.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

// Random polygons, views and lights, the same on every machine.
class Source {
  public:
    explicit Source(unsigned seed) : engine_(seed) {}

    int whole(int least, int most) {
        return least + static_cast<int>(engine_() % static_cast<unsigned>(most - least + 1));
    }
    std::int16_t word(int least, int most) { return static_cast<std::int16_t>(whole(least, most)); }
    double real() { return whole(-1'000'000, 1'000'000) / 1e6; }

    std::array<double, 3> unit() {
        while (true) {
            const std::array v{real(), real(), real()};
            const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
            if (length > 0.1 && length <= 1) {
                return {v[0] / length, v[1] / length, v[2] / length};
            }
        }
    }
    std::array<std::int16_t, 3> unit_words() {
        std::array<std::int16_t, 3> words{};
        for (std::size_t k = 0; const double part : unit()) {
            words[k++] = static_cast<std::int16_t>(std::lround(part * 16384));
        }
        return words;
    }

    // A turn about a random axis by a random angle (Rodrigues), then away to distance z.
    VliwView view(int z) {
        const auto axis = unit();
        const double angle = real() * std::numbers::pi;
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        VliwView view;
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t column = 0; column < 3; ++column) {
                double element = axis[row] * axis[column] * (1 - c);
                if (row == column) {
                    element += c;
                } else {
                    const std::size_t third = 3 - row - column;
                    element += ((column + 3 - row) % 3 == 1 ? -s : s) * axis[third];
                }
                view.matrix[3 * row + column] =
                    static_cast<std::int16_t>(std::lround(element * 16384));
            }
        }
        view.matrix[9] = word(-z / 4, z / 4);
        view.matrix[10] = word(-z / 5, z / 5);
        view.matrix[11] = static_cast<std::int16_t>(z);
        return view;
    }

    VliwLights lights() {
        VliwLights lights;
        lights.ambient = whole(0, 60);
        lights.sun = unit_words();
        lights.sun_diffuse = whole(0, 255);
        lights.sun_specular = whole(0, 255);
        lights.lamp = {word(-9000, 9000), word(-9000, 9000), word(-3000, 3000)};
        lights.lamp_diffuse = whole(0, 255);
        lights.lamp_specular = whole(0, 255);
        lights.shininess = whole(0, 6);
        return lights;
    }

    // Vertices within `size` of a place within `reach` of the origin.
    VliwPolygon polygon(int reach, int size) {
        VliwPolygon result;
        const std::array place{whole(-reach, reach), whole(-reach, reach), whole(-reach, reach)};
        for (VliwVertex& vertex : result.vertices) {
            for (std::size_t k = 0; k < 3; ++k) {
                vertex.place[k] = static_cast<std::int16_t>(place[k] + whole(-size, size));
            }
            vertex.normal = unit_words();
            vertex.u = whole(0, 255);
            vertex.v = whole(0, 255);
        }
        for (std::uint16_t& colour : result.colour) {
            colour = static_cast<std::uint16_t>(whole(0, 65535));
        }
        return result;
    }

    // Any words at all.
    VliwPolygon garbage() {
        VliwPolygon result = polygon(0, 16384);
        for (VliwVertex& vertex : result.vertices) {
            for (std::size_t k = 0; k < 3; ++k) {
                vertex.place[k] = word(-32768, 32767);
                vertex.normal[k] = word(-32768, 32767);
            }
        }
        return result;
    }

  private:
    std::mt19937 engine_;
};

struct Tally {
    int visible = 0;
    int hidden = 0;
    int doubtful = 0;
};

// Every descriptor of the run is that of a polygon of the lane, in order, and none is missing.
Tally check(const VliwGeometryRun& run, const VliwView& view, const VliwLights& lights,
            const std::vector<VliwDatabase>& lanes, bool textured = true) {
    Tally tally;
    EXPECT_TRUE(run.reached_communication());
    for (int lane = 0; const VliwDatabase& polygons : lanes) {
        EXPECT_EQ(run.error(lane), 0);
        EXPECT_TRUE(run.kept_its_place(lane));
        const auto descriptors = run.descriptors(lane);
        auto next = descriptors.begin();
        for (std::size_t i = 0; i < polygons.size(); ++i) {
            const ExpectedPolygon expected(view, lights, polygons[i]);
            const Fate fate = expected.fate();
            std::string complaint = "it is hidden";
            if (fate != Fate::hidden && next != descriptors.end()) {
                complaint = expected.complaint(*next, textured);
            }
            if (complaint.empty()) {
                ++next;
            } else if (fate == Fate::visible) {
                if (next != descriptors.end())
                    for (auto w : *next)
                        fmt::print("{} ", (std::int16_t)w);
                ADD_FAILURE() << "lane " << lane << ", polygon " << i << ": " << complaint;
                return tally;
            }
            ++(fate == Fate::visible  ? tally.visible
               : fate == Fate::hidden ? tally.hidden
                                      : tally.doubtful);
        }
        EXPECT_EQ(next, descriptors.end()) << "lane " << lane;
        ++lane;
    }
    return tally;
}

std::vector<VliwDatabase> databases(Source& source, int reach, int size) {
    std::vector<VliwDatabase> lanes(5);
    for (VliwDatabase& lane : lanes) {
        lane.resize(static_cast<std::size_t>(source.whole(0, 40)));
        for (VliwPolygon& polygon : lane) {
            polygon = source.polygon(reach, size);
        }
    }
    return lanes;
}

TEST(VliwGeometry, DescribesTheVisiblePolygonsOfAnObject) {
    Tally sum;
    for (unsigned seed = 0; seed < 60; ++seed) {
        Source source(seed);
        const int z = source.whole(9000, 27000);
        const auto view = source.view(z);
        const auto lights = source.lights();
        const auto lanes = databases(source, 3000, 1 << source.whole(4, 11));
        const VliwGeometryRun run(view, lights, lanes);
        const Tally tally = check(run, view, lights, lanes);
        ASSERT_FALSE(HasFailure()) << "seed " << seed;
        sum.visible += tally.visible;
        sum.hidden += tally.hidden;
        sum.doubtful += tally.doubtful;
    }
    EXPECT_GT(sum.visible, 1000);
    EXPECT_GT(sum.hidden, 1000);
    EXPECT_LT(sum.doubtful, sum.visible / 10);
    fmt::print("{} {} {}\n", sum.visible, sum.hidden, sum.doubtful);
}

}  // namespace
}  // namespace rasterloom::test
