// SPDX-License-Identifier: MIT
// What a machine does, as a trace for a person to look at: a track for each processor (what it is
// at), for each link (what it carries) and for the phases; arrows follow each message from the
// program that sends it over the link to the one that takes it.
#pragma once

#include "machine/fabric/supervisor.hpp"
#include "machine/node/node_listener.hpp"
#include "machine/observe/perfetto_file.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace rasterloom::observe {

// Names for a person.
struct TraceNames {
    std::string machine;
    std::vector<std::string> nodes;       // [node]
    std::vector<std::string> activities;  // as MARK names them; may be shorter, entries empty
    std::vector<std::string> phases;      // of a frame; likewise
    // Time on the wire after a transfer; empty where the machine has no links.
    std::optional<Duration> link_latency;
    Duration cycle;  // of the nodes' clock
};

class MachineTrace final : public NodeListener, public SupervisorListener {
  public:
    // Throws OutputError when the file cannot be made.
    MachineTrace(const std::filesystem::path& path, TraceNames names);

    void interval_ended(const StateInterval& interval) override;
    void message_consumed(const MessageRecord& message) override;
    void phase_ended(const PhaseRecord& phase) override;

    std::int64_t events() const { return file_.events(); }
    // Throws OutputError when not everything could be written.
    void close() { file_.close(); }

  private:
    // What is written about a message: by the program that sends it, on the link, by the one that
    // takes it.
    enum class Part : std::uint8_t { sent, carried, taken };

    PerfettoFile::Track link_track(const MessageRecord& message);
    PerfettoFile::Name name_of(Part part, const MessageRecord& message);
    PerfettoFile::Name name_of(const StateInterval& interval);

    TraceNames names_;
    PerfettoFile file_;
    PerfettoFile::Track phases_ = 0;
    PerfettoFile::Track links_ = 0;
    std::vector<PerfettoFile::Track> nodes_;
    std::unordered_map<std::uint64_t, PerfettoFile::Track> link_tracks_;   // by source and port
    std::unordered_map<std::uint64_t, PerfettoFile::Name> message_names_;  // by what they say
    std::unordered_map<int, PerfettoFile::Name> state_names_;              // by state and activity
};

}  // namespace rasterloom::observe
