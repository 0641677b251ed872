// SPDX-License-Identifier: MIT
#include "machine/observe/bottlenecks/cause_keeper.hpp"

#include "machine/kernel/mailbox.hpp"

#include <utility>

namespace rasterloom::observe {

class alignas(kCacheLine) CauseKeeper::Keeper final : public CauseListener {
  public:
    void sent(const Event& event, Time departure, EventId cause) override {
        told_.emplace_back(event.source(), SentEvent(event, departure, cause));
    }
    void take() { std::swap(told_, taken_); }
    void move_to(CauseLog& log) {
        for (const auto& [source, event] : taken_) {
            log.add(source, event);
        }
        taken_.clear();
    }

  private:
    std::vector<std::pair<ComponentId, SentEvent>> told_;
    alignas(kCacheLine) std::vector<std::pair<ComponentId, SentEvent>> taken_;  // another thread's
};

CauseKeeper::CauseKeeper(std::size_t partitions) {
    for (std::size_t partition = 0; partition < partitions; ++partition) {
        keepers_.push_back(std::make_unique<Keeper>());
    }
}

CauseKeeper::~CauseKeeper() = default;

CauseListener& CauseKeeper::for_partition(std::size_t partition) {
    return *keepers_[partition];
}

void CauseKeeper::take() {
    for (const auto& keeper : keepers_) {
        keeper->take();
    }
}

void CauseKeeper::move_to(CauseLog& log) {
    for (const auto& keeper : keepers_) {
        keeper->move_to(log);
    }
}

}  // namespace rasterloom::observe
