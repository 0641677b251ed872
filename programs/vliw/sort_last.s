; SPDX-License-Identifier: MIT
; The dense sort-last renderer (Eldridge 1995, 3.2.1): each lane draws its own polygons on the whole screen, band after band; the bands are
; composited. That is sort-twice with one region.
group = 1
deferred = 0
        .include "composited.s"
        .end    start
