// SPDX-License-Identifier: MIT
// A core for tests that does what a tiler does, but for the drawing: it takes polygons at port 0,
// works on each of them for some cycles a vertex, keeps them, and plays its part in the frames.
#pragma once

#include "isa/core.hpp"
#include "machine/fabric/polygon_message.hpp"
#include "machine/node/message.hpp"
#include "machine/node/registers.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rasterloom {

class PolygonCore final : public isa::Core {
  public:
    // Private memory: enough for the windows of a frame buffer.
    explicit PolygonCore(std::int64_t cycles_per_vertex = 0, int phases_per_frame = 1)
        : cycles_per_vertex_(cycles_per_vertex),
          phases_per_frame_(static_cast<unsigned>(phases_per_frame)),
          memory_(0160000) {}

    std::vector<std::vector<Polygon>> frames{1};  // taken, the last one in progress

    isa::Stop run(std::int64_t budget) override {
        const std::int64_t cycles = std::min(budget, work_);
        work_ -= cycles;
        if (work_ > 0) {
            return {isa::StopReason::budget, cycles, {}};
        }
        ++retired_;
        return at_ == At::halt ? isa::Stop{isa::StopReason::halt, cycles + 1, {}}
                               : isa::Stop{isa::StopReason::io, cycles, {}};
    }

    isa::Stop step(isa::Bus& bus) override {
        switch (at_) {
            case At::receive:
                if (!store(bus, kPortRegisters + static_cast<unsigned>(PortRegister::rxaddr), 0)) {
                    return retry();
                }
                take();
                break;
            case At::credit:
                store(bus, kNodeRegisters + static_cast<unsigned>(NodeRegister::credit), 0xffff);
                at_ = At::wait;
                break;
            case At::wait:
                if (!store(bus, kNodeRegisters + static_cast<unsigned>(NodeRegister::waitfor),
                           kWaitPhase)) {
                    return retry();
                }
                at_ = At::phase;
                break;
            case At::phase: {
                const auto phase =
                    bus.read(kNodeRegisters + static_cast<unsigned>(NodeRegister::phase), 2);
                if (phase.status != isa::Bus::Status::ok) {
                    return retry();
                }
                if (phase.value == kRunOver) {
                    at_ = At::halt;
                } else if (phase.value % phases_per_frame_ != 0) {
                    at_ = At::credit;
                } else {
                    at_ = At::receive;
                    frames.emplace_back();
                }
                break;
            }
            case At::halt:
                break;
        }
        ++retired_;
        return {isa::StopReason::budget, 1, {}};
    }

    void request_interrupt(int, std::uint32_t) override {}
    void withdraw_interrupt(int, std::uint32_t) override {}
    bool interruptible() const override { return false; }
    std::uint32_t program_counter() const override { return static_cast<std::uint32_t>(at_); }
    void set_program_counter(std::uint32_t) override {}
    std::uint32_t reg(int) const override { return 0; }
    void set_reg(int, std::uint32_t) override {}
    std::span<const std::uint8_t> memory() const override { return memory_; }
    void write_memory(std::uint32_t address, std::span<const std::uint8_t> bytes) override {
        std::copy(bytes.begin(), bytes.end(), memory_.begin() + address);
    }
    void set_taps(std::span<const std::uint32_t>) override {}
    std::int64_t instructions_retired() const override { return retired_; }

  private:
    enum class At : std::uint8_t { receive, credit, wait, phase, halt };

    static bool store(isa::Bus& bus, std::uint32_t address, std::uint32_t value) {
        return bus.write(address, value, 2) == isa::Bus::Status::ok;
    }
    static isa::Stop retry() { return {isa::StopReason::retry, 0, {}}; }

    void take() {
        if (kind_of_polygon_message(memory_) == PolygonMessage::end_of_frame) {
            at_ = At::credit;
            return;
        }
        Polygon polygon;
        read_polygon(memory_, polygon);
        work_ = cycles_per_vertex_ * static_cast<std::int64_t>(polygon.vertices.size());
        frames.back().push_back(std::move(polygon));
    }

    std::int64_t cycles_per_vertex_;
    unsigned phases_per_frame_;
    std::vector<std::uint8_t> memory_;
    At at_ = At::receive;
    std::int64_t work_ = 0;  // cycles before the next access
    std::int64_t retired_ = 0;
};

}  // namespace rasterloom
