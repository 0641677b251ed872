; SPDX-License-Identifier: MIT
; A database that stands on the ring `duplication` times (Eldridge 1995, 5.4): lanes t and t + lanes / duplication hold the same polygons.
;
; T := this lane is the one that sends a visible polygon whose leftmost column is in register `first`: the last copy before that column. Not the
; one in that column, because a lane that wants what it sends itself gets it only after a whole turn of the ring (communicate.s).
; Without duplication T is set. `a`, `b`, `c` are registers to work with; `first` remains.
        .macro  sends first, a, b, c
        .if gt duplication-1
        ld      a, lane
        ld      b, lanes
        sub     a, first, a
        sub     a, a, #1
        tlt     a, r0
        tget    c
        mul     c, c, b
        add     a, a, c                 ; lanes between here and there
        mulu    b, b, #65536/duplication, 16
        tlt     a, b
        .else
        tge     r0, r0
        .endc
        .endm
