// SPDX-License-Identifier: MIT
#include "machine/observe/trace/perfetto_file.hpp"

#include "machine/observe/output_folder.hpp"

#include <array>
#include <system_error>
#include <utility>

#include <protozero/pbf_writer.hpp>

namespace rasterloom::observe {

namespace {

using protozero::pbf_writer;

constexpr std::size_t kFlushAt = 1 << 16;  // bytes
constexpr std::uint32_t kSequence = 1;     // all packets are one sequence's

namespace trace_file {
constexpr protozero::pbf_tag_type packet = 1;
}
namespace packet {
constexpr protozero::pbf_tag_type timestamp = 8, sequence_id = 10, track_event = 11,
                                  interned_data = 12, sequence_flags = 13, track_descriptor = 60;
constexpr std::uint32_t cleared = 1, needs_state = 2;  // sequence_flags
}  // namespace packet
namespace track_descriptor {
constexpr protozero::pbf_tag_type uuid = 1, name = 2, parent_uuid = 5, counter = 8,
                                  child_ordering = 11, sibling_order_rank = 12,
                                  sibling_merge_behavior = 15;
constexpr std::int32_t ordering_explicit = 3, merge_none = 2;
}  // namespace track_descriptor
namespace track_event {
constexpr protozero::pbf_tag_type type = 9, name_iid = 10, track_uuid = 11, counter_value = 30,
                                  flow_ids = 47, terminating_flow_ids = 48;
constexpr std::uint64_t slice_begin = 1, slice_end = 2, instant = 3, counter = 4;
}  // namespace track_event
namespace interned_data {
constexpr protozero::pbf_tag_type event_names = 2;
constexpr protozero::pbf_tag_type iid = 1, name = 2;  // of each
}  // namespace interned_data

}  // namespace

// A packet with one event, encoded in one go: there are millions of them. That its parts are
// shorter than 128 bytes is known beforehand, so that one byte is left for the length of each.
class PerfettoFile::EventPacket {
  public:
    explicit EventPacket(std::uint64_t timestamp) {
        begin(trace_file::packet);
        number(packet::timestamp, timestamp);
        number(packet::sequence_id, kSequence);
        number(packet::sequence_flags, packet::needs_state);
        begin(packet::track_event);
    }
    void number(protozero::pbf_tag_type tag, std::uint64_t value) {
        put(std::uint64_t{tag} << 3U);
        put(value);
    }
    void fixed(protozero::pbf_tag_type tag, std::uint64_t value) {
        put(std::uint64_t{tag} << 3U | 1U);
        for (unsigned byte = 0; byte < 8; ++byte) {
            bytes_[size_++] = static_cast<char>(value >> 8 * byte & 0xffU);
        }
    }
    // Both messages end here.
    std::string_view finished() {
        for (const std::size_t start : starts_) {
            bytes_[start] = static_cast<char>(size_ - start - 1);
        }
        return {bytes_.data(), size_};
    }

  private:
    void begin(protozero::pbf_tag_type tag) {
        put(std::uint64_t{tag} << 3U | 2U);
        starts_[depth_++] = size_++;
    }
    void put(std::uint64_t value) {
        while (value >= 0x80) {
            bytes_[size_++] = static_cast<char>(value | 0x80U);
            value >>= 7U;
        }
        bytes_[size_++] = static_cast<char>(value);
    }

    // Of an event at most 4 fields of 12 bytes; of its packet 3 more, and twice a length.
    std::array<char, 128> bytes_;
    std::size_t size_ = 0;
    std::array<std::size_t, 2> starts_{};  // of the messages: where their lengths are
    std::size_t depth_ = 0;
};

PerfettoFile::PerfettoFile(std::filesystem::path path, std::int64_t scale)
    : path_(std::move(path)),
      partial_(path_.string() + ".partial"),
      file_(std::fopen(partial_.c_str(), "wb")),
      scale_(scale) {
    if (!file_) {
        throw OutputError(path_.string() + ": cannot be written");
    }
    std::string first;
    pbf_writer writer(first);
    writer.add_uint32(packet::sequence_id, kSequence);
    writer.add_uint32(packet::sequence_flags, packet::cleared);
    add_packet(first);
}

PerfettoFile::~PerfettoFile() {
    if (file_) {
        file_.reset();
        std::error_code ignored;
        std::filesystem::remove(partial_, ignored);
    }
}

void PerfettoFile::add_packet(const std::string& packet) {
    pbf_writer(buffer_).add_message(trace_file::packet, packet);
    if (buffer_.size() >= kFlushAt) {
        flush();
    }
}

PerfettoFile::Track PerfettoFile::add_track(std::string_view name, Track parent) {
    return describe_track(name, parent, false);
}

PerfettoFile::Track PerfettoFile::add_counter(std::string_view name, Track parent) {
    return describe_track(name, parent, true);
}

PerfettoFile::Track PerfettoFile::describe_track(std::string_view name, Track parent,
                                                 bool is_counter) {
    const Track track = ++last_track_;
    std::string descriptor;
    pbf_writer fields(descriptor);
    fields.add_uint64(track_descriptor::uuid, track);
    fields.add_string(track_descriptor::name, name.data(), name.size());
    if (parent != 0) {
        fields.add_uint64(track_descriptor::parent_uuid, parent);
    }
    if (is_counter) {
        fields.add_message(track_descriptor::counter, std::string());
    }
    fields.add_int32(track_descriptor::child_ordering, track_descriptor::ordering_explicit);
    fields.add_int32(track_descriptor::sibling_order_rank, children_[parent]++);
    fields.add_int32(track_descriptor::sibling_merge_behavior, track_descriptor::merge_none);
    std::string text;
    pbf_writer writer(text);
    writer.add_uint32(packet::sequence_id, kSequence);
    writer.add_message(packet::track_descriptor, descriptor);
    add_packet(text);
    return track;
}

PerfettoFile::Name PerfettoFile::name(std::string_view name) {
    const auto known = names_.find(name);
    if (known != names_.end()) {
        return known->second;
    }
    const std::uint64_t iid = names_.size() + 1;
    names_.emplace(name, iid);
    std::string entry;
    pbf_writer fields(entry);
    fields.add_uint64(interned_data::iid, iid);
    fields.add_string(interned_data::name, name.data(), name.size());
    std::string data;
    pbf_writer(data).add_message(interned_data::event_names, entry);
    std::string text;
    pbf_writer writer(text);
    writer.add_uint32(packet::sequence_id, kSequence);
    writer.add_uint32(packet::sequence_flags, packet::needs_state);
    writer.add_message(packet::interned_data, data);
    add_packet(text);
    return iid;
}

std::uint64_t PerfettoFile::nanoseconds(Time time) const {
    return static_cast<std::uint64_t>(time.picoseconds() / 1000 * scale_ +
                                      time.picoseconds() % 1000 * scale_ / 1000);
}

void PerfettoFile::event(Track track, std::uint64_t type, Name name, Time time, Flow flow,
                         bool flow_ends) {
    EventPacket event(nanoseconds(time));
    event.number(track_event::type, type);
    if (name != 0) {
        event.number(track_event::name_iid, name);
    }
    event.number(track_event::track_uuid, track);
    if (flow != 0) {
        event.fixed(flow_ends ? track_event::terminating_flow_ids : track_event::flow_ids, flow);
    }
    add_event(event);
}

void PerfettoFile::add_event(EventPacket& event) {
    buffer_.append(event.finished());
    if (buffer_.size() >= kFlushAt) {
        flush();
    }
    ++events_;
}

void PerfettoFile::count(Track counter, Time at, std::int64_t value) {
    EventPacket event(nanoseconds(at));
    event.number(track_event::type, track_event::counter);
    event.number(track_event::track_uuid, counter);
    event.number(track_event::counter_value, static_cast<std::uint64_t>(value));
    add_event(event);
}

void PerfettoFile::slice(Track track, Name name, Time from, Time to, Flow flow) {
    if (from < to) {
        event(track, track_event::slice_begin, name, from, flow, false);
        event(track, track_event::slice_end, 0, to, 0, false);
    }
}

void PerfettoFile::instant(Track track, Name name, Time at, Flow flow, bool flow_ends) {
    event(track, track_event::instant, name, at, flow, flow_ends);
}

void PerfettoFile::flush() {
    failed_ |= std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get()) != buffer_.size();
    buffer_.clear();
}

void PerfettoFile::close() {
    flush();
    failed_ |= std::fclose(file_.release()) != 0;
    std::error_code error;
    if (!failed_) {
        std::filesystem::rename(partial_, path_, error);
        failed_ = static_cast<bool>(error);
    }
    if (failed_) {
        std::filesystem::remove(partial_, error);
        throw OutputError(path_.string() + ": could not be written completely");
    }
}

}  // namespace rasterloom::observe
