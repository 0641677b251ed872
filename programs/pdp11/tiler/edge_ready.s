; SPDX-License-Identifier: MIT
; Values and deltas of an edge from a digested polygon: the slopes stand behind vertex a, at r5, and the record of b, at r4,
; behind them, on either side. r2 and r3 are their y.

        .macro  left_neighbour
        mov     r5, r4
        add     #record_size, r4
        .endm

        .macro  right_neighbour
        left_neighbour
        .endm

        .macro  edge_height
        .endm

        .macro  keep_height
        .endm

; As in edge_value.s, but for the height.
        .macro  edge_value at
        .if ne full
        push_start at
        mov     slope_of_'at(r5), to_delta(sp)
        mov     slope_of_'at+2(r5), to_delta+2(sp)
        .iff
        mov     at(r5), -(sp)
        mov     slope_of_'at(r5), to_delta(sp)
        .endc
        .endm

        .macro  edge_value_stepped at
        .if ne full
        push_start at
        .endc
        mov     slope_of_'at(r5), r0
        .if ne full
        mov     slope_of_'at+2(r5), r1
        scale_slope y_step, y_shift
        mov     r0, to_delta(sp)
        mov     r1, to_delta+2(sp)
        .iff
        scale_slope y_step, y_shift
        mov     at(r5), -(sp)
        mov     r0, to_delta(sp)
        .endc
        .endm

        .macro  edge_value_below at
        .if ne full
        mov     slope_of_'at(r5), r3
        mov     slope_of_'at+2(r5), r0
        split_slope r0
        value_after lag, at(r5)
        mov     r1, -(sp)
        mov     r0, -(sp)
        mov     slope_of_'at(r5), r0
        mov     slope_of_'at+2(r5), r1
        scale_slope y_step, y_shift
        mov     r0, to_delta(sp)
        mov     r1, to_delta+2(sp)
        .iff
        mov     slope_of_'at(r5), r0
        value_after lag, at(r5)
        mov     r1, -(sp)
        scale_slope y_step, y_shift
        mov     r0, to_delta(sp)
        .endc
        .endm
