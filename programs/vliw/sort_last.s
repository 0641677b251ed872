; SPDX-License-Identifier: MIT
; The sort-last renderers (Eldridge 1995, 3.2.1): each lane draws its own polygons on the whole screen, band after band. dense 1: the bands are
; composited, which is sort-twice with one region. dense 0: each lane sends what it has drawn to the lanes that draw columns.
        .iif ndf dense, dense = 1
        .if df group
        .error  group is an option of sort-twice: in sort-last it is 1
        .endc
        .if df deferred
        .error  deferred is an option of sort-twice
        .endc
group = 1
deferred = 0
fragments = 1-dense
        .include "regions.s"
        .end    start
