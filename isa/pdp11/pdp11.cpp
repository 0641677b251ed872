// SPDX-License-Identifier: MIT
#include "isa/pdp11/pdp11.hpp"

#include "isa/pdp11/core.hpp"
#include "isa/pdp11/syntax.hpp"

#include <array>
#include <stdexcept>

namespace rasterloom::isa::pdp11 {
namespace {

constexpr std::array<std::string_view, 9> kRegisterNames = {"r0", "r1", "r2", "r3", "r4",
                                                            "r5", "sp", "pc", "psw"};

class Pdp11 final : public Isa {
  public:
    std::string_view name() const override { return "pdp11"; }
    std::string_view summary() const override {
        return "PDP-11/40 with the extended instruction set, without memory management";
    }
    int word_bits() const override { return 16; }
    int address_bits() const override { return 16; }
    std::uint32_t private_bytes() const override { return kIoPage; }
    std::span<const std::string_view> register_names() const override { return kRegisterNames; }
    std::span<const InstructionRow> instructions() const override { return instruction_table(); }
    std::span<const CostModelInfo> cost_models() const override { return pdp11::cost_models(); }
    const Syntax& syntax() const override { return pdp11_syntax(); }

    std::shared_ptr<const PreparedProgram> prepare(const Image& image,
                                                   const CostChoice& cost) const override {
        return std::make_shared<const Program>(image, cost);
    }

    std::unique_ptr<Core> make_core(std::shared_ptr<const PreparedProgram> program,
                                    const CoreOptions& options) const override {
        auto ours = std::dynamic_pointer_cast<const Program>(std::move(program));
        if (ours == nullptr)
            throw std::invalid_argument("the program was not prepared for a pdp11");
        return std::make_unique<Pdp11Core>(std::move(ours), options);
    }

    std::optional<InstructionCost> cost_of(std::span<const std::uint16_t> words,
                                           const CostChoice& cost) const override {
        return CostModel(cost).cost_of(words.front());
    }
};

}  // namespace

const Isa& pdp11_isa() {
    static const Pdp11 isa;
    return isa;
}

}  // namespace rasterloom::isa::pdp11
