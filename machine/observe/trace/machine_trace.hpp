// SPDX-License-Identifier: MIT
// What a machine does, as a trace for a person to look at: a track for each processor (what it is
// at), for each other part (busy or blocked), for each link (what it carries) and for the phases;
// below them the messages in their queues. Arrows follow each message from the program that
// sends it over the link to the one that takes it.
#pragma once

#include "machine/observe/machine_names.hpp"
#include "machine/observe/trace/perfetto_file.hpp"
#include "machine/observe/trace/trace_sink.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <unordered_map>
#include <vector>

namespace rasterloom::observe {

class MachineTrace final : public TraceSink {
  public:
    // Throws OutputError when the file cannot be made.
    MachineTrace(const std::filesystem::path& path, MachineNames names);

    void interval_ended(const StateInterval& interval) override;
    void message_consumed(const MessageRecord& message) override;
    void phase_ended(const PhaseRecord& phase) override;
    void part_interval_ended(const PartInterval& interval) override;
    bool wants_queues() const override { return true; }
    void queue_changed(const QueueChange& change) override;
    void close(const RunReport& report, const std::vector<CriticalPath>& paths) override;

    std::int64_t events() const { return file_.events(); }

  private:
    // What is written about a message: by the program that sends it, on the link, by the one that
    // takes it.
    enum class Part : std::uint8_t { sent, carried, taken };
    // The messages in a queue: `length` from `since` on, which is not written
    // yet.
    struct Queue {
        PerfettoFile::Track track = 0;
        Time since;
        int length = 0;
        int written = 0;
    };

    // What is written about messages of one sort over a link: nearly always the same as before.
    struct LinkNames {
        std::uint32_t bytes = 0;
        std::uint8_t kind = 0;
        PerfettoFile::Name sent = 0;
        PerfettoFile::Name carried = 0;
        PerfettoFile::Name taken = 0;
    };

    void add_nodes(PerfettoFile::Track root);
    void add_parts(PerfettoFile::Track root);
    PerfettoFile::Track track(ComponentId component) const {
        return tracks_[static_cast<std::size_t>(component)];
    }
    PerfettoFile::Track link_track(ComponentId link);
    PerfettoFile::Track add_queue(ComponentId component, QueuePlace place);
    PerfettoFile::Name name_of(Part part, const MessageRecord& message);
    const LinkNames& names_on_link(const MessageRecord& message);
    PerfettoFile::Name name_of(const StateInterval& interval);
    void write_queue(std::size_t index);

    MachineNames names_;
    PerfettoFile file_;
    PerfettoFile::Track phases_ = 0;
    PerfettoFile::Track links_ = 0;
    PerfettoFile::Name busy_ = 0;
    PerfettoFile::Name blocked_ = 0;
    std::vector<PerfettoFile::Track> tracks_;  // [component], 0 as long as it has none
    std::vector<Queue> queues_;                // [component x kQueuePlaces + place]
    std::unordered_map<std::uint64_t, PerfettoFile::Name> message_names_;  // by what they say
    std::vector<LinkNames> link_names_;                                    // [component]
    std::array<PerfettoFile::Name, kNodeStates * kActivities> state_names_{};
};

}  // namespace rasterloom::observe
