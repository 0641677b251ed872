// SPDX-License-Identifier: MIT
#include "isa/pdp11/decoder.hpp"

#include "isa/pdp11/alu.hpp"

#include <optional>

namespace rasterloom::isa::pdp11 {
namespace {

struct OperandPlace {
    Place place = Place::reg;
    std::uint16_t extension = 0;
    std::uint8_t reg = 0;
};

class InstructionDecoder {
  public:
    InstructionDecoder(const CodeView& view, std::uint32_t index) : view_(view), next_(index + 1) {
        word_ = view.word(index);
        out_.entry.run = &interpret;
        out_.special = true;
        out_.entry.pc = static_cast<std::uint16_t>(2 * index);
        out_.entry.cost = cost_units(view.costs->attempt(word_));
        block_ = index / kBlockWords;
    }

    Decoded decode() {
        const InstructionRow* row = find_instruction(word_);
        if (row == nullptr)
            return out_;
        out_.op = static_cast<Operation>(row->operation);
        const Handler handler = choose(static_cast<Format>(row->format));
        // Past the end of memory the interpreter finds the words missing and traps.
        if (handler != nullptr && next_ <= view_.words) {
            out_.entry.run = handler;
            out_.special = false;
        }
        out_.words = static_cast<int>(next_ - out_.entry.pc / 2U);
        return out_;
    }

  private:
    bool free() const { return out_.entry.cost < cost_units(1, 0); }

    Handler choose(Format format) {
        switch (format) {
            case Format::twofold:
                return twofold();
            case Format::single:
                return out_.op == Operation::jmp ? jump() : single();
            case Format::register_dst:
                return out_.op == Operation::jsr ? call() : exclusive_or();
            case Format::register_src:
                return extended();
            case Format::branch:
                return branch(static_cast<std::int8_t>(word_));
            case Format::sob:
                out_.entry.src = (word_ >> 6) & 7U;
                return usual_register(out_.entry.src) ? branch(-static_cast<int>(word_ & 077U))
                                                      : nullptr;
            case Format::rts:
                out_.entry.dst = word_ & 7U;
                if (free() || out_.entry.dst == kStackPointer)
                    return nullptr;
                return return_handler(out_.entry.dst == kProgramCounter);
            default:
                if (out_.op != Operation::condition_codes)
                    return nullptr;
                out_.entry.a = static_cast<std::uint16_t>(~(word_ & 017U) & 017U);
                out_.entry.b = (word_ & 020U) != 0 ? word_ & 017U : 0U;
                return condition_codes_handler();
        }
    }

    static bool usual_register(unsigned reg) { return reg != kProgramCounter; }

    // Takes the operand's extension word; empty for what only the interpreter does.
    std::optional<OperandPlace> operand(unsigned spec, bool byte, bool only_read) {
        const unsigned mode = (spec >> 3) & 7U;
        const auto reg = static_cast<std::uint8_t>(spec & 7U);
        if (mode >= 6 || (reg == kProgramCounter && (mode == 2 || mode == 3))) {
            return with_extension(mode, reg, only_read);
        }
        if (reg == kProgramCounter || (byte && reg == kStackPointer && (mode == 2 || mode == 4))) {
            return std::nullopt;
        }
        switch (mode) {
            case 0:
                return OperandPlace{Place::reg, 0, reg};
            case 1:
                return OperandPlace{Place::deferred, 0, reg};
            case 2:
                return OperandPlace{Place::increment, 0, reg};
            case 3:
                return OperandPlace{Place::increment_deferred, 0, reg};
            case 4:
                return OperandPlace{reg == kStackPointer ? Place::push : Place::decrement, 0, reg};
            default:
                return std::nullopt;  // @-(R)
        }
    }

    std::optional<OperandPlace> with_extension(unsigned mode, std::uint8_t reg, bool only_read) {
        std::uint16_t extension = next_ < view_.words ? view_.word(next_) : std::uint16_t{0};
        ++next_;
        if (reg != kProgramCounter) {
            return OperandPlace{mode == 6 ? Place::indexed : Place::indexed_deferred, extension,
                                reg};
        }
        if (mode >= 6)
            extension = static_cast<std::uint16_t>(extension + 2 * next_);
        if (mode == 2) {
            if (!only_read)
                return std::nullopt;
            return OperandPlace{Place::immediate, extension, 0};
        }
        return OperandPlace{mode == 7 ? Place::absolute_deferred : Place::absolute, extension, 0};
    }

    std::optional<OperandPlace> destination(unsigned spec, bool byte) {
        const auto place = operand(spec, byte, only_reads(out_.op));
        if (place) {
            out_.dst = place->place;
            out_.entry.b = place->extension;
            out_.entry.dst = place->reg;
        }
        return place;
    }

    Handler twofold() {
        const bool byte = is_byte(out_.op);
        const auto src = operand((word_ >> 6) & 077U, byte, true);
        // The second operand's words are counted whether or not the first has a handler.
        const auto dst = destination(word_ & 077U, byte);
        if (!src || !dst)
            return nullptr;
        out_.src = src->place;
        out_.entry.a = src->extension;
        out_.entry.src = src->reg;
        return byte ? twofold_byte_handler(out_.op, src->place, dst->place)
                    : twofold_word_handler(out_.op, src->place, dst->place);
    }

    Handler single() {
        const auto dst = destination(word_ & 077U, is_byte(out_.op));
        return dst ? single_handler(out_.op, dst->place) : nullptr;
    }

    Handler exclusive_or() {
        const auto dst = destination(word_ & 077U, false);
        out_.entry.src = (word_ >> 6) & 7U;
        if (!dst || !usual_register(out_.entry.src))
            return nullptr;
        return twofold_word_handler(out_.op, Place::reg, dst->place);
    }

    Handler extended() {
        const auto operand_place = operand(word_ & 077U, false, true);
        out_.entry.src = (word_ >> 6) & 7U;
        // The pair of R6 is R6 and PC.
        if (!operand_place || out_.entry.src >= kStackPointer)
            return nullptr;
        out_.dst = operand_place->place;
        out_.entry.b = operand_place->extension;
        out_.entry.dst = operand_place->reg;
        return extended_handler(out_.op, operand_place->place);
    }

    Handler jump() {
        const auto target = destination(word_ & 077U, false);
        return target && !free() ? jump_handler(target->place) : nullptr;
    }

    Handler call() {
        const auto target = destination(word_ & 077U, false);
        const unsigned link = (word_ >> 6) & 7U;
        out_.entry.src = static_cast<std::uint8_t>(link);
        out_.entry.a = static_cast<std::uint16_t>(2 * next_);
        if (!target || free() || link == kStackPointer)
            return nullptr;
        return call_handler(target->place, link == kProgramCounter);
    }

    Handler branch(int offset) {
        const int target = static_cast<int>(next_) + offset;
        if (target >= 0 && static_cast<std::uint32_t>(target) / kBlockWords == block_) {
            out_.entry.a = static_cast<std::uint16_t>(1 + offset);
            return near_branch_handler(out_.op, free());
        }
        out_.entry.b = static_cast<std::uint16_t>(2 * target);
        return free() ? nullptr : far_branch_handler(out_.op);
    }

    const CodeView& view_;
    std::uint32_t next_;  // word index after what has been taken
    std::uint32_t block_ = 0;
    std::uint16_t word_ = 0;
    Decoded out_;
};

}  // namespace

Decoded decode_instruction(const CodeView& view, std::uint32_t index) {
    return InstructionDecoder(view, index).decode();
}

Decoded decode_fused(const CodeView& view, std::uint32_t index) {
    Decoded first = decode_instruction(view, index);
    const std::uint32_t next = index + static_cast<std::uint32_t>(first.words);
    if (first.special || next >= view.words || next / kBlockWords != index / kBlockWords)
        return first;
    const Decoded second = decode_instruction(view, next);
    if (second.special)
        return first;
    if (const Handler handler = fused_handler(first, second); handler != nullptr) {
        first.entry.run = handler;
        first.entry.cost += second.entry.cost;
        first.words += second.words;
    }
    return first;
}

namespace {

Entry entry_of(Handler handler, std::uint32_t index) {
    Entry entry;
    entry.run = handler;
    entry.pc = static_cast<std::uint16_t>(2 * index);
    return entry;
}

}  // namespace

Entry undecoded_entry(std::uint32_t index) {
    return entry_of(&undecoded, index);
}

Entry next_block_entry(std::uint32_t index) {
    return entry_of(&next_block, index);
}

Entry tapped_entry(std::uint32_t index) {
    return entry_of(&tapped, index);
}

}  // namespace rasterloom::isa::pdp11
