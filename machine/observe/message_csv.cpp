// SPDX-License-Identifier: MIT
#include "machine/observe/message_csv.hpp"

#include "machine/observe/output_folder.hpp"

#include <iterator>

namespace rasterloom::observe {

namespace {

constexpr std::size_t kFlushAt = 1 << 16;  // bytes

}  // namespace

MessageCsv::MessageCsv(const std::filesystem::path& path)
    : name_(path.string()), file_(std::fopen(path.c_str(), "wb")) {
    if (!file_) {
        throw OutputError(name_ + ": cannot be written");
    }
    fmt::format_to(std::back_inserter(buffer_),
                   "id,source,port,destination,kind,bytes,hops,queued_ps,started_ps,delivered_ps,"
                   "consumed_ps\n");
}

void MessageCsv::message_consumed(const MessageRecord& message) {
    fmt::format_to(std::back_inserter(buffer_), "{},{},{},{},{},{},{},{},{},{},{}\n", message.id,
                   message.source(), message.port, message.destination, message.kind, message.bytes,
                   message.hops, message.queued.picoseconds(), message.started.picoseconds(),
                   message.delivered.picoseconds(), message.consumed.picoseconds());
    if (buffer_.size() >= kFlushAt) {
        flush();
    }
}

void MessageCsv::flush() {
    failed_ |= std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get()) != buffer_.size();
    buffer_.clear();
}

void MessageCsv::close() {
    flush();
    failed_ |= std::fclose(file_.release()) != 0;
    if (failed_) {
        throw OutputError(name_ + ": could not be written completely");
    }
}

}  // namespace rasterloom::observe
