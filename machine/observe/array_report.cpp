// SPDX-License-Identifier: MIT
#include "machine/observe/array_report.hpp"

#include "machine/observe/csv_text.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace rasterloom::observe {

namespace {

constexpr std::size_t kShown = 12;  // procedures

double ratio(std::int64_t part, std::int64_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

void add_phases(std::string& text, const ArrayReport& array,
                const std::vector<std::string>& names) {
    const std::int64_t cycles = array.total().cycles;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "\n{:<24}{:>12}{:>8}{:>12}{:>12}{:>8}{:>11}\n", "Phase", "cycles", "share",
                   "bundles", "ops/bundle", "awake", "real time");
    for (const ArrayReport::Phase& phase : array.phases) {
        if (phase.counts.cycles == 0) {
            continue;
        }
        const auto number = static_cast<std::size_t>(phase.phase);
        const bool named = number < names.size() && !names[number].empty();
        fmt::format_to(out, "{:<24}{:>12}{:>7.1f}%{:>12}{:>12.2f}{:>7.1f}%{:>11.3g}\n",
                       named ? names[number] : fmt::format("phase {}", number), phase.counts.cycles,
                       100 * ratio(phase.counts.cycles, cycles), phase.counts.bundles,
                       phase.counts.parallelism(), 100 * phase.awake, phase.real_time);
    }
}

void add_procedures(std::string& text, const ArrayReport& array) {
    std::vector<ArrayReport::Procedure> order = array.procedures;
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
        return a.counts.cycles > b.counts.cycles;
    });
    const std::int64_t cycles = array.total().cycles;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "\n{:<24}{:>12}{:>8}{:>12}{:>12}{:>8}\n", "Procedure", "cycles", "share",
                   "bundles", "ops/bundle", "calls");
    for (std::size_t i = 0; i < std::min(order.size(), kShown); ++i) {
        const BundleCounts& counts = order[i].counts;
        fmt::format_to(out, "{:<24}{:>12}{:>7.1f}%{:>12}{:>12.2f}{:>8}\n", order[i].name,
                       counts.cycles, 100 * ratio(counts.cycles, cycles), counts.bundles,
                       counts.parallelism(), order[i].calls);
    }
    if (order.size() > kShown) {
        fmt::format_to(out, "and {} more\n", order.size() - kShown);
    }
}

}  // namespace

double BundleCounts::parallelism() const {
    return ratio(operations, bundles);
}

BundleCounts ArrayReport::total() const {
    BundleCounts sum;
    for (const Phase& phase : phases) {
        sum.cycles += phase.counts.cycles;
        sum.bundles += phase.counts.bundles;
        sum.operations += phase.counts.operations;
    }
    return sum;
}

double ArrayReport::awake() const {
    double sum = 0;
    for (const Phase& phase : phases) {
        sum += phase.awake * static_cast<double>(phase.counts.cycles);
    }
    const std::int64_t cycles = total().cycles;
    return cycles > 0 ? sum / static_cast<double>(cycles) : 0;
}

std::string procedures_csv(const ArrayReport& array) {
    std::string text = "name,file,line,calls,bundles,operations,cycles\n";
    for (const ArrayReport::Procedure& procedure : array.procedures) {
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{}\n", csv_text(procedure.name),
                       csv_text(procedure.file), procedure.line, procedure.calls,
                       procedure.counts.bundles, procedure.counts.operations,
                       procedure.counts.cycles);
    }
    return text;
}

std::string array_summary(const ArrayReport& array, const std::vector<std::string>& phase_names) {
    const BundleCounts total = array.total();
    std::string text = fmt::format(
        "Array           {} bundles in {} cycles, {:.2f} operations a bundle; {:.1f}% "
        "of the lanes awake; {} shifts over {} places\n",
        total.bundles, total.cycles, total.parallelism(), 100 * array.awake(), array.shifts,
        array.places);
    if (array.line_locked) {
        fmt::format_to(std::back_inserter(text),
                       "Scanlines       {} of {} cycles; {:.1f}% of these idle\n", array.scanlines,
                       array.line, 100 * ratio(array.idle_cycles, array.scanlines * array.line));
    }
    add_phases(text, array, phase_names);
    add_procedures(text, array);
    return text;
}

}  // namespace rasterloom::observe
