// SPDX-License-Identifier: MIT
#include "programs/bare_node.hpp"

#include "isa/pdp11/pdp11.hpp"
#include "machine/node/registers.hpp"
#include "programs/strothotte_run.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::test {

namespace {

constexpr int kStackPointer = 6;

const std::shared_ptr<const isa::PreparedProgram>& prepared_program() {
    static const auto program =
        isa::pdp11::pdp11_isa().prepare(strothotte_image(), isa::CostChoice{"strothotte", {}});
    return program;
}

}  // namespace

BareNode::BareNode(const std::vector<isa::Segment>& segments)
    : core_(isa::pdp11::pdp11_isa().make_core(prepared_program(), {})) {
    for (const isa::Segment& segment : segments) {
        core_->write_memory(segment.address, segment.bytes);
    }
}

std::uint32_t BareNode::symbol(std::string_view name) {
    const auto value = strothotte_image().symbol(name);
    if (!value) {
        throw std::runtime_error(fmt::format("no symbol {}", name));
    }
    return *value;
}

BareNode::Registers BareNode::call(std::string_view routine, const Registers& registers) {
    const std::uint32_t halt = symbol("finish");
    const std::uint32_t stack = symbol("stack_top") - 2;
    for (int i = 0; i < 6; ++i) {
        core_->set_reg(i, registers[i]);
    }
    core_->set_reg(kStackPointer, stack);
    set_word(stack, static_cast<int>(halt));
    core_->set_program_counter(symbol(routine));
    for (int stops = 0; stops < 100000; ++stops) {
        isa::Stop stop = core_->run(1'000'000);
        cycles_ += stop.cycles;
        if (stop.reason == isa::StopReason::io) {
            stop = core_->step(*this);
            cycles_ += stop.cycles;
        }
        if (stop.reason == isa::StopReason::halt) {
            Registers result;
            for (int i = 0; i < 6; ++i) {
                result[i] = static_cast<std::uint16_t>(core_->reg(i));
            }
            return result;
        }
        if (stop.reason == isa::StopReason::trap) {
            throw std::runtime_error(
                fmt::format("{} trapped at {:06o}: {}", routine, stop.trap->pc, stop.trap->what));
        }
    }
    throw std::runtime_error(fmt::format("{} does not return", routine));
}

std::uint16_t BareNode::word(std::uint32_t address) const {
    const auto memory = core_->memory();
    return static_cast<std::uint16_t>(memory[address] | memory[address + 1] << 8);
}

std::uint16_t BareNode::word(std::string_view name, std::uint32_t offset) const {
    return word(symbol(name) + offset);
}

void BareNode::set_word(std::uint32_t address, int value) {
    const std::array<std::uint8_t, 2> bytes{static_cast<std::uint8_t>(value & 0xff),
                                            static_cast<std::uint8_t>(value >> 8 & 0xff)};
    core_->write_memory(address, bytes);
}

void BareNode::set_word(std::string_view name, int value, std::uint32_t offset) {
    set_word(symbol(name) + offset, value);
}

void BareNode::set_bytes(std::uint32_t address, std::span<const std::uint8_t> bytes) {
    core_->write_memory(address, bytes);
}

isa::Bus::Read BareNode::read(std::uint32_t address, int) {
    const auto where = decode_register(address);
    if (!where) {
        return {};
    }
    if (where->port) {
        return {Status::ok, kStatReady};
    }
    switch (static_cast<NodeRegister>(where->offset)) {
        case NodeRegister::rxany:
            return {Status::ok, kNoPort};
        case NodeRegister::txroom:
            return {Status::ok, kWaitRoom};
        default:
            return {Status::ok, 0};
    }
}

isa::Bus::Status BareNode::write(std::uint32_t address, std::uint32_t value, int) {
    const auto where = decode_register(address);
    if (!where) {
        return Status::fault;
    }
    if (where->port && where->offset == static_cast<std::uint8_t>(PortRegister::txaddr)) {
        transmit_address_ = value;
    } else if (where->port && where->offset == static_cast<std::uint8_t>(PortRegister::txlen)) {
        const auto message = core_->memory().subspan(transmit_address_, value);
        sent_.push_back({*where->port, {message.begin(), message.end()}});
    } else if (!where->port && where->offset == static_cast<std::uint8_t>(NodeRegister::credit)) {
        credit_ += static_cast<std::int16_t>(value);
    } else if (!where->port && where->offset == static_cast<std::uint8_t>(NodeRegister::fault)) {
        throw std::runtime_error(fmt::format("the program reports fault {}", value));
    }
    return Status::ok;
}

}  // namespace rasterloom::test
