// SPDX-License-Identifier: MIT
// The contract of an instruction set: what it supplies so that assembler, disassembler,
// documentation and machine work with it. One table of rows feeds them all. docs/adding-an-isa.md
// walks through an example.
#pragma once

#include "isa/core.hpp"
#include "isa/image.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::isa {

class Syntax;

// One instruction form. `format` and `operation` number the ISA's own enumerations.
struct InstructionRow {
    std::uint32_t mask = 0;   // bits of the first word that identify the instruction; of a wide
                              // instruction word: of its slot's operation, as the ISA has it
    std::uint32_t match = 0;  // their values
    std::string_view mnemonic;
    int format = 0;            // which operands, and where they stand
    int operation = 0;         // which semantics
    std::string_view summary;  // one line for documentation
    int slot = 0;              // of a wide instruction word; rows of different slots go together
};

// A number of the cost model that a configuration may override.
struct CostParameter {
    std::string_view name;
    std::int64_t value = 0;  // cycles
    std::string_view summary;
};

struct CostModelInfo {
    std::string_view name;     // "parks", "strothotte", ...
    std::string_view summary;  // source included
    std::vector<CostParameter> parameters;
};

// A choice of cost model with overrides; names are checked by the ISA.
struct CostChoice {
    std::string model;  // empty: the ISA's first
    std::map<std::string, std::int64_t, std::less<>> overrides;
};

// Cycles an instruction spends: to fetch its words, and for its data.
struct InstructionCost {
    std::int64_t fetch = 0;
    std::int64_t data = 0;
    std::int64_t total() const { return fetch + data; }
};

// How the guest's traps end when nothing handles them.
enum class TrapPolicy : std::uint8_t {
    report_unhandled,  // a trap whose vector was never set up ends the run with StopReason::trap
    always_vector,     // as the bare hardware does
};

struct CoreOptions {
    std::uint32_t memory_bytes = 0;  // 0: as much as the ISA addresses privately
    TrapPolicy traps = TrapPolicy::report_unhandled;
};

// A program and cost model made ready for many cores: decoded once, shared, immutable.
class PreparedProgram {
  public:
    virtual ~PreparedProgram() = default;
};

// A program that does the same in fewer instruction words.
struct PackedImage {
    Image image;
    std::string report;  // for people: what was packed how well, a table
};

class Isa {
  public:
    virtual ~Isa() = default;
    virtual std::string_view name() const = 0;
    virtual std::string_view summary() const = 0;
    virtual int word_bits() const = 0;                // of an instruction word: 8, 16, 32
    virtual int address_bits() const = 0;             // of a program's address
    virtual int address_unit() const { return 1; }    // bytes that have one address in a program
    virtual std::uint32_t private_bytes() const = 0;  // memory below the I/O page
    virtual std::span<const std::string_view> register_names() const = 0;
    virtual std::span<const InstructionRow> instructions() const = 0;
    virtual std::span<const CostModelInfo> cost_models() const = 0;
    virtual const Syntax& syntax() const = 0;  // operands to and from text: isa/syntax.hpp

    // Throws std::invalid_argument, naming the model or parameter and the valid ones, when the
    // choice is not known.
    virtual std::shared_ptr<const PreparedProgram> prepare(const Image& image,
                                                           const CostChoice& cost) const = 0;
    // A core with the program loaded and its program counter at the entry. `program` must come from
    // this ISA's prepare.
    virtual std::unique_ptr<Core> make_core(std::shared_ptr<const PreparedProgram> program,
                                            const CoreOptions& options) const = 0;
    // Empty for an ISA whose instructions cannot be packed. Throws std::invalid_argument for an
    // image that prepare would refuse.
    virtual std::optional<PackedImage> pack(const Image& /*image*/) const { return std::nullopt; }
    // Cost of the instruction at the start of `words`, for listings. Empty for a word that is no
    // instruction.
    virtual std::optional<InstructionCost> cost_of(std::span<const std::uint16_t> words,
                                                   const CostChoice& cost) const = 0;
};

}  // namespace rasterloom::isa
