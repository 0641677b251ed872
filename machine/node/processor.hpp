// SPDX-License-Identifier: MIT
// A node: a core on a clock, with the message ports and registers of programs/README.md.
//
// Time. An instruction begins on an edge of the clock; its accesses to the I/O page happen at that
// time. A stalled access is tried again at the first edge at which it can succeed, and then costs
// its instruction once. Interrupts wait while an access is stalled.
//
// Running ahead. Private instructions cost no event: the core runs until its next access to the I/O
// page, which may be far ahead of the rest of the machine, and only there lets the others catch up
// (reach_local_time). CREDIT, TXADDR and MARK need nobody to catch up: their effects leave with the
// core's own time. Nor does an access that takes or waits for what stays once it is there: a
// message, room, another phase. When it is not there yet, the core rests at its own time; it goes
// on from there when it comes earlier than that, and has stalled when it comes later. While a
// port's interrupt is enabled the core runs only to its horizon, the earliest time at which
// anything else happens. Every run ends at a multiple of so many cycles, so that the event loop
// sees even a program that loops for ever. None of this changes what is computed, or when.
//
// Where several partitions run at once, a slice is put off as soon as it begins: its thread first
// does what others may be waiting for, then goes on with slices, in small parts. Nobody can see
// whether a slice has been executed already: whoever could has it finished first.
#pragma once

#include "isa/core.hpp"
#include "isa/image.hpp"
#include "machine/kernel/clock.hpp"
#include "machine/kernel/component.hpp"
#include "machine/node/activity_meter.hpp"
#include "machine/node/frame_buffer.hpp"
#include "machine/node/guest_error.hpp"
#include "machine/node/message_ports.hpp"
#include "machine/node/registers.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rasterloom {

// Told of frame buffers, on the threads that run their processors.
class FrameBufferListener {
  public:
    virtual ~FrameBufferListener() = default;
    // The program writes FBCLEAR: so stands the frame buffer now, and it is about to be cleared.
    virtual void frame_buffer_cleared(NodeIndex node, const isa::Core& core,
                                      const FrameBuffer& frame_buffer) = 0;
};

class Processor final : public Component, private isa::Bus {
  public:
    struct Settings {
        NodeIndex node = 0;
        Clock clock = Clock::with_period(Duration::microseconds(1));
        MessagePorts::Settings ports;
        int max_message = 256;  // bytes; at least 1
        bool supervised =
            true;  // has a wire to a supervisor; else PHASE stays 0 and CREDIT is a guest error
        bool run_ahead =
            true;  // false: every instruction goes through the event queue, for comparison
        std::optional<FrameBuffer::Settings> frame_buffer;
        // For messages only.
        std::shared_ptr<const isa::Image> image;  // where a program counter comes from; may be null
        std::vector<std::string> register_names;  // isa::Core::reg(i)
        int radix = 8;                            // 8 or 16
    };

    // Throws std::invalid_argument when a number is out of range.
    Processor(std::string name, std::unique_ptr<isa::Core> core, const Settings& settings);

    // The wires of message port k, the one to the supervisor (only if supervised) and the one to
    // the frame-buffer bus (only if the frame buffer is written over it).
    static PortIndex transmit_port(int k) { return static_cast<PortIndex>(2 * k); }
    static PortIndex receive_port(int k) { return static_cast<PortIndex>(2 * k + 1); }
    PortIndex supervisor_port() const { return static_cast<PortIndex>(2 * ports_.count()); }
    PortIndex frame_buffer_port() const {
        return static_cast<PortIndex>(2 * ports_.count() + (settings_.supervised ? 1 : 0));
    }

    NodeIndex node() const { return settings_.node; }
    isa::Core& core() {
        return *core_;
    }  // to load and to inspect; not while the processor executes
    const isa::Core& core() const { return *core_; }
    const MessagePorts& message_ports() const { return ports_; }
    // None where the machine has none; to look at while the processor does not execute.
    const FrameBuffer* frame_buffer() const { return frame_buffer_ ? &*frame_buffer_ : nullptr; }
    bool halted() const { return next_ == Next::nothing; }
    std::uint16_t phase() const { return phase_; }
    const NodeStatistics& statistics() const { return meter_.statistics(); }
    Probe<NodeListener>& probe() { return meter_.probe(); }
    Probe<FrameBufferListener>& frame_buffer_probe() { return frame_buffer_probe_; }
    // Tells listeners of a stall that has begun before `time`, up to which the machine has come:
    // else they hear of it when it is over.
    void tell_stall_before(Time time) { begin_stall_before(time); }
    // What listeners will be told of when it is over; empty unless the processor is busy.
    std::optional<StateInterval> busy_interval() const { return meter_.busy_until(local_time_); }
    // Ends the interval in progress at `end`, for the books; to be called once, after the last run.
    void close_books(Time end);

    // What the processor is at, for a person; none when the program has halted.
    std::optional<std::string> activity() const;
    // A mistake of the program that somebody else found: the instruction at `program_counter` made
    // it at `time`. The registers have changed since and are left out.
    std::shared_ptr<const GuestError> mistake(Time time, std::uint32_t program_counter,
                                              std::string what) const;

    void start() override;
    void handle(const Event& event) override;
    void work_ahead(bool to_the_end) override;
    std::optional<std::string> waits_for() const override;
    // How far the processor has executed: at or after the simulation's now, unless it is stalled.
    Time reached() const override { return local_time_; }
    int weight() const override;

  private:
    // What the processor does when it next has control.
    enum class Next : std::uint8_t { run, step, wait, halt, fail, nothing };
    // Why a stalled access cannot go on.
    enum class Stall : std::uint8_t { none, transmit, receive, wait_for, interrupt, pixel };

    // processor.cpp: events and the loop of execution.
    void proceed();
    void execute();
    void finish_slice();
    bool put_off_slice();
    bool run_private_instructions();
    bool step_io_instruction();
    bool settle(const isa::Stop& stop);
    bool tell_tap();
    bool finish_wait();
    void spend(std::int64_t cycles);
    bool reach_local_time();
    std::int64_t budget() const;
    static std::int64_t slice_end(std::int64_t cycle);
    ActivityMeter::Executed executed() const {
        return {core_->instructions_retired(), cycles_executed_};
    }
    bool report_guest_error(std::string what, std::uint32_t program_counter);
    void fail();

    // processor_arrivals.cpp: what comes, and the stalls that it ends.
    void handle_arrival(const Event& event);
    void handle_message(const Event& event);
    void handle_phase(std::uint16_t phase);
    bool stall_is_over() const;
    NodeState kind_of_stall() const;
    void resume();
    void begin_stall_before(Time time);

    // processor_messages.cpp: for a person.
    GuestError::Details details(std::int64_t cycle, std::uint32_t program_counter,
                                std::string what) const;
    std::string place(std::uint32_t program_counter) const;

    // processor_prompt.cpp: registers that need nobody to catch up, while the core runs on.
    class Prompt final : public isa::PromptBus {
      public:
        explicit Prompt(Processor& processor) : processor_(processor) {}
        Read read(std::uint32_t address, int bytes) override;
        Status write(std::uint32_t address, std::uint32_t value, int bytes) override;

      private:
        Processor& processor_;
        std::pair<std::uint32_t, std::int64_t> read_at_{0, -1};  // pc, cycles_before
    };
    void foresee_stall(const RegisterAddress& address, std::uint32_t value);
    void come_to(std::int64_t cycles_of_run);
    bool may_read_promptly(const RegisterAddress& address) const;
    bool may_write_frame_buffer_promptly(std::uint32_t address, std::uint32_t value) const;
    bool may_write_promptly(const RegisterAddress& address, std::uint32_t value) const;

    // processor_io.cpp: the registers.
    Read read(std::uint32_t address, int bytes) override;
    Status write(std::uint32_t address, std::uint32_t value, int bytes) override;
    std::optional<std::uint32_t> read_port(int port, PortRegister which) const;
    std::optional<std::uint32_t> read_node(NodeRegister which);
    Status write_port(int port, PortRegister which, std::uint32_t value);
    Status write_node(NodeRegister which, std::uint32_t value);
    Status write_txlen(int port, std::uint32_t bytes);
    Status write_rxaddr(int port, std::uint32_t address);
    Status write_waitfor(std::uint32_t mask);
    Status write_credit(std::uint32_t value);
    Status stall(Stall kind, std::uint32_t argument);
    Status refuse(std::string what);
    bool wait_mask_holds(std::uint32_t mask) const;
    static bool needs_exact_time(const RegisterAddress& address, bool writes);
    bool is_known_to_wait(int port) const;
    bool is_longest_known() const;
    bool runs_freely() const;
    bool is_foreseen_read(const RegisterAddress& address) const;
    bool is_foreseen_write(const RegisterAddress& address) const;
    void tell_queue(ComponentId component, QueuePlace place, int change) const;
    void tell_consumed(int port, const Message& message) const;
    void transmit(std::optional<int> fresh_port = std::nullopt);
    void enable_interrupt(int port, bool receive, bool enable);
    void request(std::uint32_t vector);

    // processor_frame_buffer.cpp: the frame buffer's registers and its window in the I/O page.
    void add_frame_buffer(const FrameBuffer::Settings& settings);
    Status write_frame_buffer(std::uint32_t address, std::uint32_t value);
    Status select_row(std::uint32_t row);
    Status write_image_window(std::uint32_t address, std::uint32_t value);
    Status ask_for_bus(std::uint32_t column);

    struct PortState {
        std::uint32_t transmit_address = 0;
        bool transmit_interrupt = false;
        bool receive_interrupt = false;
    };

    Settings settings_;
    std::unique_ptr<isa::Core> core_;
    MessagePorts ports_;
    std::vector<PortState> port_states_;
    ActivityMeter meter_;
    std::optional<FrameBuffer> frame_buffer_;
    Probe<FrameBufferListener> frame_buffer_probe_;

    Next next_ = Next::run;
    std::string error_;           // to be reported as a guest error when everybody has caught up
    std::uint32_t error_at_ = 0;  // address of the instruction that made it
    std::int64_t cycle_ = 0;      // edge of the clock at which the next instruction begins
    std::int64_t cycles_executed_ = 0;
    Time local_time_;  // of that edge
    Prompt prompt_{*this};
    std::int64_t spent_of_run_ = 0;  // cycles of the core's run in progress that are spent already
    int advances_ = 0;       // without the event queue, since the processor was last given control
    std::int64_t part_ = 0;  // cycles of a slice put off to be executed next
    bool slice_put_off_ = false;
    bool works_ahead_ = false;  // has no exact time: what needs one waits for an event
    int enabled_interrupts_ = 0;
    bool interrupt_requested_ = false;  // since the core last ran

    EventId bound_by_ = kNoCause;  // what ended the last stall
    Stall stall_ = Stall::none;
    Stall foreseen_stall_ = Stall::none;  // why the core's run has ended
    std::uint32_t stall_argument_ = 0;    // the port, or the mask written to WAITFOR
    bool pixel_written_ = false;  // the word that stalled has gone over the frame-buffer bus
    bool must_catch_up_ = false;  // the access was put off until the others have caught up
    int accesses_ = 0;            // to the I/O page, by the instruction in progress
    std::uint32_t step_at_ = 0;   // address of that instruction
    int steps_in_no_time_ = 0;    // such instructions, and taps, since the local time last moved

    std::uint16_t phase_ = 0;
    std::uint16_t phase_read_ = 0;  // what the program read from PHASE last
};

}  // namespace rasterloom
