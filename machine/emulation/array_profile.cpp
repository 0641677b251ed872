// SPDX-License-Identifier: MIT
#include "machine/emulation/array_profile.hpp"

#include "machine/fabric/lockstep_error.hpp"
#include "machine/observe/figures.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace rasterloom::emulation {

namespace {

using isa::vliw::Bundle;
using isa::vliw::CommOp;
using isa::vliw::SeqOp;
using observe::ArrayReport;

// Seen from the program's folder: the same on every machine.
std::string file_of(const isa::Image& image, const isa::SourceLocation& source) {
    return std::filesystem::path(source.file)
        .lexically_proximate(std::filesystem::path(image.name).parent_path())
        .generic_string();
}

// Where procedures begin: what is called or can be, and bundle 0.
std::set<std::size_t> procedure_starts(const std::vector<Bundle>& bundles) {
    std::set<std::size_t> starts{0};
    for (const Bundle& bundle : bundles) {
        if (bundle.seq.op == SeqOp::call || bundle.seq.op == SeqOp::setp) {
            starts.insert(bundle.seq.target);
        }
    }
    return starts;
}

// Of all frames.
std::vector<std::int64_t> whole_profile(const LockstepMachine& lockstep) {
    std::vector<std::int64_t> sum(lockstep.settings().program->bundles.size());
    for (const std::vector<std::int64_t>& frame : lockstep.statistics().frames) {
        for (std::size_t bundle = 0; bundle < sum.size(); ++bundle) {
            sum[bundle] += frame[bundle];
        }
    }
    return sum;
}

void count(observe::BundleCounts& counts, const Bundle& bundle, std::int64_t times) {
    counts.cycles += times * cycles_of(bundle);
    counts.bundles += times;
    counts.operations += times * operations_in(bundle);
}

std::vector<ArrayReport::Procedure> procedures(const isa::Image& image,
                                               const std::vector<Bundle>& bundles,
                                               const std::vector<std::int64_t>& profile) {
    const std::set<std::size_t> starts = procedure_starts(bundles);
    std::vector<ArrayReport::Procedure> found;
    for (auto start = starts.begin(); start != starts.end() && *start < bundles.size(); ++start) {
        const std::size_t end = std::next(start) == starts.end()
                                    ? bundles.size()
                                    : std::min(*std::next(start), bundles.size());
        ArrayReport::Procedure procedure;
        for (std::size_t at = *start; at < end; ++at) {
            count(procedure.counts, bundles[at], profile[at]);
        }
        if (procedure.counts.bundles == 0) {
            continue;
        }
        procedure.calls = profile[*start];
        procedure.name = label_before(image, static_cast<std::uint32_t>(*start));
        if (const auto* source = image.source_of(static_cast<std::uint32_t>(*start))) {
            procedure.file = file_of(image, *source);
            procedure.line = source->line;
        }
        found.push_back(std::move(procedure));
    }
    return found;
}

}  // namespace

ArrayReport gather_array(const Blueprint& blueprint, const LockstepMachine& lockstep) {
    const LockstepMachine::Settings& settings = lockstep.settings();
    const LockstepStatistics& statistics = lockstep.statistics();
    const std::vector<Bundle>& bundles = settings.program->bundles;
    const std::vector<std::int64_t> profile = whole_profile(lockstep);
    ArrayReport report;
    report.lanes = lockstep.array().lanes();
    report.line_locked = settings.line_locked;
    report.line = settings.line_locked ? settings.line : 0;
    report.scanlines = statistics.scanlines;
    report.idle_cycles = statistics.idle_cycles;
    for (std::size_t phase = 0; phase < statistics.phases.size(); ++phase) {
        const LockstepStatistics::Phase& part = statistics.phases[phase];
        const std::int64_t all = part.cycles * report.lanes;
        report.phases.push_back(
            {static_cast<std::int64_t>(phase),
             {part.cycles, part.bundles, part.operations},
             all > 0 ? static_cast<double>(part.lane_cycles) / static_cast<double>(all) : 0});
    }
    for (std::size_t at = 0; at < bundles.size(); ++at) {
        const Bundle::Communication& comm = bundles[at].comm;
        if (comm.op == CommOp::right || comm.op == CommOp::left) {
            report.shifts += profile[at];
            report.places += profile[at] * comm.count;
        }
    }
    report.procedures = procedures(*blueprint.image, bundles, profile);
    return report;
}

std::vector<std::vector<observe::PathReport::LineShare>> lines_of_frames(
    const Blueprint& blueprint, const LockstepMachine& lockstep) {
    using Line = observe::PathReport::LineShare;
    const std::vector<Bundle>& bundles = lockstep.settings().program->bundles;
    std::vector<std::vector<Line>> frames;
    for (const std::vector<std::int64_t>& profile : lockstep.statistics().frames) {
        std::map<std::pair<std::string, int>, observe::BundleCounts> lines;
        for (std::size_t at = 0; at < bundles.size(); ++at) {
            const auto* source = blueprint.image->source_of(static_cast<std::uint32_t>(at));
            if (source != nullptr && profile[at] > 0) {
                count(lines[{file_of(*blueprint.image, *source), source->line}], bundles[at],
                      profile[at]);
            }
        }
        std::vector<Line> shares;
        for (const auto& [place, counts] : lines) {
            const Time time = lockstep.settings().clock.edge(Cycles(counts.cycles));
            shares.push_back({place.first, place.second, counts.bundles, time.since_start()});
        }
        std::stable_sort(shares.begin(), shares.end(),
                         [](const Line& a, const Line& b) { return a.time > b.time; });
        frames.push_back(std::move(shares));
    }
    return frames;
}

}  // namespace rasterloom::emulation
