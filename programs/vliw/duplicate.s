; SPDX-License-Identifier: MIT
; A database that stands on the ring `duplication` times (Eldridge 1995, 5.4): lanes t and t + lanes / duplication hold the same polygons.
;
; T := T and this lane is the one that sends a visible polygon whose leftmost column is in register `first` (below 0: column 0): the last
; copy before that column. Not the one in that column, because what a lane wants of its own comes to it by a whole turn of the ring
; (communicate.s). a, b, c, C: spoilt. Without duplication it is nothing.
        .iif ndf duplication, duplication = 1

        .macro  sends first, a, b, c
        .if gt duplication-1
        ld      b, lane
        ld      c, lanes
        asr     a, first, #15
        andn    a, first, a
        add     b, b, #1
        subs    a, a, b
        sbc     b, r0, r0
        and     b, b, c
        add     a, a, b                 ; lanes between here and there,
        mulu    b, a, #duplication, 16
        mulu    a, a, #duplication
        sub     c, c, #1
        teq.and b, r0                   ; fewer than lanes / duplication
        tgeu.and c, a
        .endc
        .endm
