// SPDX-License-Identifier: MIT
// The checks find what has been planted in lanes' memories, and nothing where nothing has.
#include "machine/emulation/princeton_check.hpp"

#include "machine/host/projection.hpp"
#include "machine/host/teapot.hpp"
#include "tests/emulation/princeton_lanes.hpp"

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;

constexpr std::int64_t kLanes = 128;
constexpr std::int64_t kMostCycles = 5'000'000;
constexpr std::uint32_t kUnused = 0x7fa0;  // behind everything that the scene needs

// The machine as it stands when one of its phases has ended.
class AtEndOf {
  public:
    AtEndOf(const char* phase, const std::string& program, const std::string& options = {})
        : lanes_(kLanes, "screen_columns = 96\nscreen_rows = 64\n" + options +
                             "\n        .include \"" + program + "\"\n"),
          check_(lanes_.image(), lanes_.columns()) {
        const host::TriangleScene scene =
            make_triangle_scene(host::make_teapot({.around = 16, .along = 8}), {});
        host::TriangleView view = program_view(lanes_.image());
        host::View turn;
        turn.degrees = 20;
        view.matrix = host::eye_matrix(host::rotation_of(turn),
                                       {0, 0, host::fitting_distance(scene, turn.axis, view)});
        lanes_.load(scene, view, host::make_lights());
        run_to_end_of(static_cast<int>(lanes_.at(fmt::format("phase_name_{}", phase))));
    }

    std::uint32_t symbol(const char* name) const { return lanes_.at(name); }
    std::string said() { return check_.phase_ended(lanes_.array(), phase_, next_); }

    std::int64_t some_lane() {
        std::int64_t lane = 0;
        while (received(lane).empty())
            ++lane;
        return lane;
    }
    // A lane and the address of a polygon there that has few columns.
    std::pair<std::int64_t, std::uint32_t> narrow_one() {
        const std::uint32_t left = lanes_.at(has_homes() ? "h_left" : "d_left");
        for (std::int64_t lane = 0; lane < kLanes / 2; ++lane)
            for (const std::uint32_t address : received(lane)) {
                const auto box = words(lane, address);
                if (box[left] <= box[left + 1] && box[left + 1] < box[left] + 10)
                    return {lane, address};
            }
        throw std::runtime_error("no narrow polygon");
    }
    // Addresses of the records that a lane has.
    std::vector<std::uint32_t> received(std::int64_t lane) {
        std::vector<std::uint32_t> addresses;
        for (std::uint32_t at = begin(lane); at < lanes_.word(lane, end()); at += step())
            addresses.push_back(is_list() ? lanes_.array().read(lane, slow_word(0, 0) + at) : at);
        return addresses;
    }
    void drop_last(std::int64_t lane) { move_end(lane, -static_cast<int>(step())); }
    void append(std::int64_t lane, const std::vector<std::uint16_t>& words) {
        const std::uint32_t at = lanes_.word(lane, end());
        lanes_.array().write(lane, is_list() ? kUnused : at, words);
        if (is_list())
            lanes_.array().write(lane, slow_word(0, 0) + at, std::vector<std::uint16_t>{kUnused});
        move_end(lane, static_cast<int>(step()));
    }
    std::vector<std::uint16_t> words(std::int64_t lane, std::uint32_t address) {
        std::vector<std::uint16_t> words(lanes_.at(has_homes() ? "kHome" : "kDescriptor"));
        lanes_.array().read(lane, address, words);
        return words;
    }
    void set(std::int64_t lane, std::uint32_t address, std::uint16_t value) {
        lanes_.array().write(lane, address, std::vector<std::uint16_t>{value});
    }
    std::string said_before(const char* phase) {
        return check_.phase_ended(
            lanes_.array(), 0,
            static_cast<int>(symbol(fmt::format("phase_name_{}", phase).c_str())));
    }
    void spoil(std::int64_t lane, std::uint32_t address) {
        std::vector<std::uint16_t> changed = words(lane, address);
        changed.at(20) ^= 1;
        lanes_.array().write(lane, address, changed);
    }

  private:
    void run_to_end_of(int phase) {
        for (std::int64_t cycles = 0; cycles < kMostCycles;) {
            const LockstepArray::Stop stop = lanes_.array().run(kMostCycles - cycles);
            cycles += stop.cycles;
            if (stop.reason == LockstepArray::Reason::phase) {
                next_ = stop.phase;
                if (phase_ == phase && next_ != phase)
                    return;
                EXPECT_EQ(said(), "");
                phase_ = next_;
            }
        }
        throw std::runtime_error("the phase does not end");
    }
    bool has_homes() const { return lanes_.image().symbol("homes").has_value(); }
    bool is_migration() const {
        return phase_ == static_cast<int>(lanes_.at("phase_name_migrate"));
    }
    bool is_list() const {
        return lanes_.image().symbol("sort_first").value_or(0) != 0 ||
               lanes_.image().symbol("kRegion").has_value();
    }
    std::uint32_t step() const { return is_list() ? 1 : lanes_.at("kDescriptor"); }
    std::string end() const {
        return is_migration() ? "home_end" : is_list() ? "wanted_end" : "received_end";
    }
    std::uint32_t begin(std::int64_t lane) {
        return is_migration() ? lanes_.at("homes")
               : is_list()    ? lanes_.at("wanted")
                              : lanes_.word(lane, "received_at");
    }
    void move_end(std::int64_t lane, int by) {
        lanes_.array().write(
            lane, lanes_.at(end()),
            std::vector<std::uint16_t>{static_cast<std::uint16_t>(lanes_.word(lane, end()) + by)});
    }

    PrincetonLanes lanes_;
    CommunicationCheck check_;
    int phase_ = 0;
    int next_ = 0;
};

constexpr const char* kUnneeded = "what it does not need:";
constexpr const char* kRepeated = "once too often";

struct Communication {
    const char* phase;
    std::string program;
    std::string options;
    const char* what;
    const char* lacking;
    const char* misplaced;
};

void PrintTo(const Communication& communication, std::ostream* stream) {
    *stream << communication.program << ' ' << communication.options;
}

class PrincetonCheck : public testing::TestWithParam<Communication> {
  protected:
    static AtEndOf machine() { return {GetParam().phase, GetParam().program, GetParam().options}; }
};

TEST_P(PrincetonCheck, FindsNothingWhereNothingIsWrong) {
    EXPECT_EQ(machine().said(), "");
}

TEST_P(PrincetonCheck, FindsAPolygonThatIsNotWhereItIsNeeded) {
    AtEndOf at = machine();
    at.drop_last(at.some_lane());
    EXPECT_THAT(at.said(),
                MatchesRegex(fmt::format("{}: {} polygon [0-9]+ of lane [0-9]+, with the box "
                                         ".[0-9]+,[0-9]+. .-?[0-9]+,[0-9]+.",
                                         GetParam().what, GetParam().lacking)));
}

TEST_P(PrincetonCheck, FindsAPolygonThatIsTwiceWhereItIsNeeded) {
    AtEndOf at = machine();
    const std::int64_t lane = at.some_lane();
    at.append(lane, at.words(lane, at.received(lane).front()));
    EXPECT_THAT(at.said(), AllOf(StartsWith(fmt::format("{}: lane {} has once too often polygon ",
                                                        GetParam().what, lane)),
                                 Not(HasSubstr(";"))));
}

TEST_P(PrincetonCheck, FindsAPolygonThatNobodyHasSent) {
    AtEndOf at = machine();
    const std::int64_t lane = at.some_lane();
    at.spoil(lane, at.received(lane).front());
    EXPECT_THAT(at.said(),
                AllOf(HasSubstr(GetParam().what),
                      HasSubstr(fmt::format("; lane {} has what it does not need: a polygon that "
                                            "no lane has sent",
                                            lane))));
}

// A narrow one, far from where it was.
TEST_P(PrincetonCheck, FindsAPolygonWhereItIsNotNeeded) {
    AtEndOf at = machine();
    const auto [lane, address] = at.narrow_one();
    at.append(lane + 61, at.words(lane, address));
    EXPECT_THAT(at.said(), StartsWith(fmt::format("{}: lane {} has {} polygon ", GetParam().what,
                                                  lane + 61, GetParam().misplaced)));
}

TEST(PrincetonCheckOfMigration, FindsAPolygonThatIsNotInItsLeftColumn) {
    AtEndOf at("migrate", "sort_first.s");
    const std::uint32_t left = at.symbol("h_left");
    const auto is_in_place = [&](std::int64_t lane) {
        const auto homes = at.received(lane);
        return !homes.empty() && at.words(lane, homes.back()).at(left) == lane;
    };
    std::int64_t lane = 0;
    while (lane < kLanes && !is_in_place(lane))
        ++lane;
    ASSERT_LT(lane, kLanes);
    at.append(lane + 1, at.words(lane, at.received(lane).back()));
    at.drop_last(lane);
    EXPECT_THAT(at.said(),
                StartsWith(fmt::format("migration: lane {} has what it does not need: polygon ",
                                       lane + 1)));
}

TEST(PrincetonCheckOfMigration, RefusesAHomeInAColumnThatNoLaneHas) {
    AtEndOf at("migrate", "sort_first.s");
    const auto [lane, address] = at.narrow_one();
    at.set(lane, address + at.symbol("h_left"), 0xffff);
    EXPECT_EQ(at.said_before("migrate"),
              fmt::format("communication: lane {}: a visible polygon at address {:#x} begins in "
                          "column -1, expected 0 to {}",
                          lane, address, kLanes - 1));
}

INSTANTIATE_TEST_SUITE_P(
    All, PrincetonCheck,
    testing::Values(
        Communication{"communicate", "sort_middle.s", "", "communication", "lane [0-9]+ lacks",
                      kUnneeded},
        Communication{"communicate", "sort_middle.s", "stride = 8\nduplication = 4\ndense = 0\n",
                      "communication", "lane [0-9]+ lacks", kUnneeded},
        Communication{"communicate", "sort_twice.s", "group = 8\n", "communication",
                      "no lane of region [0-9]+ has", kUnneeded},
        Communication{"communicate", "sort_last.s", "", "communication", "no lane of region 0 has",
                      kRepeated},
        Communication{"communicate", "sort_first.s", "", "communication", "lane [0-9]+ lacks",
                      kUnneeded},
        Communication{"migrate", "sort_first.s", "", "migration", "no lane has", kRepeated}));

}  // namespace
}  // namespace rasterloom
