; SPDX-License-Identifier: MIT
; Sides: what happens when one comes to its next vertex.
;
; A side is on an edge from vertex a (at r5) down to vertex b (at r4), the neighbour of a on that side. On the present line its
; values are those of a, or, with a above the line by `lag` lines (interlaced rows), as far down the edge as the line is.

        .ifeq   half_digested
        .include "edge_value.s"
        .else
        .include "edge_ready.s"
        .endc

; One side's part in an event: it goes on along its edge or comes to a vertex. `side'_begins takes the first vertex in r5.
; All this ends at `side'_set.
        .macro  side_event side
side'_event:
        cmp     row, side'_row
        ble     side'_comes
        add_deltas side
        jmp     side'_set
side'_comes:
        beq     tap_vertex_'side
        jmp     side'_late
tap_vertex_'side:
        mov     side'_next, r5
side'_begins:
        mov     (r5), r2
        mov     r2, r0
        asl     r0
        mov     lag_at(r0), r0          ; 0, or 1 more than the lag
; Here r2 is the y of a, r0 0 or 1 more than its height above the present line.
side'_walk:
        .if ne half_digested
        cmp     r2, message_lowest
        beq     side'_ends
        .endc
        side'_neighbour
        mov     (r4), r3
        mov     r3, r1
        asl     r1
        mov     row_at(r1), r1
        cmp     r1, row
        bge     side'_passes
        mov     r1, side'_row
        mov     r4, side'_next
        dec     r0
        bmi     side'_plain
        jmp     side'_below
side'_plain:
        .if ne skip_deltas
        inc     r1
        cmp     r1, row
        bge     side'_exact
        .endc
        edge_height
        mov     #side'_end, sp
        edge_value at_shade
        edge_value at_z
        edge_value at_x
        jmp     side'_set

; b is on this line or above it: if a is on the line the side stands at a and then leaves it at once, at b; else it goes on
; to b, one more vertex between two lines.
side'_passes:
        cmp     r0, #1
        ble     side'_stands
tap_vertex_'side'_passed:
        mov     r4, r5
        br      side'_distance
        .if ne half_digested
side'_ends:                             ; the lowest vertex has no neighbour here
        mov     row, r1
        .endc
side'_stands:
        mov     r1, side'_row
        mov     r4, side'_next
side'_exact:
        mov     at_shade(r5), side'_shade
        mov     at_z(r5), side'_z
        mov     at_x(r5), side'_x
        jmp     side'_set

; The line is below the row of the next vertex already: the side stood at the vertex above it, a horizontal edge; or a part begins
; here, below the vertex.
side'_late:
tap_vertex_'side'_late:
        mov     side'_next, r5
side'_distance:
        mov     (r5), r2
        mov     r2, r0
        mov     row, r1
        asl     r1
        sub     line_of(r1), r0
        inc     r0
        jmp     side'_walk

side'_stepped:
        .if ne skip_deltas
        inc     r1
        cmp     r1, row
        bge     side'_exact
        .endc
        edge_height
        mov     #side'_end, sp
        edge_value_stepped at_shade
        edge_value_stepped at_z
        edge_value_stepped at_x
        jmp     side'_set

side'_below:
        bne     side'_lags
        jmp     side'_stepped
side'_lags:
        mov     r0, lag
        edge_height
        keep_height
        mov     #side'_end, sp
        edge_value_below at_shade
        edge_value_below at_z
        edge_value_below at_x
side'_set:
        .endm

        side_event left
        side_event right

; Lines until the next event: 0 or less stands for 1.
        mov     left_row, r1
        cmp     r1, right_row
        bge     1$
        mov     right_row, r1
1$:
        .if ne full
        cmp     r1, end_row             ; a part may end above
        bge     2$
        mov     end_row, r1
2$:
        .endc
        mov     row, r0
        sub     r1, r0
        mov     r0, lines
        jmp     segment
