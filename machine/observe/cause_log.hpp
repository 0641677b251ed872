// SPDX-License-Identifier: MIT
// Remembers why every event of the present frame was sent.
#pragma once

#include "machine/kernel/cause.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace rasterloom::observe {

struct SentEvent {
    Time departure;
    Time arrival;
    EventId cause = kNoCause;
};

class CauseLog final : public CauseListener {
  public:
    explicit CauseLog(std::size_t components) : sent_by_(components) {}

    void sent(const Event& event, Time departure, EventId cause) override;

    // Empty for kNoCause and for what has been forgotten.
    std::optional<SentEvent> find(EventId event) const;
    // Forgets what arrived before `time`, as far as nothing sent earlier by the same component has
    // arrived later: what is left explains everything from `time` on. While the machine stands
    // still.
    void forget_before(Time time);
    std::size_t size() const;

  private:
    // What one component has sent, one after the other; threads do not share them.
    struct Sent {
        std::uint32_t first = 0;  // sequence of the first that is remembered
        std::vector<SentEvent> events;
    };

    std::vector<Sent> sent_by_;  // [component]
};

}  // namespace rasterloom::observe
