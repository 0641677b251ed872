// SPDX-License-Identifier: MIT
// To be included before Highway: which instruction sets kernels are compiled for. SSSE3 is left
// out (SSE4 does not come without it), the portable one is in, for tests.
#pragma once

#define HWY_COMPILE_ALL_ATTAINABLE
#define HWY_DISABLED_TARGETS HWY_SSSE3
