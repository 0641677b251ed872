// SPDX-License-Identifier: MIT
// The toy as an ISA, and the function a shared object exports for the registry to find it.
#include "isa/plugin.hpp"

#include "isa/cost_choice.hpp"
#include "isa/toy/core.hpp"
#include "isa/toy/instruction_table.hpp"
#include "isa/toy/syntax.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace rasterloom::isa::toy {
namespace {

constexpr std::array<std::string_view, 5> kRegisterNames = {"a", "x", "pc", "l", "f"};

class ToyIsa final : public Isa {
  public:
    std::string_view name() const override { return "toy"; }
    std::string_view summary() const override {
        return "accumulator machine of 8 bits, the example of a plug-in";
    }
    int word_bits() const override { return 8; }
    int address_bits() const override { return 16; }
    std::uint32_t private_bytes() const override { return kPrivateBytes; }
    std::span<const std::string_view> register_names() const override { return kRegisterNames; }
    std::span<const InstructionRow> instructions() const override { return instruction_table(); }
    std::span<const CostModelInfo> cost_models() const override { return cost_models_; }
    const Syntax& syntax() const override { return toy_syntax(); }

    std::shared_ptr<const PreparedProgram> prepare(const Image& image,
                                                   const CostChoice& cost) const override {
        auto program = std::make_shared<Program>();
        program->costs = costs(cost);
        program->image = image;
        return program;
    }

    std::unique_ptr<Core> make_core(std::shared_ptr<const PreparedProgram> program,
                                    const CoreOptions& options) const override {
        auto own = std::dynamic_pointer_cast<const Program>(program);
        if (own == nullptr) {
            throw std::invalid_argument("this program was not prepared by the toy");
        }
        const std::uint32_t bytes =
            options.memory_bytes == 0 ? kPrivateBytes : options.memory_bytes;
        return std::make_unique<ToyCore>(std::move(own), std::min(bytes, kPrivateBytes));
    }

    std::optional<InstructionCost> cost_of(std::span<const std::uint16_t> words,
                                           const CostChoice& cost) const override {
        const InstructionRow* row = words.empty() ? nullptr : find_instruction(words[0]);
        return row == nullptr ? std::nullopt
                              : std::optional(cost_of_instruction(*row, words[0], costs(cost)));
    }

  private:
    Costs costs(const CostChoice& choice) const {
        const ResolvedCosts resolved = resolve_costs(name(), cost_models_, choice);
        return {resolved.values[0], resolved.values[1]};
    }

    std::vector<CostModelInfo> cost_models_ = {
        {"bytes",
         "every byte fetched or moved costs (an example, from no publication)",
         {{"fetch", 1, "a byte of an instruction"}, {"data", 1, "a byte loaded or stored"}}}};
};

}  // namespace
}  // namespace rasterloom::isa::toy

extern "C" __attribute__((visibility("default"))) const rasterloom::isa::Plugin*
rasterloom_isa_plugin() {
    static const rasterloom::isa::toy::ToyIsa isa;
    static const rasterloom::isa::Plugin plugin{rasterloom::isa::kPluginVersion, &isa};
    return &plugin;
}
