// SPDX-License-Identifier: MIT
#include "tests/isa/contract.hpp"

#include "isa/pdp11/pdp11.hpp"
#include "isa/vliw/vliw.hpp"

#include <filesystem>

namespace rasterloom::isa::testing {
namespace {

constexpr const char* kAllBitsFixed =
    "a condition-code instruction with all its bits fixed has a name of its own";

Subject pdp11() {
    Subject subject;
    subject.name = "pdp11";
    subject.straight =
        ". = 1000\nstart: mov #1000, sp\n mov #5, r0\n clr r1\n mov #table, r2\n1$: add r0, r1\n "
        "mov r1, (r2)+\n"
        " mul #3, r1\n ash #-1, r1\n movb r1, @#table+40\n jsr pc, double\n sob r0, 1$\n halt\n"
        "double: asl table\n rol table+2\n bcc 2$\n inc table+4\n2$: rts pc\n.even\ntable: .blkw "
        "40\n.end start\n";
    subject.endless = ". = 1000\nloop: inc r0\npatch: add r0, r1\n br loop\n";
    subject.halt = "halt";
    subject.wait = ". = 1000\n wait\n halt\n";
    subject.reserved = ". = 1000\n nop\n .word 7\n";
    subject.store = ". = 1000\n mov #160000, r1\n mov #123, r0\n mov r0, (r1)+\n halt\n";
    subject.load = ". = 1000\n mov #160000, r1\n mov (r1)+, r2\n halt\n";
    subject.interrupt =
        ". = 300\n .word handler, 340\n. = 1000\nstart: mov #1000, sp\n clr @#177776\nloop: br "
        "loop\nhandler: halt\n"
        ".end start\n";
    subject.level = 5;
    subject.vector = 0300;
    for (const char* name :
         {"nop", "clc", "clv", "clz", "cln", "ccc", "sec", "sev", "sez", "sen", "scc"}) {
        subject.overlaps.push_back({name, "ccodes", kAllBitsFixed});
    }
    return subject;
}

Subject toy() {
    Subject subject;
    subject.name = "toy";
    subject.straight =
        "start: ldx #table\n lda #0\nloop: add #3\n sta (x)+\n sub table\n sta table+9\n add (x)\n "
        "bne next\n nop\n"
        "next: lda count\n sub #1\n sta count\n bne loop\n hlt\ncount: .byte 20\ntable: .blkb 40\n";
    subject.endless = "loop: add #1\npatch: sta 100\n jmp loop\n";
    subject.halt = "hlt";
    subject.wait = " wai\n hlt\n";
    subject.reserved = " nop\n .byte 0xff\n";
    subject.store = " ldx #0xe000\n lda #83\n sta (x)+\n hlt\n";
    subject.load = " ldx #0xe000\n lda (x)+\n hlt\n";
    subject.interrupt = " ei\nloop: jmp loop\nhandler: hlt\n";
    subject.level = 1;
    subject.vector = 4;
    return subject;
}

// A lane by itself: no interrupt, no wait, no I/O page, and its program outside of its memory.
Subject vliw() {
    Subject subject;
    subject.name = "vliw";
    subject.straight =
        "start: setc c0, 20\n mov r2, #0x100\nloop: add r1, r1, #3 | mul r3, r1, r1, 4\n"
        " st r1, (r2) | add r2, r2, #1\n sts r3, 2, 0x50(r2)\n lds r4, 2, 0x4f(r2)\n call double\n"
        " put r4\n right 5\n get r5 | dec c0, loop\n cast | halt\n"
        "double: adds r4, r4, r4\n tltu r4, r1\n slt\n mov r6, r4\n wake | ret\n";
    subject.endless = "loop: add r1, r1, #1\npatch: add r2, r2, r1\n lds r3, 0, 7\n jump loop\n";
    subject.halt = " halt\n";
    subject.reserved = " nop\n";
    subject.code_in_memory = false;
    subject.constants = {"r0"};
    return subject;
}

IsaRegistry make_registry() {
    IsaRegistry registry;
    registry.add(pdp11::pdp11_isa());
    registry.add(vliw::vliw_isa());
    registry.load(std::filesystem::path(RASTERLOOM_BINARY_DIR) / "librasterloom_toy.so");
    return registry;
}

}  // namespace

std::ostream& operator<<(std::ostream& stream, const Subject& subject) {
    return stream << subject.name;
}

std::vector<Subject> subjects() {
    return {pdp11(), vliw(), toy()};
}

const Isa& isa_of(const Subject& subject) {
    static const IsaRegistry registry = make_registry();
    return registry.find(subject.name);
}

std::unique_ptr<Core> core_running(const Isa& isa, std::string_view source,
                                   const CostChoice& cost) {
    const Assembly assembly = assemble_text(isa, "contract.s", source);
    EXPECT_TRUE(assembly.ok()) << to_string(assembly.diagnostics);
    return isa.make_core(isa.prepare(assembly.image, cost), {});
}

Snapshot snapshot_of(const Core& core, const Isa& isa) {
    Snapshot snapshot;
    for (int i = 0; i < static_cast<int>(isa.register_names().size()); ++i) {
        snapshot.registers.push_back(core.reg(i));
    }
    snapshot.memory.assign(core.memory().begin(), core.memory().end());
    snapshot.retired = core.instructions_retired();
    return snapshot;
}

Bus::Read AnsweringBus::read(std::uint32_t address, int) {
    ++accesses_;
    address_ = address;
    return {status_, kValue};
}

Bus::Status AnsweringBus::write(std::uint32_t address, std::uint32_t, int) {
    ++accesses_;
    address_ = address;
    return status_;
}

}  // namespace rasterloom::isa::testing
