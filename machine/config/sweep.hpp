// SPDX-License-Identifier: MIT
// A sweep as its YAML file describes it: the product of machines, scenes and lists of values.
//
//     configs: [splitter16.yaml, interlace16.yaml]
//     scenes: [scenes/runway.yaml]                    # may be missing: each machine's own
//     vary: { fabric.processor_fifo: [1, 4, 16] }     # any key that --set takes; may be missing
//     frames: 2                                       # likewise
//     out: results/fifos                              # likewise
#pragma once

#include "machine/config/description.hpp"
#include "machine/config/locator.hpp"
#include "machine/config/value.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::config {

// One run of the sweep.
struct SweepPoint {
    // What it is of, as text: the same for the same configuration, scene and values wherever they
    // stand in their lists.
    std::string key;
    Value config;                      // the file's name
    std::optional<std::string> scene;  // likewise
    std::vector<std::string> values;   // [parameter], as YAML
    std::vector<Override> overrides;
};

struct SweepParameter {
    std::string key;
    std::vector<Override> values;
};

struct SweepDescription {
    std::string source;  // the file
    std::vector<Value> configs;
    std::vector<Override> scenes;
    std::vector<SweepParameter> parameters;  // by key
    std::optional<Override> frames;
    std::optional<std::string> out;  // folder

    std::size_t size() const;
    SweepPoint point(std::size_t index) const;  // below size()
};

// `file`: a path, or the name of a file in the data folder's configs/. Throws ConfigError for a
// file that is no sweep, a key that no machine has, a value that its key cannot take, and a sweep
// without points. What depends on the machine is found by load_point.
SweepDescription load_sweep(const std::string& file, const Locator& locator);
SweepDescription read_sweep(std::string_view text, const std::string& source,
                            const Locator& locator);

// Throws ConfigError. The machine is emulated by one thread: points run side by side.
MachineDescription load_point(const SweepPoint& point, const Locator& locator);

}  // namespace rasterloom::config
