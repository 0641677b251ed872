// SPDX-License-Identifier: MIT
#include "machine/emulation/path_lines.hpp"

#include "machine/emulation/array_profile.hpp"
#include "machine/emulation/slices.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

namespace rasterloom::emulation {

namespace {

struct Window {
    std::size_t path = 0;
    Time from;
    Time to;
};

struct Executed {
    std::int64_t instructions = 0;
    Duration time;
};

// Books what one processor executes within its windows, which are in order and do not overlap.
class LineMeter final : public NodeListener {
  public:
    using Counts = std::unordered_map<std::uint32_t, Executed>;  // by address

    LineMeter(const Clock& clock, std::vector<Window> windows)
        : clock_(clock), windows_(std::move(windows)), counts_(windows_.size()) {}

    void tapped(const Tap& tap) override {
        if (last_) {
            book(tap.cycles - last_->cycles, tap.time);
        }
        last_ = Last{tap.address, tap.cycles};
    }
    const std::vector<Window>& windows() const { return windows_; }
    const Counts& counts(std::size_t window) const { return counts_[window]; }

  private:
    struct Last {
        std::uint32_t address;
        std::int64_t cycles;
    };

    // The last instruction took so many cycles until `end`. If it stalled, it did so before.
    void book(std::int64_t cycles, Time end) {
        const Time began = clock_.edge(Cycles(clock_.edge_at_or_before(end).count() - cycles));
        while (next_ < windows_.size() && windows_[next_].to <= began) {
            ++next_;
        }
        bool counted = false;
        for (std::size_t i = next_; i < windows_.size() && windows_[i].from < end; ++i) {
            Executed& executed = counts_[i][last_->address];
            executed.time += std::min(end, windows_[i].to) - std::max(began, windows_[i].from);
            executed.instructions += std::exchange(counted, true) ? 0 : 1;
        }
    }

    Clock clock_;
    std::vector<Window> windows_;
    std::vector<Counts> counts_;  // [window]
    std::size_t next_ = 0;        // window that is not over
    std::optional<Last> last_;
};

// By node.
std::map<std::size_t, std::vector<Window>> windows_of(
    const Machine& machine, const std::vector<observe::CriticalPath>& paths) {
    std::unordered_map<std::uint32_t, std::size_t> node_of;
    for (std::size_t node = 0; node < machine.processors().size(); ++node) {
        node_of[static_cast<std::uint32_t>(machine.processors()[node]->id())] = node;
    }
    std::map<std::size_t, std::vector<Window>> windows;
    for (std::size_t path = 0; path < paths.size(); ++path) {
        for (const observe::PathStep& step : paths[path].steps) {
            const auto node = node_of.find(static_cast<std::uint32_t>(step.component));
            if (!step.on_wire && node != node_of.end()) {
                windows[node->second].push_back({path, step.from, step.to});
            }
        }
    }
    return windows;
}

// Where statements begin that may be instructions.
std::vector<std::uint32_t> statements(const Blueprint& blueprint) {
    const auto word = static_cast<std::uint32_t>(blueprint.isa.word_bits() / 8);
    std::vector<std::uint32_t> addresses;
    for (const auto& [address, location] : blueprint.image->lines) {
        if (address % word == 0) {
            addresses.push_back(address);
        }
    }
    return addresses;
}

std::string name_of(const isa::SourceLocation& source, const std::filesystem::path& folder) {
    return std::filesystem::path(source.file).lexically_proximate(folder).generic_string();
}

std::vector<std::vector<observe::PathReport::LineShare>> gather(
    const isa::Image& image, const std::vector<std::unique_ptr<LineMeter>>& meters,
    std::size_t paths) {
    // Seen from the program's folder: the same on every machine.
    const std::filesystem::path folder = std::filesystem::path(image.name).parent_path();
    std::vector<std::map<std::pair<std::string, int>, Executed>> lines(paths);
    for (const auto& meter : meters) {
        for (std::size_t window = 0; window < meter->windows().size(); ++window) {
            for (const auto& [address, executed] : meter->counts(window)) {
                const isa::SourceLocation* source = image.source_of(address);
                if (source != nullptr) {
                    Executed& sum = lines[meter->windows()[window].path]
                                         [{name_of(*source, folder), source->line}];
                    sum.instructions += executed.instructions;
                    sum.time += executed.time;
                }
            }
        }
    }
    std::vector<std::vector<observe::PathReport::LineShare>> shares(paths);
    for (std::size_t path = 0; path < paths; ++path) {
        for (const auto& [place, executed] : lines[path]) {
            shares[path].push_back(
                {place.first, place.second, executed.instructions, executed.time});
        }
        std::stable_sort(shares[path].begin(), shares[path].end(),
                         [](const auto& a, const auto& b) { return a.time > b.time; });
    }
    return shares;
}

}  // namespace

std::vector<std::vector<observe::PathReport::LineShare>> lines_on_paths(
    const Blueprint& blueprint, HostJob* job, const Machine& machine,
    const std::vector<observe::CriticalPath>& paths) {
    if (machine.lockstep() != nullptr) {
        return lines_of_frames(blueprint, *machine.lockstep());
    }
    if (machine.processors().empty()) {
        return std::vector<std::vector<observe::PathReport::LineShare>>(paths.size());
    }
    Machine again(blueprint, job != nullptr ? job->frames() : HostFrames());
    if (job != nullptr) {
        job->load(again);
    }
    const std::vector<std::uint32_t> addresses = statements(blueprint);
    const Clock clock = blueprint.description.nodes.clock.clock();
    std::vector<std::unique_ptr<LineMeter>> meters;
    for (auto& [node, windows] : windows_of(machine, paths)) {
        meters.push_back(std::make_unique<LineMeter>(clock, std::move(windows)));
        again.processors()[node]->core().set_taps(addresses);
        again.processors()[node]->probe().attach(*meters.back());
    }
    run_in_slices(again.simulation(), Time::zero() + blueprint.description.run.max_time, kSlice,
                  [](Time) {});
    return gather(*blueprint.image, meters, paths.size());
}

}  // namespace rasterloom::emulation
