// SPDX-License-Identifier: MIT
// A small machine for tests to spoil, and what the loader says about it.
#pragma once

#include "machine/config/load.hpp"

#include <string>
#include <vector>

namespace rasterloom::config {

inline Locator source_tree() {
    return Locator(RASTERLOOM_SOURCE_DIR);
}

inline const std::string kSmallMachine =
    "machine: small\n"
    "topology: { kind: ring, nodes: 4 }\n"
    "nodes:\n"
    "  program: pdp11/token.s\n"
    "links:\n"
    "  latency: 1us\n";

inline MachineDescription load_text(const std::string& text,
                                    const std::vector<std::string>& overrides = {}) {
    std::vector<Override> changes;
    for (const std::string& override_text : overrides) {
        changes.push_back(parse_override(override_text));
    }
    return read_machine(text, "small.yaml", changes, source_tree());
}

// The message with which `text` is refused; "accepted" when it is not.
inline std::string refusal(const std::string& text,
                           const std::vector<std::string>& overrides = {}) {
    try {
        load_text(text, overrides);
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace rasterloom::config
