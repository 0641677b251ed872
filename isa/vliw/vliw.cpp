// SPDX-License-Identifier: MIT
#include "isa/vliw/vliw.hpp"

#include "isa/cost_choice.hpp"
#include "isa/vliw/core.hpp"
#include "isa/vliw/instruction_table.hpp"
#include "isa/vliw/program.hpp"
#include "isa/vliw/scheduler.hpp"
#include "isa/vliw/syntax.hpp"

#include <array>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::isa::vliw {
namespace {

constexpr std::array<std::string_view, 40> kRegisterNames = {
    "r0",  "r1",  "r2",  "r3",  "r4",  "r5",  "r6",  "r7",  "r8",  "r9",
    "r10", "r11", "r12", "r13", "r14", "r15", "r16", "r17", "r18", "r19",
    "r20", "r21", "r22", "r23", "r24", "r25", "r26", "r27", "r28", "r29",
    "r30", "r31", "c0",  "c1",  "c2",  "c3",  "c4",  "c5",  "c6",  "c7"};

class Vliw final : public Isa {
  public:
    std::string_view name() const override { return "vliw"; }
    std::string_view summary() const override {
        return "the Princeton Engine's 144-bit instruction word, for lanes in lock step";
    }
    int word_bits() const override { return 16; }
    int address_bits() const override { return 16; }
    int address_unit() const override { return kBytesPerBundle; }
    std::uint32_t private_bytes() const override { return kMemoryBytes; }
    std::span<const std::string_view> register_names() const override { return kRegisterNames; }
    std::span<const InstructionRow> instructions() const override { return instruction_table(); }
    std::span<const CostModelInfo> cost_models() const override { return cost_models_; }
    const Syntax& syntax() const override { return vliw_syntax(); }

    std::shared_ptr<const PreparedProgram> prepare(const Image& image,
                                                   const CostChoice& cost) const override {
        resolve_costs(name(), cost_models_, cost);
        return std::make_shared<const Program>(image);
    }

    std::unique_ptr<Core> make_core(std::shared_ptr<const PreparedProgram> program,
                                    const CoreOptions& options) const override {
        auto ours = std::dynamic_pointer_cast<const Program>(std::move(program));
        if (ours == nullptr) {
            throw std::invalid_argument("the program was not prepared for a vliw");
        }
        if (options.memory_bytes != 0 && options.memory_bytes != kMemoryBytes) {
            throw std::invalid_argument(fmt::format("a lane has {} bytes of memory, not {}",
                                                    kMemoryBytes, options.memory_bytes));
        }
        return std::make_unique<LaneCore>(std::move(ours));
    }

    std::optional<PackedImage> pack(const Image& image) const override {
        Packed packed = vliw::pack(image);
        return PackedImage{std::move(packed.image), to_string(packed.parts)};
    }

    std::optional<InstructionCost> cost_of(std::span<const std::uint16_t> words,
                                           const CostChoice& cost) const override {
        resolve_costs(name(), cost_models_, cost);
        if (words.size() < kWordsPerBundle) {
            return std::nullopt;
        }
        const auto bundle = decode(words.first<kWordsPerBundle>());
        return bundle && !conflict(*bundle)
                   ? std::optional(InstructionCost{1, cycles_of(*bundle) - 1})
                   : std::nullopt;
    }

  private:
    std::vector<CostModelInfo> cost_models_ = {{"princeton",
                                                "a bundle a cycle; slow memory 2, a shift its "
                                                "distance, a broadcast 5 (Eldridge 1995, 2.1)",
                                                {}}};
};

}  // namespace

const Isa& vliw_isa() {
    static const Vliw isa;
    return isa;
}

}  // namespace rasterloom::isa::vliw
