// SPDX-License-Identifier: MIT
// Shared objects the registry must refuse: with OLD_PLUGIN one of another version, else one that is
// no plug-in at all.
#include "isa/plugin.hpp"

#ifdef OLD_PLUGIN
extern "C" const rasterloom::isa::Plugin* rasterloom_isa_plugin() {
    static const rasterloom::isa::Plugin plugin{0, nullptr};
    return &plugin;
}
#else
extern "C" int something_else() {
    return 0;
}
#endif
