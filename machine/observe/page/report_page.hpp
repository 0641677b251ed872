// SPDX-License-Identifier: MIT
// report.html: a run for a person to look at, as one file that needs nothing else. The page itself
// (machine/report/) is part of the program; the run is put into it as JSON.
#pragma once

#include "machine/host/picture.hpp"
#include "machine/observe/page/machine_drawing.hpp"
#include "machine/observe/page/run_timeline.hpp"
#include "machine/observe/run_report.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::observe {

// Everything that a page shows of a run.
struct PageContent {
    const RunReport& report;
    const RunTimeline& timeline;
    const MachineDrawing& drawing;
    const std::vector<host::Picture>& pictures;
};

// The page without a run; none when the program was built without it (RASTERLOOM_REPORT).
std::optional<std::string> page_template();

// What the page reads (docs/report.md). Numbers are those of the other files: statistics.json as it
// is, nodes.csv, links.csv and fabric.csv packed.
std::string page_json(const PageContent& content);

// Throws std::logic_error without a template.
std::string report_page(const PageContent& content);

}  // namespace rasterloom::observe
