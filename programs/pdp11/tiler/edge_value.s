; SPDX-License-Identifier: MIT
; Values and deltas of an edge from its vertices, a at r5 and b at r4; r2 and r3 are their y.

        .macro  left_neighbour
        next_on_left
        .endm

        .macro  right_neighbour
        next_on_right
        .endm

        .macro  edge_height
        sub     r3, r2
        .endm

        .macro  keep_height
        mov     r2, steps
        .endm

; A value of the side at a, and its delta: both pushed before sp, which is the end of the values still to be made.
; In: the edge's height in r2. Clobbers r0, r1, r3.
        .macro  edge_value at
        .if ne full
        push_start at
        .endc
        mov     at(r4), r1
        sub     at(r5), r1
        divide  r2, r3
        .if ne full
        join_slope r3, r0
        mov     r3, to_delta(sp)
        mov     r0, to_delta+2(sp)
        .iff
        mov     at(r5), -(sp)
        mov     r0, to_delta(sp)
        .endc
        .endm

; The same with rows y_step lines apart.
        .macro  edge_value_stepped at
        .if ne full
        push_start at
        .endc
        mov     at(r4), r1
        sub     at(r5), r1
        divide  r2, r3
        .if ne full
        mov     r0, r1
        mov     r3, r0
        join_slope r0, r1
        scale_slope y_step, y_shift
        mov     r0, to_delta(sp)
        mov     r1, to_delta+2(sp)
        .iff
        mov     at(r5), -(sp)
        scale_slope y_step, y_shift
        mov     r0, to_delta(sp)
        .endc
        .endm

; The same `lag` lines below a. In: the edge's height in `steps`. Clobbers r2, too.
        .macro  edge_value_below at
        mov     at(r4), r1
        sub     at(r5), r1
        divide  steps, r3
        .if ne full
        mov     r3, whole
        mov     r0, r2
        value_after lag, at(r5)
        mov     r1, -(sp)
        mov     r0, -(sp)
        mov     whole, r0
        mov     r2, r1
        join_slope r0, r1
        scale_slope y_step, y_shift
        mov     r0, to_delta(sp)
        mov     r1, to_delta+2(sp)
        .iff
        value_after lag, at(r5)
        mov     r1, -(sp)
        scale_slope y_step, y_shift
        mov     r0, to_delta(sp)
        .endc
        .endm
