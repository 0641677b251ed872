// SPDX-License-Identifier: MIT
// What a processor says of itself to a person: what it waits for, what it is at, what its program
// has done wrong.
#include "machine/node/processor.hpp"

#include <utility>

#include <fmt/format.h>

namespace rasterloom {

GuestError::Details Processor::details(std::int64_t cycle, std::uint32_t program_counter,
                                       std::string what) const {
    GuestError::Details details;
    details.node = settings_.node;
    details.cycle = cycle;
    details.program_counter = program_counter;
    if (settings_.image != nullptr) {
        if (const auto* source = settings_.image->source_of(program_counter)) {
            details.source = *source;
        }
    }
    details.radix = settings_.radix;
    details.what = std::move(what);
    return details;
}

std::shared_ptr<const GuestError> Processor::mistake(Time time, std::uint32_t program_counter,
                                                     std::string what) const {
    return std::make_shared<GuestError>(
        time, name(),
        details(settings_.clock.edge_at_or_after(time).count(), program_counter, std::move(what)));
}

std::optional<std::string> Processor::waits_for() const {
    std::string what;
    switch (stall_) {
        case Stall::none:
            return std::nullopt;
        case Stall::transmit:
            what = fmt::format("room in the output queue of port {} ({} messages)", stall_argument_,
                               ports_.used(static_cast<int>(stall_argument_)));
            break;
        case Stall::receive:
            what = fmt::format("a message at port {}", stall_argument_);
            break;
        case Stall::wait_for:
            what = fmt::format("WAITFOR {}", format_word(stall_argument_, settings_.radix));
            what += (stall_argument_ & kWaitMessage) != 0 ? ", a message" : "";
            what += (stall_argument_ & kWaitPhase) != 0
                        ? fmt::format(", the phase after {}", phase_read_)
                        : "";
            what += (stall_argument_ & kWaitRoom) != 0 ? ", room to send" : "";
            break;
        case Stall::interrupt:
            what = "an interrupt";
            break;
        case Stall::pixel:
            what = "the frame-buffer bus";
            break;
    }
    return fmt::format("{} since {}, {}", what, to_string(local_time_),
                       place(core_->program_counter()));
}

std::string Processor::place(std::uint32_t program_counter) const {
    std::string text = fmt::format("at {}", format_word(program_counter, settings_.radix));
    if (settings_.image != nullptr) {
        if (const auto* source = settings_.image->source_of(program_counter)) {
            text += fmt::format(", {}:{}", source->file, source->line);
        }
    }
    return text;
}

std::optional<std::string> Processor::activity() const {
    const auto waits = waits_for();
    if (waits && local_time_ <= now()) {
        return fmt::format("{} waits for {}", name(), *waits);
    }
    if (halted()) {
        return std::nullopt;
    }
    return fmt::format("{} runs {}", name(), place(core_->program_counter()));
}

}  // namespace rasterloom
