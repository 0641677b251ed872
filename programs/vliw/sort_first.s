; SPDX-License-Identifier: MIT
; The sort-first renderer (Eldridge 1995, 3.2.1, 4.3.2, 5.5): polygons go to the lanes that draw them, and these do the geometry, each for itself.
; Set an option of options.s by a file that assigns it and then includes this one.
sort_first = 1
        .include "options.s"
        .include "memory.s"
        .include "dispatch.s"
        .include "geometry.s"
        .include "homes.s"
        .if ne migrate
        .include "migrate.s"
        .endc
        .include "distribute.s"
        .include "normalise.s"
        .include "rasterise.s"
        .include "finish.s"
        .end    start_homes
