// SPDX-License-Identifier: MIT
// messages.csv: one row for every hop of every message, written as they are consumed, so that
// memory stays bounded.
#pragma once

#include "machine/node/node_listener.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

namespace rasterloom::observe {

class MessageCsv final : public NodeListener {
  public:
    // Throws OutputError when the file cannot be made.
    explicit MessageCsv(const std::filesystem::path& path);
    void message_consumed(const MessageRecord& message) override;
    // Throws OutputError when not everything could be written (a full disk).
    void close();

  private:
    struct Closer {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    void flush();

    std::string name_;
    std::unique_ptr<std::FILE, Closer> file_;
    fmt::memory_buffer buffer_;
    bool failed_ = false;
};

}  // namespace rasterloom::observe
