// SPDX-License-Identifier: MIT
// Nothing is moved: slot k is before processor (k + passes * stride) mod n, and what happens to a
// polygon follows when it enters the ring. Work grows with polygons and deliveries, and with empty
// slots in those passes for which a source list is not empty.
#include "machine/host/ring_stage.hpp"

#include <algorithm>

namespace rasterloom::host {
namespace {

class Stage {
  public:
    Stage(const Destinations& destinations, const StageSetup& setup, const PolygonLists& sources)
        : destinations_(destinations),
          reach_(setup.reach),
          processors_(static_cast<std::uint32_t>(sources.size())),
          period_(std::min<std::uint64_t>(setup.period, reach_.reach / reach_.stride)),
          arrivals_(sources.size()),
          waiting_(sources.size()),
          emptied_(reach_.reach / reach_.stride + period_) {
        for (ProcessorIndex processor = 0; processor < processors_; ++processor)
            keep_own(processor, sources[processor]);
    }

    StageOutcome run() {
        std::vector<ProcessorIndex> empty(processors_);  // slots
        for (std::uint32_t slot = 0; slot < processors_; ++slot)
            empty[slot] = slot;
        for (std::uint64_t pass = 0; unsent_ > 0; ++pass) {
            auto& emptied = emptied_[pass % emptied_.size()];
            empty.insert(empty.end(), emptied.begin(), emptied.end());
            emptied.clear();
            const auto turn = static_cast<std::uint32_t>(pass * reach_.stride % processors_);
            std::erase_if(empty, [&](std::uint32_t slot) {
                const std::uint32_t processor = (slot + turn) % processors_;
                if (waiting_[processor].empty())
                    return false;
                send(processor, slot, pass);
                return true;
            });
        }
        outcome_.received = received();
        return std::move(outcome_);
    }

  private:
    struct Arrival {
        std::uint64_t pass;
        PolygonIndex polygon;
    };

    void keep_own(ProcessorIndex processor, const std::vector<PolygonIndex>& source) {
        auto& waiting = waiting_[processor];
        for (const PolygonIndex polygon : source) {
            passes_to(destinations_.of(polygon), processor, reach_, ranges_);
            if (ranges_.empty())
                continue;
            if (ranges_.front().first == 0)
                arrivals_[processor].push_back({0, polygon});
            if (ranges_.back().last > 0)
                waiting.push_back(polygon);
        }
        unsent_ += waiting.size();
        std::ranges::reverse(waiting);
    }

    void send(ProcessorIndex processor, std::uint32_t slot, std::uint64_t pass) {
        const PolygonIndex polygon = waiting_[processor].back();
        waiting_[processor].pop_back();
        --unsent_;
        passes_to(destinations_.of(polygon), processor, reach_, ranges_);
        for (const auto& [first, last] : ranges_)
            for (std::uint32_t hop = std::max(first, 1U); hop <= last; ++hop)
                arrivals_[(processor + hop * reach_.stride) % processors_].push_back(
                    {pass + hop, polygon});
        const std::uint64_t done = pass + ranges_.back().last;
        const std::uint64_t tested = (done + period_ - 1) / period_ * period_;
        emptied_[tested % emptied_.size()].push_back(slot);
        ++outcome_.sent;
        outcome_.carried += tested - pass;
        outcome_.passes = std::max(outcome_.passes, tested);
    }

    PolygonLists received() {
        PolygonLists lists(processors_);
        for (ProcessorIndex processor = 0; processor < processors_; ++processor) {
            auto& arrivals = arrivals_[processor];
            std::ranges::stable_sort(arrivals, {}, &Arrival::pass);
            for (const Arrival& arrival : arrivals)
                lists[processor].push_back(arrival.polygon);
            arrivals = {};
        }
        return lists;
    }

    const Destinations& destinations_;
    StageReach reach_;
    std::uint32_t processors_;
    std::uint64_t period_;
    std::vector<std::vector<Arrival>> arrivals_;  // at each processor; pass 0: its own
    PolygonLists waiting_;                        // the next one to send is last
    std::uint64_t unsent_ = 0;
    std::vector<std::vector<std::uint32_t>> emptied_;  // slots, by pass modulo its size
    std::vector<PassRange> ranges_;                    // of the polygon at hand
    StageOutcome outcome_;
};

}  // namespace

StageOutcome communicate(const Destinations& destinations, const StageSetup& setup,
                         const PolygonLists& sources) {
    return Stage(destinations, setup, sources).run();
}

}  // namespace rasterloom::host
