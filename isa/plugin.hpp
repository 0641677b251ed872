// SPDX-License-Identifier: MIT
// An instruction set in a shared object of its own. The object exports one C function,
//
//   extern "C" const rasterloom::isa::Plugin* rasterloom_isa_plugin();
//
// and is built with the same compiler and standard library as the emulator, for the contract passes
// C++ types.
#pragma once

#include "isa/isa.hpp"

#include <cstdint>

namespace rasterloom::isa {

// Goes up with every change to core.hpp, image.hpp, isa.hpp or syntax.hpp that an existing plug-in
// would not survive.
inline constexpr std::uint32_t kPluginVersion = 3;

inline constexpr const char* kPluginSymbol = "rasterloom_isa_plugin";

struct Plugin {
    std::uint32_t version = kPluginVersion;  // stays first
    const Isa* isa = nullptr;                // lives as long as the shared object is loaded
};

using PluginFunction = const Plugin*();

}  // namespace rasterloom::isa
