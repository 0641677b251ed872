// SPDX-License-Identifier: MIT
#include "machine/host/shuttle.hpp"

#include "machine/host/scene_solids.hpp"
#include "topologies/angles.hpp"

#include <array>
#include <vector>

#include <glm/vec2.hpp>

namespace rasterloom::host {
namespace {

// The fuselage's cross-section, (y, z) in half widths, counter-clockwise as seen from behind, from
// the right lower corner: flat belly, upright sides, round back. All cross-sections are this one,
// larger or smaller, so that the faces between two of them are flat.
constexpr std::array<glm::dvec2, 12> kSection{{{0.8, -1.0},
                                               {1.0, -0.8},
                                               {1.0, 0.1},
                                               {0.92, 0.42},
                                               {0.68, 0.75},
                                               {0.3, 0.95},
                                               {-0.3, 0.95},
                                               {-0.68, 0.75},
                                               {-0.92, 0.42},
                                               {-1.0, 0.1},
                                               {-1.0, -0.8},
                                               {-0.8, -1.0}}};
constexpr std::size_t kFirstDoorEdge = 2;  // from the right sill
constexpr std::size_t kTopEdge = 5;
constexpr std::size_t kLastDoorEdge = 8;  // to the left one
constexpr std::size_t kBellyEdge = 11;

constexpr double kHalfWidth = 2.7;
constexpr double kBelly = 2.6;  // height over the ground
constexpr double kAxis = kBelly + kHalfWidth;
constexpr double kSill = kAxis + 0.1 * kHalfWidth;
constexpr double kBayFront = -9.0;
constexpr double kBayBack = 9.0;
constexpr double kBase = 15.0;  // where the engines are mounted

Ring section(double x, double half_width, double axis) {
    Ring ring;
    for (const auto& point : kSection)
        ring.emplace_back(x, half_width * point.x, axis + half_width * point.y);
    return ring;
}

// The bay's cross-section, in half widths as above, open upwards.
constexpr std::array<glm::dvec2, 6> kTrough{
    {{0.55, -0.85}, {0.9, -0.45}, {0.9, 0.1}, {-0.9, 0.1}, {-0.9, -0.45}, {-0.55, -0.85}}};
constexpr std::size_t kOpenEdge = 2;
constexpr int kBayLengths = 5;

Ring trough(double x) {
    Ring ring;
    for (const auto& point : kTrough)
        ring.emplace_back(x, kHalfWidth * point.x, kAxis + kHalfWidth * point.y);
    return ring;
}

class Shuttle {
  public:
    explicit Shuttle(ShuttleParts parts) : whole_(parts == ShuttleParts::whole) {}

    Mesh make() {
        add_nose_and_cabin();
        add_midbody();
        add_bay();
        add_bay_walls();
        add_payload();
        add_doors();
        add_aft();
        if (whole_) {
            add_body_flap();
            add_engines();
        }
        add_pods();
        if (whole_)
            add_wings();
        add_fin();
        if (whole_)
            add_gear();
        return builder_.take();
    }

  private:
    void add_nose_and_cabin();
    void add_midbody();
    void add_bay();
    void add_bay_walls();
    void add_payload();
    void add_doors();
    void add_aft();
    void add_body_flap();
    void add_bell(const glm::dvec3& throat, double length, double throat_radius, double exit_radius,
                  int sides);
    void add_engines();
    void add_pods();
    void add_wings();
    void add_fin();
    void add_gear();

    bool whole_;
    SolidBuilder builder_{"shuttle"};
    std::uint32_t white_ = builder_.surface("white");
    std::uint32_t black_ = builder_.surface("black");
    std::uint32_t grey_ = builder_.surface("grey");
    std::uint32_t dark_ = builder_.surface("dark");
    std::uint32_t radiator_ = builder_.surface("radiator");
    std::uint32_t bay_ = builder_.surface("bay");
    std::uint32_t payload_ = builder_.surface("payload");
    std::uint32_t glass_ = builder_.surface("glass");
    std::uint32_t metal_ = builder_.surface("metal");
};

void Shuttle::add_nose_and_cabin() {
    const std::array<Ring, 7> rings{
        section(-18.0, 0.0, kBelly + 1.5),    section(-17.5, 0.7, kBelly + 1.5),
        section(-15.8, 1.4, kBelly + 1.72),   section(-13.6, 1.95, kBelly + 2.05),
        section(-12.5, 2.42, kBelly + 2.45),  section(-11.2, kHalfWidth, kAxis),
        section(kBayFront, kHalfWidth, kAxis)};
    constexpr std::size_t kWindowBand = 3;
    builder_.add_loft(rings, [this](std::size_t band, std::size_t edge) {
        if (band == 0)
            return grey_;
        if (edge == kBellyEdge || edge == 0 || edge == kBellyEdge - 1)
            return black_;
        if (band == kWindowBand && edge > kFirstDoorEdge && edge < kLastDoorEdge)
            return glass_;
        return white_;
    });
}

void Shuttle::add_midbody() {
    constexpr int kLengths = 3;
    std::vector<Ring> rings;
    for (int i = 0; i <= kLengths; ++i) {
        rings.push_back(
            section(kBayFront + (kBayBack - kBayFront) * i / kLengths, kHalfWidth, kAxis));
    }
    for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
        const auto& a = rings[k];
        const auto& b = rings[k + 1];
        for (std::size_t i = 0; i < a.size(); ++i) {
            if (i >= kFirstDoorEdge && i <= kLastDoorEdge)
                continue;
            const std::size_t next = (i + 1) % a.size();
            const bool side = i == 1 || i == kLastDoorEdge + 1;
            builder_.add_face({a[i], a[next], b[next], b[i]}, side ? white_ : black_);
        }
    }
}

// The trough, seen from inside, and its rims on the sills.
void Shuttle::add_bay() {
    for (int k = 0; k < kBayLengths; ++k) {
        const double from = kBayFront + (kBayBack - kBayFront) * k / kBayLengths;
        const double to = kBayFront + (kBayBack - kBayFront) * (k + 1) / kBayLengths;
        const Ring a = trough(from);
        const Ring b = trough(to);
        for (std::size_t i = 0; i < a.size(); ++i) {
            const std::size_t next = (i + 1) % a.size();
            if (i != kOpenEdge)
                builder_.add_face({a[next], a[i], b[i], b[next]}, bay_);
        }
        const std::size_t first = builder_.polygon_count();
        const double outer = kHalfWidth;
        const double inner = 0.9 * kHalfWidth;
        builder_.add_face(
            {{from, inner, kSill}, {to, inner, kSill}, {to, outer, kSill}, {from, outer, kSill}},
            grey_);
        builder_.mirror_since(first);
    }
}

// Before and behind the bay, in two parts: above the sills and below them.
void Shuttle::add_bay_walls() {
    const auto upper = [](double x) {
        const Ring whole = section(x, kHalfWidth, kAxis);
        return Ring(whole.begin() + kFirstDoorEdge, whole.begin() + kLastDoorEdge + 2);
    };
    builder_.add_face(upper(kBayFront), grey_);
    builder_.add_face(trough(kBayFront), grey_);
    builder_.add_back(upper(kBayBack), grey_);
    Ring lower = trough(kBayBack);
    if (!whole_) {
        // Seen from near by, a crack would open between the parts, whose corners differ and are
        // rounded to pixels: the lower one reaches over the upper one, in one plane and grey.
        constexpr double kOverlap = 0.05;
        lower[kOpenEdge].z += kOverlap;
        lower[kOpenEdge + 1].z += kOverlap;
    }
    builder_.add_back(lower, grey_);
}

// A satellite: a drum on a cradle.
void Shuttle::add_payload() {
    constexpr int kSides = 8;
    const std::array<Ring, 3> drum{ring_about_x({1.0, 0, kAxis}, 1.1, kSides),
                                   ring_about_x({4.8, 0, kAxis}, 1.1, kSides),
                                   ring_about_x({5.7, 0, kAxis}, 0.6, kSides)};
    builder_.add_solid(drum, payload_);
    builder_.add_box({1.8, -2.2, kAxis - 1.5}, {2.4, 2.2, kAxis - 0.2}, metal_);
}

// Each door is the upper skin turned outwards about its sill; radiators inside. Seen from near by,
// it has the sill's corners along the hinge: between others, rounded to pixels, cracks would open.
void Shuttle::add_doors() {
    const int lengths = whole_ ? 3 : kBayLengths;
    constexpr double kOpening = 140;  // degrees
    const double c = topology::cos_degrees(kOpening);
    const double s = topology::sin_degrees(kOpening);
    std::vector<glm::dvec2> profile(kSection.begin() + kFirstDoorEdge,
                                    kSection.begin() + kTopEdge + 1);
    profile.emplace_back(0.0, 0.95);
    const glm::dvec2 hinge = profile.front();
    for (auto& point : profile) {
        const glm::dvec2 arm = point - hinge;
        point = hinge + glm::dvec2(c * arm.x + s * arm.y, c * arm.y - s * arm.x);
    }
    const std::size_t first = builder_.polygon_count();
    for (int k = 0; k < lengths; ++k) {
        const double from = kBayFront + (kBayBack - kBayFront) * k / lengths;
        const double to = kBayFront + (kBayBack - kBayFront) * (k + 1) / lengths;
        for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
            const auto at = [&](double x, const glm::dvec2& point) {
                return glm::dvec3(x, kHalfWidth * point.x, kAxis + kHalfWidth * point.y);
            };
            const Ring outside{at(from, profile[i]), at(from, profile[i + 1]),
                               at(to, profile[i + 1]), at(to, profile[i])};
            builder_.add_face(outside, white_);
            builder_.add_back(outside, radiator_);
        }
    }
    builder_.mirror_since(first);
}

void Shuttle::add_aft() {
    const std::array<Ring, 3> rings{section(kBayBack, kHalfWidth, kAxis),
                                    section(12.5, kHalfWidth, kAxis),
                                    section(kBase, 2.5, kAxis - 0.1)};
    builder_.add_loft(rings, [this](std::size_t, std::size_t edge) {
        return edge == kBellyEdge || edge == 0 || edge == kBellyEdge - 1 ? black_ : white_;
    });
    // Twelve corners are more than the tilers take: the base is two faces, above and below.
    const Ring& base = rings.back();
    builder_.add_face({base[11], base[0], base[1], base[2], base[9], base[10]}, black_);
    builder_.add_face(Ring(base.begin() + 2, base.begin() + 10), black_);
}

void Shuttle::add_body_flap() {
    builder_.add_box({14.6, -2.2, kBelly - 0.1}, {17.2, 2.2, kBelly + 0.35}, black_);
}

// Outside, inside, and the throat's bottom.
void Shuttle::add_bell(const glm::dvec3& throat, double length, double throat_radius,
                       double exit_radius, int sides) {
    const glm::dvec3 exit = throat + glm::dvec3(length, 0, 0);
    const std::array<Ring, 2> rings{ring_about_x(throat, throat_radius, sides),
                                    ring_about_x(exit, exit_radius, sides)};
    builder_.add_loft(rings, metal_);
    for (std::size_t i = 0; i < rings[0].size(); ++i) {
        const std::size_t next = (i + 1) % rings[0].size();
        builder_.add_face({rings[1][i], rings[1][next], rings[0][next], rings[0][i]}, dark_);
    }
    builder_.add_face(rings[0], dark_);
}

void Shuttle::add_engines() {
    constexpr int kSides = 8;
    for (const auto& place : {glm::dvec2(0, kAxis + 1.35), glm::dvec2(-1.35, kAxis - 0.8),
                              glm::dvec2(1.35, kAxis - 0.8)})
        add_bell({kBase - 0.3, place.x, place.y}, 2.7, 0.45, 1.15, kSides);
}

void Shuttle::add_pods() {
    constexpr int kSides = 8;
    constexpr int kNozzleSides = 6;
    const std::size_t first = builder_.polygon_count();
    const std::array<Ring, 4> pod{ring_about_x({8.2, 1.7, kAxis + 1.5}, 0, kSides),
                                  ring_about_x({10.2, 1.85, kAxis + 1.75}, 1.0, kSides),
                                  ring_about_x({13.6, 1.95, kAxis + 1.9}, 1.25, kSides),
                                  ring_about_x({15.4, 1.95, kAxis + 1.9}, 1.1, kSides)};
    builder_.add_loft(pod, white_);
    builder_.add_face(pod.back(), black_);
    if (whole_)
        add_bell({15.3, 2.0, kAxis + 1.9}, 1.1, 0.3, 0.65, kNozzleSides);
    builder_.mirror_since(first);
}

// A double delta: sections across the span of a flat-bottomed aerofoil.
void Shuttle::add_wings() {
    struct Station {
        double y, leading, trailing, bottom, thickness;
    };
    constexpr std::array<Station, 4> kStations{{{2.6, -7.0, 13.6, 2.75, 1.6},
                                                {4.6, 0.5, 13.6, 2.85, 1.35},
                                                {8.2, 4.6, 13.0, 3.1, 0.9},
                                                {11.9, 8.8, 12.4, 3.35, 0.35}}};
    std::vector<Ring> rings;
    for (const auto& at : kStations) {
        const double chord = at.trailing - at.leading;
        rings.push_back({{at.leading, at.y, at.bottom + 0.35 * at.thickness},
                         {at.leading + 0.3 * chord, at.y, at.bottom + at.thickness},
                         {at.trailing, at.y, at.bottom + 0.2 * at.thickness},
                         {at.leading + 0.3 * chord, at.y, at.bottom}});
    }
    const std::size_t first = builder_.polygon_count();
    builder_.add_back(rings.front(), white_);
    builder_.add_loft(rings,
                      [this](std::size_t, std::size_t edge) { return edge < 2 ? white_ : black_; });
    builder_.add_face(rings.back(), white_);
    builder_.mirror_since(first);
}

void Shuttle::add_fin() {
    struct Station {
        double z, leading, trailing;
    };
    constexpr std::array<Station, 4> kStations{{{kAxis + 2.2, 8.6, 16.2},
                                                {kAxis + 3.6, 10.6, 16.6},
                                                {13.0, 13.7, 17.7},
                                                {17.0, 16.4, 19.0}}};
    std::vector<Ring> rings;
    for (const auto& at : kStations) {
        const double chord = at.trailing - at.leading;
        const double half = 0.07 * chord;
        rings.push_back({{at.leading, 0, at.z},
                         {at.leading + 0.55 * chord, -half, at.z},
                         {at.trailing, 0, at.z},
                         {at.leading + 0.55 * chord, half, at.z}});
    }
    builder_.add_solid(rings, white_);
}

void Shuttle::add_gear() {
    constexpr int kSides = 6;
    const auto wheel = [&](const glm::dvec3& centre, double radius, double width) {
        std::array<Ring, 2> rings;
        for (int side = 0; side < 2; ++side) {
            const Ring flat = ring_about_x({0, 0, 0}, radius, kSides);
            for (const auto& point : flat)
                rings[static_cast<std::size_t>(side)].emplace_back(
                    centre.x - point.y, centre.y + (side - 0.5) * width, centre.z + point.z);
        }
        builder_.add_solid(rings, dark_);
    };
    builder_.add_box({-13.3, -0.2, 0.6}, {-12.9, 0.2, kBelly + 0.5}, metal_);
    wheel({-13.1, 0, 0.5}, 0.5, 0.9);
    const std::size_t first = builder_.polygon_count();
    builder_.add_box({6.8, 3.3, 0.7}, {7.3, 3.8, kBelly + 0.6}, metal_);
    wheel({7.05, 3.55, 0.6}, 0.6, 1.0);
    builder_.mirror_since(first);
}

}  // namespace

Mesh make_shuttle(ShuttleParts parts) {
    return Shuttle(parts).make();
}

}  // namespace rasterloom::host
