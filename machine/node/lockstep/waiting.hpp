// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

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

// Until `value` is no longer `old`, of which the one who changes it notifies. Looks again and
// again, since that is soon; then sleeps, since whoever is waited for may want the processor.
template <class T>
void wait_while(const std::atomic<T>& value, T old) {
    for (int i = 0; i < kSpins; ++i) {
        if (value.load(std::memory_order_acquire) != old) {
            return;
        }
        spin();
    }
    value.wait(old, std::memory_order_acquire);
}

}  // namespace rasterloom::lockstep
