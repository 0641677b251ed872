// SPDX-License-Identifier: MIT
// What the array of a lock-step machine did.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rasterloom::observe {

// Bundles that all lanes executed together.
struct BundleCounts {
    std::int64_t cycles = 0;
    std::int64_t bundles = 0;
    std::int64_t operations = 0;  // slots that did something

    double parallelism() const;  // operations a bundle; 0 without any
};

struct ArrayReport {
    struct Phase {
        std::int64_t phase = 0;  // of the frame
        BundleCounts counts;
        double awake = 0;      // share of the lanes, on average over its cycles
        double real_time = 0;  // its cycles' time over the host's, idle ones not counted; 0: not
                               // known. In no file, since it depends on the host
    };
    // From a label that is called, or that the procedure pointer names, to the next one.
    struct Procedure {
        std::string name;
        std::string file;  // seen from the program's folder
        int line = 0;
        std::int64_t calls = 0;  // how often its first bundle was executed
        BundleCounts counts;
    };

    std::int64_t lanes = 0;
    bool line_locked = false;
    std::int64_t line = 0;              // cycles of a scanline, if it is
    std::int64_t scanlines = 0;         // begun; without line-locking how often `line` was executed
    std::int64_t idle_cycles = 0;       // between `line` and the next scanline
    std::int64_t shifts = 0;            // bundles that shift the ring
    std::int64_t places = 0;            // by which they did
    std::vector<Phase> phases;          // over all frames
    std::vector<Procedure> procedures;  // in the order of their addresses, those executed

    BundleCounts total() const;  // of the phases
    double awake() const;        // share of the lanes
};

// A row a procedure.
std::string procedures_csv(const ArrayReport& array);

// Some lines for a person, with a newline after each. `phase_names[n]`: phase n.
std::string array_summary(const ArrayReport& array, const std::vector<std::string>& phase_names);

}  // namespace rasterloom::observe
