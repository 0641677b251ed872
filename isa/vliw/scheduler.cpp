// SPDX-License-Identifier: MIT
#include "isa/vliw/scheduler.hpp"

#include "isa/vliw/list_scheduler.hpp"
#include "isa/vliw/program.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::isa::vliw {
namespace {

// Dependences are looked for between any two bundles of a block; longer ones are cut.
constexpr std::uint32_t kLongestBlock = 2048;

// Whether all that stands before the bundle must have happened when it has, and nothing behind it.
bool ends_block(SeqOp op) {
    return leaves(op) || op == SeqOp::frame || op == SeqOp::phase;
}

class Packer {
  public:
    explicit Packer(const Image& image) : image_(image), program_(image) {
        result_.image = image;
        result_.image.lines.clear();
        find_leaders();
    }

    Packed pack() {
        for (const Segment& segment : image_.segments) {
            pack_segment(segment);
        }
        relocate();
        return std::move(result_);
    }

  private:
    void find_leaders() {
        leaders_ = {0, image_.entry};
        for (const std::string& label : image_.labels) {
            leaders_.insert(image_.symbols.at(label));
            label_at_.emplace(image_.symbols.at(label), label);
        }
        for (std::uint32_t address = 0; address < program_.bundles.size(); ++address) {
            const Bundle::Sequencer& seq = program_.bundles[address].seq;
            if (has_address(seq.op)) {
                leaders_.insert(seq.target);
            }
            if (ends_block(seq.op)) {
                leaders_.insert(address + 1);
            }
        }
    }

    void pack_segment(const Segment& segment) {
        const std::uint32_t first = segment.address / kBytesPerBundle;
        const auto end = first + static_cast<std::uint32_t>(segment.bytes.size() / kBytesPerBundle);
        new_address_ = first;
        code_.emplace_back();
        for (std::uint32_t from = first; from < end;) {
            const auto leader = leaders_.upper_bound(from);
            const std::uint32_t next = leader == leaders_.end() ? end : std::min(*leader, end);
            const std::uint32_t to = std::min(next, from + kLongestBlock);
            pack_block(from, to);
            from = to;
        }
        moved_.emplace(end, new_address_);
    }

    void pack_block(std::uint32_t from, std::uint32_t to) {
        moved_.emplace(from, new_address_);
        const auto block = std::span<const Bundle>(program_.bundles).subspan(from, to - from);
        const auto bundles = schedule(block, ends_block(block.back().seq.op));
        PackedPart& part = part_at(from);
        part.bundles_before += static_cast<std::int64_t>(block.size());
        part.bundles += static_cast<std::int64_t>(bundles.size());
        for (const ScheduledBundle& scheduled : bundles) {
            part.operations += operations_in(scheduled.bundle);
            if (const SourceLocation* where = image_.source_of(
                    from + static_cast<std::uint32_t>(scheduled.sources.front()))) {
                result_.image.lines.emplace(new_address_, *where);
            }
            code_.back().push_back(scheduled.bundle);
            ++new_address_;
        }
    }

    PackedPart& part_at(std::uint32_t address) {
        const auto label = label_at_.find(address);
        if (label != label_at_.end() || result_.parts.empty()) {
            result_.parts.push_back({label == label_at_.end() ? "" : label->second, 0, 0, 0});
        }
        return result_.parts.back();
    }

    std::uint32_t moved(std::uint32_t address) const {
        const auto found = moved_.find(address);
        return found == moved_.end() ? address : found->second;
    }

    void relocate() {
        result_.image.entry = moved(image_.entry);
        for (const std::string& label : image_.labels) {
            std::uint32_t& value = result_.image.symbols.at(label);
            value = moved(value);
        }
        for (std::size_t i = 0; i < code_.size(); ++i) {
            Segment& segment = result_.image.segments[i];
            segment.bytes.clear();
            for (Bundle& bundle : code_[i]) {
                if (has_address(bundle.seq.op)) {
                    bundle.seq.target = static_cast<std::uint16_t>(moved(bundle.seq.target));
                }
                append(segment.bytes, bundle);
            }
        }
    }

    static void append(std::vector<std::uint8_t>& bytes, const Bundle& bundle) {
        for (const std::uint16_t word : encode(bundle)) {
            bytes.push_back(static_cast<std::uint8_t>(word & 0xff));
            bytes.push_back(static_cast<std::uint8_t>(word >> 8));
        }
    }

    const Image& image_;
    const Program program_;
    Packed result_;
    std::set<std::uint32_t> leaders_;                // where blocks begin
    std::map<std::uint32_t, std::string> label_at_;  // the first of several
    std::map<std::uint32_t, std::uint32_t> moved_;   // from the old address of a block to the new
    std::vector<std::vector<Bundle>> code_;          // by segment
    std::uint32_t new_address_ = 0;
};

std::string row(std::string_view label, const PackedPart& part) {
    return fmt::format("{:<24}{:>12}{:>10}{:>10}{:>14.2f}\n", label, part.operations,
                       part.bundles_before, part.bundles,
                       static_cast<double>(part.operations) / static_cast<double>(part.bundles));
}

}  // namespace

Packed pack(const Image& image) {
    return Packer(image).pack();
}

std::string to_string(const std::vector<PackedPart>& parts) {
    std::string text = fmt::format("{:<24}{:>12}{:>10}{:>10}{:>14}\n", "from label", "operations",
                                   "bundles", "packed", "a bundle");
    PackedPart all;
    for (const PackedPart& part : parts) {
        text += row(part.label.empty() ? "-" : part.label, part);
        all.operations += part.operations;
        all.bundles_before += part.bundles_before;
        all.bundles += part.bundles;
    }
    return text + row("all", all);
}

}  // namespace rasterloom::isa::vliw
