// SPDX-License-Identifier: MIT
#include "isa/pdp11/dispatch.hpp"

#include "isa/pdp11/code_cache.hpp"
#include "isa/pdp11/interpreter.hpp"
#include "isa/pdp11/program.hpp"

namespace rasterloom::isa::pdp11 {
namespace {

Exit leave(Machine* m, std::int64_t left, const Flags& f, Exit why) {
    m->left = left;
    m->flags = f;
    return why;
}

}  // namespace

Exit stop_before(RASTERLOOM_STATE) {
    m->r[kProgramCounter] = e->pc;
    return leave(m, left, {nz, c, v}, Exit::budget);
}

Exit stop_endless(RASTERLOOM_STATE) {
    m->r[kProgramCounter] = e->pc;
    return leave(m, left, {nz, c, v}, Exit::endless);
}

Exit look_up(RASTERLOOM_STATE) {
    const Flags f{nz, c, v};
    if (left < 0)
        return leave(m, left, f, Exit::budget);
    if (Machine::word_index(m->r[kProgramCounter]) >= m->memory_words) {
        return leave(m, left, f, Exit::recheck);
    }
    e = m->cache->enter(m->r[kProgramCounter]);
    RASTERLOOM_DISPATCH;
}

std::int64_t cost_of_first(const Machine* m, const Entry* e) {
    return cost_units(m->program->costs().attempt(m->load_word(e->pc)));
}

Exit interpret(RASTERLOOM_STATE) {
    m->r[kProgramCounter] = e->pc;
    m->flags = {nz, c, v};
    if (m->bus != nullptr) {
        m->bus->cycles_before = m->cycles_before + ((m->budget - left) >> kCycleShift);
        m->bus->pc = e->pc;
    }
    const Interpreter::Outcome outcome = Interpreter(*m, m->bus).step();
    const Flags f = m->flags;
    if (outcome.exit == Exit::io)
        return leave(m, left, f, Exit::io);
    left -= cost_units(outcome.cycles);
    if (outcome.exit != Exit::proceed)
        return leave(m, left, f, outcome.exit);
    if (outcome.cycles == 0 && --m->free_branches <= 0)
        return leave(m, left, f, Exit::endless);
    if (m->trace || m->requested > m->priority)
        return leave(m, left, f, Exit::recheck);
    RASTERLOOM_TAIL look_up(RASTERLOOM_UPDATED);
}

Exit undecoded(RASTERLOOM_STATE) {
    const Flags f{nz, c, v};
    e = m->cache->decode(e->pc);
    RASTERLOOM_DISPATCH;
}

Exit next_block(RASTERLOOM_STATE) {
    const Flags f{nz, c, v};
    RASTERLOOM_GO(e->pc);
}

Exit tapped(RASTERLOOM_STATE) {
    m->r[kProgramCounter] = e->pc;
    return leave(m, left, {nz, c, v}, Exit::recheck);
}

Exit run_handlers(Machine& m) {
    const Entry* e = m.cache->enter(m.r[kProgramCounter]);
    Exit exit = e->run(&m, e, m.left, m.flags.nz, m.flags.c, m.flags.v);
    while (exit == Exit::proceed) {
        exit = m.next->run(&m, m.next, m.left, m.flags.nz, m.flags.c, m.flags.v);
    }
    return exit;
}

}  // namespace rasterloom::isa::pdp11
