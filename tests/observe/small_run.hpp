// SPDX-License-Identifier: MIT
// A made-up run of three nodes, for the writers' tests.
#pragma once

#include "machine/observe/run_report.hpp"

namespace rasterloom::observe {

inline Time at_us(std::int64_t us) {
    return Time::zero() + Duration::microseconds(us);
}

inline RunReport small_run() {
    RunReport report{.machine = "three",
                     .clock = Clock::with_period(Duration::microseconds(5)),
                     .end = at_us(1000),
                     .frames = 1,
                     .frame_ends = {at_us(1000)},
                     .phases = {},
                     .nodes = {},
                     .links = {},
                     .fabric = {},
                     .array = {},
                     .buckets = {},
                     .paths = {},
                     .phase_names = {"rotate"},
                     .activity_names = {"", "route"},
                     .events = 17};
    report.phases.push_back({.frame = 0,
                             .phase = 0,
                             .start = at_us(0),
                             .end = at_us(400),
                             .messages = 3,
                             .bytes = 60,
                             .longest_route = 2,
                             .rounds = RoundsReport{2, {2, 1}}});
    report.phases.push_back({.frame = 0,
                             .phase = 1,
                             .start = at_us(400),
                             .end = at_us(1000),
                             .messages = 0,
                             .bytes = 0,
                             .longest_route = 0,
                             .rounds = RoundsReport{}});
    for (int i = 0; i < 3; ++i) {
        NodeReport node;
        node.name = i == 1 ? "odd, \"name\"" : "node";
        node.statistics.phases.resize(2);
        node.statistics.phases[0].in_state[0] = Duration::microseconds(100 * (i + 1));
        node.statistics.phases[0].instructions = 10;
        node.statistics.phases[1].in_state[1] = Duration::microseconds(50);
        node.statistics.busy_with[1] = Duration::microseconds(100 * (i + 1));
        node.statistics.instructions = 10;
        node.statistics.cycles = 20;
        report.nodes.push_back(node);
    }
    report.links.push_back({.from = 0,
                            .to = 1,
                            .port = 0,
                            .messages = 3,
                            .bytes = 60,
                            .busy = Duration::microseconds(250),
                            .blocked = Duration::microseconds(7),
                            .peak_output_queue = 2,
                            .peak_input_queue = 1});
    report.links.emplace_back();
    report.links.back().from = 1;
    return report;
}

}  // namespace rasterloom::observe
