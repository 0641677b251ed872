; SPDX-License-Identifier: MIT
; A polygon begins: the rows between its highest and its lowest vertex.

        .ifeq   half_digested

; In: r1 the number of vertices, 1 or more.
tap_polygon:
        .include "scan.s"

        twice_line_above r4
        mov     row_below(r4), r4
        twice_line r3
        mov     row_at(r3), r3
        cmp     r3, r4
        ble     next_polygon            ; between two lines
        mov     r4, end_row
        mov     r3, row
        mov     r3, right_row           ; both sides come to their first vertex now
        mov     sp, right_next
tap_vertex_top:
        jmp     left_begins

        .else

; In: a digested polygon in `message`.
tap_polygon:
        mov     message_lowest, r4
        twice_line_above r4
        mov     row_below(r4), r4
        mov     #message_left, r5
        mov     (r5), r3
        twice_line r3
        mov     row_at(r3), r3
        cmp     r3, r4
        bgt     1$
        jmp     next_polygon            ; between two lines
1$:     mov     r4, end_row
        mov     r3, row
        mov     r3, right_row
        mov     message_right, r0
        add     #message-at_x, r0
        mov     r0, right_next
tap_vertex_top:
        jmp     left_begins

        .endc
