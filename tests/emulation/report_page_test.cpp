// SPDX-License-Identifier: MIT
// What a whole run tells its report: the same as its statistics, on any number of threads.
#include "machine/observe/page/report_page.hpp"

#include "machine/emulation/run.hpp"
#include "tests/emulation/bucket_machines.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rasterloom::emulation {
namespace {

using observe::MachineDrawing;
using observe::TimelineSeries;

RunOutcome run(config::MachineDescription description, std::int64_t threads = 1) {
    description.run.threads = threads;
    RunOptions options;
    options.page = true;
    RunOutcome outcome = run_machine(description, options);
    EXPECT_EQ(outcome.failure, "");
    return outcome;
}

const TimelineSeries& series(const RunOutcome& outcome, TimelineSeries::Of of,
                             const std::string& name) {
    for (const TimelineSeries& each : outcome.timeline->series()) {
        if (each.of == of && each.name == name) {
            return each;
        }
    }
    throw std::invalid_argument(name);
}

void expect_states_add_up(const RunOutcome& outcome) {
    const observe::Timeline& bins = outcome.timeline->bins();
    const std::size_t first = series(outcome, TimelineSeries::Of::node, "busy").first_track;
    const auto& nodes = outcome.report.nodes;
    for (std::size_t state = 0; state < kNodeStates; ++state) {
        for (std::size_t node = 0; node < nodes.size(); ++node) {
            EXPECT_EQ(bins.total(first + state * nodes.size() + node),
                      nodes[node].statistics.in_state(static_cast<NodeState>(state)).picoseconds())
                << nodes[node].name << ", state " << state;
        }
    }
    EXPECT_LE(bins.end(), outcome.report.end);
}

void expect_links_add_up(const RunOutcome& outcome) {
    const observe::Timeline& bins = outcome.timeline->bins();
    const std::size_t first = series(outcome, TimelineSeries::Of::link, "busy").first_track;
    for (std::size_t link = 0; link < outcome.report.links.size(); ++link) {
        EXPECT_EQ(bins.total(first + link), outcome.report.links[link].busy.picoseconds()) << link;
    }
}

// A frame-buffer bus is told to block whom it serves: it blocks on nothing itself.
void expect_parts_add_up(const RunOutcome& outcome) {
    const observe::Timeline& bins = outcome.timeline->bins();
    const std::size_t busy = series(outcome, TimelineSeries::Of::part, "busy").first_track;
    const std::size_t blocked = series(outcome, TimelineSeries::Of::part, "blocked").first_track;
    const std::size_t input = series(outcome, TimelineSeries::Of::part, "input_fifo").first_track;
    const double whole = static_cast<double>(outcome.report.end.picoseconds());
    for (std::size_t i = 0; i < outcome.report.fabric.size(); ++i) {
        const observe::FabricPartReport& part = outcome.report.fabric[i];
        EXPECT_EQ(bins.total(busy + i), part.busy.picoseconds()) << part.name;
        if (part.part != observe::FabricPart::frame_buffer_bus) {
            EXPECT_EQ(bins.total(blocked + i), part.blocked.picoseconds()) << part.name;
        }
        if (part.part != observe::FabricPart::turn_bus) {
            EXPECT_NEAR(static_cast<double>(bins.total(input + i)) / whole, part.input.mean, 1e-9)
                << part.name;
        }
    }
}

TEST(ReportOfARun, AddsUpToItsStatistics) {
    for (const auto& description :
         {small_geodesic(), shipped("ring.yaml"), shipped("bare-pdp11.yaml"),
          shipped("splitter4.yaml"), shipped("hybrid16.yaml", {"fabric.half_digested=true"}),
          shipped("interlace4.yaml", {"fabric.frame_buffer=bus"}),
          small_bucket(kHardware, {"topology.rasterizers=3", "sorter.time_per_pair=1us",
                                   "sorter.assignment=next_free", "run.frames=2"}),
          small_bucket(kHardware, {"rasterizer.cycles_per_triangle=0"}),
          small_bucket(kSoftware,
                       {"topology.rasterizers=3", "sorter.time_per_word=1us", "run.frames=2"})}) {
        SCOPED_TRACE(description.machine);
        const RunOutcome outcome = run(description);
        expect_states_add_up(outcome);
        if (!outcome.report.links.empty()) {
            expect_links_add_up(outcome);
        }
        if (!outcome.report.fabric.empty()) {
            expect_parts_add_up(outcome);
        }
        EXPECT_EQ(outcome.report.paths.size(), outcome.report.frame_ends.size());
    }
}

TEST(ReportOfARun, IsTheSameOnAnyNumberOfThreads) {
    for (const auto& description :
         {small_geodesic({"run.frames=2"}), shipped("splitter16.yaml"), shipped("edge-list.yaml"),
          small_bucket(kHardware, {"topology.rasterizers=3"}),
          small_bucket(kSoftware, {"topology.rasterizers=3"})}) {
        std::string first;
        for (std::int64_t threads = 1; threads <= 4; ++threads) {
            const RunOutcome outcome = run(description, threads);
            const std::string json = observe::page_json(
                {outcome.report, *outcome.timeline, outcome.drawing, outcome.pictures});
            first = threads == 1 ? json : first;
            EXPECT_TRUE(json == first) << description.machine << ", " << threads << " threads";
        }
    }
}

TEST(ReportOfARun, DrawsASphereWhereTheTopologyEnclosesOne) {
    const MachineDrawing drawing = run(small_geodesic()).drawing;
    EXPECT_EQ(drawing.layout, MachineDrawing::Layout::sphere);
    EXPECT_EQ(drawing.positions.size(), 72U);
    EXPECT_EQ(drawing.triangles.size(), 140U);
    EXPECT_EQ(drawing.owners.size(), 64U * 64U);
}

TEST(ReportOfARun, DrawsOtherGraphsInAPlane) {
    const MachineDrawing ring = run(shipped("ring.yaml")).drawing;
    EXPECT_EQ(ring.layout, MachineDrawing::Layout::plane);
    ASSERT_EQ(ring.positions.size(), 16U);
    for (const topology::Vec3& at : ring.positions) {
        EXPECT_NEAR(at.x * at.x + at.y * at.y, 1, 1e-9);
    }
    const MachineDrawing grid =
        run(shipped("edge-list.yaml", {"topology={kind: grid, width: 4, height: 2}"})).drawing;
    // Square cells, from left to right and then downwards.
    EXPECT_DOUBLE_EQ(grid.positions[1].x - grid.positions[0].x,
                     grid.positions[0].y - grid.positions[4].y);
    EXPECT_LT(grid.positions[0].x, grid.positions[1].x);
}

// Every pixel of the screen is under exactly one cell, whose node owns as many.
void expect_cells_fill(const MachineDrawing& drawing) {
    double area = 0;
    for (std::size_t node = 0; node < drawing.cells.size(); ++node) {
        const MachineDrawing::Cell& cell = drawing.cells[node];
        const topology::PixelGrid& grid = drawing.grids[node];
        EXPECT_EQ(cell.width * cell.height, grid.columns * grid.rows);
        EXPECT_GE(cell.x, 0);
        EXPECT_GE(cell.y, 0);
        EXPECT_LE(cell.x + cell.width, drawing.width);
        EXPECT_LE(cell.y + cell.height, drawing.height);
        for (std::size_t other = 0; other < node; ++other) {
            const MachineDrawing::Cell& before = drawing.cells[other];
            EXPECT_TRUE(before.x + before.width <= cell.x || cell.x + cell.width <= before.x ||
                        before.y + before.height <= cell.y || cell.y + cell.height <= before.y);
        }
        area += cell.width * cell.height;
    }
    EXPECT_EQ(area, drawing.width * drawing.height);
}

TEST(ReportOfARun, DrawsSharesOfTheScreenAndWhatFeedsThem) {
    for (const char* name : {"splitter16.yaml", "interlace16.yaml", "hybrid16.yaml",
                             "hybrid64.yaml", "uniprocessor.yaml"}) {
        SCOPED_TRACE(name);
        const RunOutcome outcome = run(shipped(name));
        const MachineDrawing& drawing = outcome.drawing;
        EXPECT_EQ(drawing.layout, MachineDrawing::Layout::screen);
        expect_cells_fill(drawing);
        ASSERT_EQ(drawing.parts.size(), outcome.report.fabric.size());
        for (std::size_t part = 0; part < drawing.parts.size(); ++part) {
            EXPECT_EQ(drawing.parts[part].parent.has_value(), part != 0) << part;
        }
        for (const auto& feeder : drawing.fed_by) {
            EXPECT_TRUE(feeder.has_value());
        }
    }
}

// A pixel belongs to who has drawn its tile last.
TEST(ReportOfARun, DrawsTheTilesOfABucketTiler) {
    for (const std::string& kind : {kHardware, kSoftware}) {
        const RunOutcome outcome =
            run(small_bucket(kind, {"topology={kind: bucket_tiles, tile: 16x8, rasterizers: 3}"}));
        const MachineDrawing& drawing = outcome.drawing;
        EXPECT_EQ(drawing.width, kSmallWidth);
        ASSERT_EQ(drawing.owners.size(), std::size_t{kSmallWidth} * kSmallHeight);
        // By turns, one further for each row.
        for (std::size_t y = 0; y < kSmallHeight; ++y)
            for (std::size_t x = 0; x < kSmallWidth; ++x)
                ASSERT_EQ(drawing.owners[y * kSmallWidth + x], (x / 16 + y / 8) % 3) << kind;
        EXPECT_EQ(drawing.parts.size(), outcome.report.fabric.size());
    }
}

}  // namespace
}  // namespace rasterloom::emulation
