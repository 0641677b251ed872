// SPDX-License-Identifier: MIT
// What a program may do in the I/O page while its core runs on: the same as in processor_io.cpp,
// for accesses whose outcome is known already and which cannot fail.
#include "machine/node/processor.hpp"

#include <utility>

namespace rasterloom {

isa::Bus::Read Processor::Prompt::read(std::uint32_t address, int bytes) {
    const auto where = decode_register(address);
    if (!where || bytes != 2 || !processor_.may_read_promptly(*where)) {
        return {Status::retry, 0};
    }
    read_at_ = {pc, cycles_before};
    const auto value =
        where->port ? processor_.read_port(*where->port, static_cast<PortRegister>(where->offset))
                    : processor_.read_node(static_cast<NodeRegister>(where->offset));
    return value ? Read{Status::ok, *value} : Read{Status::retry, 0};
}

isa::Bus::Status Processor::Prompt::write(std::uint32_t address, std::uint32_t value, int bytes) {
    const auto where = decode_register(address);
    if (bytes != 2 || !(where ? processor_.may_write_promptly(*where, value)
                              : processor_.may_write_frame_buffer_promptly(address, value))) {
        if (where && bytes == 2 && read_at_ != std::pair{pc, cycles_before}) {
            processor_.foresee_stall(*where, value);
        }
        return Status::retry;
    }
    processor_.come_to(cycles_before);
    processor_.step_at_ = pc;
    if (!where) {
        return processor_.write_frame_buffer(address, value);
    }
    return where->port ? processor_.write_port(*where->port,
                                               static_cast<PortRegister>(where->offset), value)
                       : processor_.write_node(static_cast<NodeRegister>(where->offset), value);
}

// An instruction whose only access will wait at the core's own time need not be tried for that.
void Processor::foresee_stall(const RegisterAddress& address, std::uint32_t value) {
    if (!address.port) {
        if (static_cast<NodeRegister>(address.offset) == NodeRegister::waitfor) {
            foreseen_stall_ = Stall::wait_for;
            stall_argument_ = value;
        }
    } else if (static_cast<PortRegister>(address.offset) == PortRegister::rxaddr &&
               ports_.receives(*address.port) && ports_.waiting(*address.port) == 0) {
        foreseen_stall_ = Stall::receive;
        stall_argument_ = static_cast<std::uint32_t>(*address.port);
    }
}

// The core is in the middle of a run; the processor's time still is, or is little after, that of
// its beginning.
void Processor::come_to(std::int64_t cycles_of_run) {
    spend(cycles_of_run - spent_of_run_);
    spent_of_run_ = cycles_of_run;
}

bool Processor::may_read_promptly(const RegisterAddress& address) const {
    return !needs_exact_time(address, false) || is_foreseen_read(address);
}

bool Processor::may_write_frame_buffer_promptly(std::uint32_t address, std::uint32_t value) const {
    return frame_buffer_ &&
           (address == kFbClear ||
            (address == kFbRow && value < static_cast<std::uint32_t>(frame_buffer_->rows())));
}

bool Processor::may_write_promptly(const RegisterAddress& address, std::uint32_t value) const {
    if (address.port) {
        switch (static_cast<PortRegister>(address.offset)) {
            case PortRegister::txaddr:
                return true;
            case PortRegister::rxaddr:
                return is_known_to_wait(*address.port) && value <= core_->memory().size() &&
                       ports_.oldest(*address.port).bytes.size() <= core_->memory().size() - value;
            default:
                return false;
        }
    }
    switch (static_cast<NodeRegister>(address.offset)) {
        case NodeRegister::credit:
            return settings_.supervised;
        case NodeRegister::mark:
            return value < kActivities;
        case NodeRegister::waitfor:
            return wait_mask_holds(value);
        default:
            return false;
    }
}

}  // namespace rasterloom
