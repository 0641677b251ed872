// SPDX-License-Identifier: MIT
// Writes programs for the ScriptCore, with labels.
#pragma once

#include "machine/node/registers.hpp"
#include "tests/node/script_core.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rasterloom {

constexpr std::uint32_t port_register(PortRegister which, int port = 0) {
    return kPortRegisters + kPortStride * static_cast<std::uint32_t>(port) +
           static_cast<std::uint32_t>(which);
}
constexpr std::uint32_t node_register(NodeRegister which) {
    return kNodeRegisters + static_cast<std::uint32_t>(which);
}

class Script {
  public:
    using Verb = ScriptCore::Verb;

    Script& op(Verb verb, std::uint32_t a = 0, std::uint32_t b = 0, std::uint32_t c = 0) {
        program_.push_back({verb, a, b, c});
        return *this;
    }
    Script& label(const std::string& name) {
        labels_[name] = here();
        return *this;
    }
    Script& jump(Verb verb, const std::string& target, std::uint32_t a = 0, std::uint32_t b = 0) {
        uses_.emplace_back(here(), target);
        return op(verb, a, b);
    }
    Script& work(std::uint32_t cycles) { return op(Verb::work, 0, 0, cycles); }
    Script& set(std::uint32_t reg, std::uint32_t value) { return op(Verb::set, reg, 0, value); }
    Script& load(std::uint32_t reg, std::uint32_t address,
                 std::uint32_t index = ScriptCore::kZero) {
        return op(Verb::load, reg, index, address);
    }
    Script& store(std::uint32_t reg, std::uint32_t address,
                  std::uint32_t index = ScriptCore::kZero) {
        return op(Verb::store, reg, index, address);
    }
    // Writes a constant through register 6.
    Script& write(std::uint32_t address, std::uint32_t value) {
        return set(6, value).store(6, address);
    }
    // Sends `bytes` bytes from address 0 through `port`.
    Script& send(int port, std::uint32_t bytes) {
        return write(port_register(PortRegister::txaddr, port), 0)
            .write(port_register(PortRegister::txlen, port), bytes);
    }
    Script& halt() { return op(Verb::halt); }

    std::uint32_t here() const { return static_cast<std::uint32_t>(program_.size()); }
    std::uint32_t address_of(const std::string& name) const { return labels_.at(name); }
    ScriptCore::Program program() const {
        ScriptCore::Program linked = program_;
        for (const auto& [place, target] : uses_) {
            linked[place].c = labels_.at(target);
        }
        return linked;
    }

  private:
    ScriptCore::Program program_;
    std::map<std::string, std::uint32_t> labels_;
    std::vector<std::pair<std::uint32_t, std::string>> uses_;
};

}  // namespace rasterloom
