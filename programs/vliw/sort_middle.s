; SPDX-License-Identifier: MIT
; The sort-middle renderer (Eldridge 1995, chapter 7): see README.md. Set an option of options.s by a file that assigns it and then includes
; this one.
        .include "options.s"
        .include "memory.s"
        .include "dispatch.s"
        .include "geometry.s"
        .include "communicate.s"
        .include "normalise.s"
        .include "rasterise.s"
        .include "finish.s"
        .end    start
