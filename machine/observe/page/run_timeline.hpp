// SPDX-License-Identifier: MIT
// What the parts of a machine were at in the course of a run: the share of each bin of time that a
// processor spent in each state and a link was carrying something, how many messages stood in each
// queue on average, how many were under way in the whole machine; and how often messages took how
// long and went how far. It costs the same memory for a run of any length.
//
// Messages count once they have been consumed: what is still under way when the run ends does not.
#pragma once

#include "machine/fabric/part_listener.hpp"
#include "machine/node/node_listener.hpp"
#include "machine/observe/appendix_c/distribution.hpp"
#include "machine/observe/page/timeline.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace rasterloom::observe {

// Tracks of a timeline that say the same of every component of one sort.
struct TimelineSeries {
    enum class Of : std::uint8_t { machine, node, link, part };
    enum class Role : std::uint8_t { busy, waiting, queue };  // what to show it as; queue: messages

    Of of = Of::node;
    Role role = Role::busy;
    std::string name;   // "waiting_input"
    std::string label;  // for a person: "waiting for a message"
    std::size_t first_track = 0;
    std::size_t components = 0;
};

// What there is to be followed.
struct TimelineSubjects {
    std::size_t nodes = 0;
    std::vector<std::size_t> first_link;  // [node]: its port p sends over link first_link + p
    std::size_t links = 0;
    Duration link_latency;           // on the wire, after the transfer
    std::vector<ComponentId> parts;  // of the fabric
    Duration cycle;                  // of the nodes' clock: a bin is a power of two of them
};

class RunTimeline final : public NodeListener, public PartListener {
  public:
    explicit RunTimeline(TimelineSubjects subjects);

    void interval_ended(const StateInterval& interval) override;
    // Messages of one link come in the order in which it carried them.
    void message_consumed(const MessageRecord& message) override;

    void part_interval_ended(const PartInterval& interval) override;
    void message_passed(ComponentId part, const MessageRecord& message) override;

    const Timeline& bins() const { return *bins_; }
    const std::vector<TimelineSeries>& series() const { return series_; }
    // How many messages took at least so many picoseconds from being queued to being consumed, and
    // less than the next key.
    const Distribution& latencies() const { return latencies_; }
    // How many messages went their n-th hop; a message of one hop counts as 1.
    const Distribution& hops() const { return hops_; }

  private:
    std::size_t add_series(TimelineSeries::Of of, TimelineSeries::Role role, std::string name,
                           std::string label);
    std::size_t count(TimelineSeries::Of of) const;
    void count_link(const MessageRecord& message);

    TimelineSubjects subjects_;
    std::vector<TimelineSeries> series_;
    std::size_t tracks_ = 0;
    // First tracks.
    std::size_t states_ = 0;  // of all nodes: busy; then those of the next state
    std::size_t node_input_ = 0;
    std::size_t node_output_ = 0;
    std::size_t under_way_ = 0;
    std::size_t link_busy_ = 0;
    std::size_t link_waiting_ = 0;
    std::size_t link_queue_ = 0;
    std::size_t part_busy_ = 0;
    std::size_t part_blocked_ = 0;
    std::size_t part_input_ = 0;
    std::unordered_map<std::uint32_t, std::size_t> part_of_;  // by component
    std::optional<Timeline> bins_;
    std::vector<Time> last_started_;  // [link]
    Distribution latencies_;
    Distribution hops_;
};

// The least value that counts as the same latency: eight a power of two.
std::int64_t latency_class(Duration latency);

}  // namespace rasterloom::observe
