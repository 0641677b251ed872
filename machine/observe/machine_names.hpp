// SPDX-License-Identifier: MIT
// What a machine's parts are called for a person, and how they belong together.
#pragma once

#include "machine/kernel/event.hpp"
#include "machine/kernel/time.hpp"
#include "machine/node/message.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rasterloom::observe {

// "node" and "P31-123", "link" and "P31-123 > P28-114".
struct ComponentLabel {
    std::string kind;
    std::string name;
};

struct LinkEnds {
    ComponentId link{};
    NodeIndex from = 0;
    NodeIndex to = 0;
};

struct MachineNames {
    std::string machine;
    std::vector<ComponentLabel> components;  // by id
    std::vector<ComponentId> nodes;          // [node]
    std::vector<LinkEnds> links;             // of a graph
    std::vector<ComponentId> parts;          // of a machine that deals out the screen; a sequencer
    std::vector<std::string> activities;     // as MARK names them; may be shorter, entries empty
    std::vector<std::string> phases;         // of a frame; likewise
    Duration latency;                        // of the wires that carry messages
    Duration cycle;                          // of the nodes' clock

    const ComponentLabel& label(ComponentId id) const {
        return components[static_cast<std::size_t>(id)];
    }
    std::string phase_name(std::int64_t phase) const {
        const auto number = static_cast<std::size_t>(phase);
        return number < phases.size() && !phases[number].empty() ? phases[number]
                                                                 : "phase " + std::to_string(phase);
    }
};

}  // namespace rasterloom::observe
