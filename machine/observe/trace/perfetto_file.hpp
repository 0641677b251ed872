// SPDX-License-Identifier: MIT
// Writes a file that Perfetto's viewer (ui.perfetto.dev) opens: tracks, slices, instants and arrows
// between them. It is a protobuf message whose field 1 repeats TracePacket; field numbers are those
// of Perfetto's trace_packet.proto.
//
// The file is streamed under a temporary name and gets its own when it is complete.
#pragma once

#include "machine/kernel/time.hpp"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace rasterloom::observe {

class PerfettoFile {
  public:
    using Track = std::uint64_t;  // 0: none
    using Name = std::uint64_t;
    using Flow =
        std::uint64_t;  // events with the same one are joined by arrows, in order of time; 0: none

    // `scale`: viewer's nanoseconds for a nanosecond of the machine's time, at least 1.
    // Throws OutputError when the file cannot be made.
    PerfettoFile(std::filesystem::path path, std::int64_t scale);
    ~PerfettoFile();
    PerfettoFile(const PerfettoFile&) = delete;
    PerfettoFile& operator=(const PerfettoFile&) = delete;

    // A name for slices and instants; asking for the same one again gives the same.
    Name name(std::string_view text);
    // Tracks below one parent are shown in the order in which they were added.
    Track add_track(std::string_view name, Track parent);
    // A track whose events are the values of a counter, which is 0 at first.
    Track add_counter(std::string_view name, Track parent);
    // Slices of one track must not overlap; nothing is written for one that is no time long.
    void slice(Track track, Name name, Time from, Time to, Flow flow = 0);
    void instant(Track track, Name name, Time at, Flow flow = 0, bool flow_ends = false);

    // The counter is `value` from `at` on.
    void count(Track counter, Time at, std::int64_t value);

    std::int64_t events() const { return events_; }
    // Throws OutputError when not everything could be written.
    void close();

  private:
    struct Closer {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    Track describe_track(std::string_view name, Track parent, bool is_counter);
    std::uint64_t nanoseconds(Time time) const;
    class EventPacket;
    void event(Track track, std::uint64_t type, Name name, Time time, Flow flow, bool flow_ends);
    void add_event(EventPacket& event);
    void add_packet(const std::string& packet);
    void flush();

    std::filesystem::path path_;
    std::filesystem::path partial_;
    std::unique_ptr<std::FILE, Closer> file_;
    std::int64_t scale_;
    std::string buffer_;
    std::map<std::string, std::uint64_t, std::less<>> names_;
    std::map<Track, std::int32_t> children_;  // so far, by parent
    Track last_track_ = 0;
    std::int64_t events_ = 0;
    bool failed_ = false;
};

}  // namespace rasterloom::observe
