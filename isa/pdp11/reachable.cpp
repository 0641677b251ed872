// SPDX-License-Identifier: MIT
#include "isa/pdp11/reachable.hpp"

#include <algorithm>

namespace rasterloom::isa::pdp11 {
namespace {

constexpr std::uint32_t kVectorsEnd = 0400;
constexpr std::uint32_t kLongestTable = 64;  // words

class Search {
  public:
    Search(const Image& image, const CodeView& view)
        : image_(image), view_(view), found_(view.words) {
        for (const Segment& segment : image.segments) {
            covered_.emplace_back(segment.address, segment.address + segment.bytes.size());
        }
    }

    std::vector<bool> run() {
        reach(image_.entry);
        if (image_.entry >= kVectorsEnd) {
            for (std::uint32_t vector = 4; vector < kVectorsEnd; vector += 4)
                reach_through(vector);
        }
        while (!pending_.empty()) {
            const std::uint32_t index = pending_.back();
            pending_.pop_back();
            follow(index);
        }
        return std::move(found_);
    }

  private:
    bool in_image(std::uint32_t address) const {
        return std::any_of(covered_.begin(), covered_.end(), [address](const auto& range) {
            return address >= range.first && address < range.second;
        });
    }

    void reach(std::uint32_t address) {
        address &= 0177777U;
        if ((address & 1U) != 0 || address / 2 >= view_.words || !in_image(address))
            return;
        if (found_[address / 2])
            return;
        found_[address / 2] = true;
        pending_.push_back(address / 2);
    }

    void reach_through(std::uint32_t pointer) {
        if ((pointer & 1U) == 0 && in_image(pointer))
            reach(view_.word(pointer / 2));
    }

    // A table of addresses ends where a word is none. With statement addresses known, it must be
    // one of those.
    void reach_table(std::uint32_t address) {
        for (std::uint32_t i = 0; i < kLongestTable; ++i) {
            const std::uint32_t at = (address + 2 * i) & 0177777U;
            if ((at & 1U) != 0 || !in_image(at))
                return;
            const std::uint32_t target = view_.word(at / 2);
            if ((target & 1U) != 0 || !in_image(target))
                return;
            if (!image_.lines.empty() && !image_.lines.contains(target))
                return;
            reach(target);
        }
    }

    void follow(std::uint32_t index) {
        const Decoded decoded = decode_instruction(view_, index);
        const unsigned word = view_.word(index);
        const std::uint32_t address = 2 * index;
        const std::uint32_t next = address + 2 * static_cast<std::uint32_t>(decoded.words);
        using enum Operation;
        const InstructionRow* row = find_instruction(word);
        if (row == nullptr)
            return;
        const auto format = static_cast<Format>(row->format);
        if (format == Format::branch) {
            reach(address + 2 + 2 * static_cast<std::uint32_t>(static_cast<std::int8_t>(word)));
        } else if (format == Format::sob) {
            reach(address + 2 - 2 * (word & 077U));
        } else if (decoded.op == jmp || decoded.op == jsr) {
            follow_jump(decoded, word, address);
        } else if ((word & 0170077U) == 0010007U && ((word >> 6) & 070U) == 060U) {
            reach_table(view_.word(index + 1));  // MOV table(R), PC
        }
        const bool ends = decoded.op == br || decoded.op == jmp || decoded.op == rts ||
                          decoded.op == rti || decoded.op == rtt || decoded.op == mark;
        if (!ends)
            reach(next);
    }

    void follow_jump(const Decoded& decoded, unsigned word, std::uint32_t address) {
        const unsigned spec = word & 077U;
        if (spec == 037 || spec == 067)
            reach(decoded.entry.b);
        if (spec == 077)
            reach_through(decoded.entry.b);
        if ((spec & 070U) == 070U && spec != 077)
            reach_table(view_.word(address / 2 + 1));
    }

    const Image& image_;
    const CodeView& view_;
    std::vector<bool> found_;
    std::vector<std::uint32_t> pending_;
    std::vector<std::pair<std::uint32_t, std::size_t>> covered_;
};

}  // namespace

std::vector<bool> reachable_instructions(const Image& image, const CodeView& view) {
    return Search(image, view).run();
}

}  // namespace rasterloom::isa::pdp11
