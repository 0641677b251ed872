// SPDX-License-Identifier: MIT
// What the VLIW's tests share: source to bundles, and to the text of its errors.
#pragma once

#include "isa/assembler.hpp"
#include "isa/vliw/program.hpp"
#include "isa/vliw/vliw.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace rasterloom::isa::vliw::testing {

inline Assembly assemble(std::string_view source) {
    return assemble_text(vliw_isa(), "t.s", source);
}

// The image of a source without errors.
inline Image image_of(std::string_view source) {
    Assembly assembly = assemble(source);
    EXPECT_TRUE(assembly.ok()) << to_string(assembly.diagnostics) << source;
    return std::move(assembly.image);
}

inline std::vector<Bundle> bundles(std::string_view source) {
    return Program(image_of(source)).bundles;
}

inline std::string complaint(std::string_view source) {
    return to_string(assemble(source).diagnostics);
}

}  // namespace rasterloom::isa::vliw::testing
