// SPDX-License-Identifier: MIT
// The contract suite runs over every instruction set: the built-in ones and the toy, loaded from
// its shared object. What differs between them stands here: a few programs in their own assembly,
// and which rows of their tables may overlap.
#pragma once

#include "isa/assembler.hpp"
#include "isa/core.hpp"
#include "isa/isa.hpp"
#include "isa/registry.hpp"

#include <algorithm>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::isa::testing {

struct AllowedOverlap {
    std::string first;
    std::string second;
    std::string reason;
};

struct Subject {
    std::string name;
    std::string straight;  // arithmetic, memory and a loop; ends with a halt
    std::string endless;   // a loop of private instructions; its symbol "patch" is in it
    std::string halt;      // one instruction
    std::string wait;      // one instruction, then a halt; empty: there is none
    std::string reserved;  // an instruction, then what is none
    std::string store;  // moves something to the first I/O address, then the pointer goes on; then
                        // a halt; empty, as the next: there is no I/O page
    std::string load;   // moves something from there, then the pointer goes on; then a halt
    std::string interrupt;  // allows interrupts and loops; the handler halts at "handler"; empty:
                            // there are none
    int level = 0;          // of the interrupt
    std::uint32_t vector = 0;
    std::vector<AllowedOverlap> overlaps;
    bool code_in_memory = true;          // the program stands in the core's private memory
    std::vector<std::string> constants;  // registers that are what they are
};

std::ostream& operator<<(std::ostream& stream, const Subject& subject);

std::vector<Subject> subjects();

// The ISA of a subject.
const Isa& isa_of(const Subject& subject);

// A core with the source loaded; fails the test when it does not assemble.
std::unique_ptr<Core> core_running(const Isa& isa, std::string_view source,
                                   const CostChoice& cost = {});

// Everything a core shows of its state.
struct Snapshot {
    std::vector<std::uint32_t> registers;
    std::vector<std::uint8_t> memory;
    std::int64_t retired = 0;
    friend bool operator==(const Snapshot&, const Snapshot&) = default;
};
Snapshot snapshot_of(const Core& core, const Isa& isa);

// An I/O page that gives one answer to all accesses and counts them.
class AnsweringBus final : public Bus {
  public:
    explicit AnsweringBus(Status status) : status_(status) {}
    Read read(std::uint32_t address, int bytes) override;
    Status write(std::uint32_t address, std::uint32_t value, int bytes) override;
    void answer(Status status) { status_ = status; }
    int accesses() const { return accesses_; }
    std::uint32_t address() const { return address_; }

    static constexpr std::uint32_t kValue = 0x2a;

  private:
    Status status_;
    int accesses_ = 0;
    std::uint32_t address_ = 0;
};

class Contract : public ::testing::TestWithParam<Subject> {
  protected:
    const Isa& isa() const { return isa_of(GetParam()); }
    // From one instruction to the nearest place where another can begin.
    std::uint32_t step_of_addresses() const {
        return static_cast<std::uint32_t>(
            std::max(isa().word_bits() / 8 / isa().address_unit(), 1));
    }
    // Whether one address holds several words, whose slots its rows belong to.
    bool wide() const { return isa().address_unit() > isa().word_bits() / 8; }
};

// For tests of what not every instruction set has.
#define SKIP_WITHOUT(what, reason) \
    if (!(what))                   \
    GTEST_SKIP() << GetParam().name << " has no " << (reason)

}  // namespace rasterloom::isa::testing
