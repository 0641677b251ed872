// SPDX-License-Identifier: MIT
#pragma once

#include <thread>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace rasterloom::lockstep {

inline constexpr int kSpins = 1000;  // looks; some 20 us

inline void spin() {
#if defined(__x86_64__)
    _mm_pause();
#endif
}

// Looks again and again; lets others have the processor when it takes long, since whoever is
// waited for may want it.
template <class Done>
void wait_until(Done done) {
    for (int i = 0; !done(); ++i) {
        if (i < kSpins) {
            spin();
        } else {
            std::this_thread::yield();
        }
    }
}

}  // namespace rasterloom::lockstep
