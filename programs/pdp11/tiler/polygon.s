; SPDX-License-Identifier: MIT
; A polygon begins: the rows between its highest and its lowest vertex, or those a part is drawn on.

        .ifeq   half_digested

; In: r1 the number of vertices, 1 or more.
tap_polygon:
        .include "scan.s"

        asl     r4
        mov     row_below(r4), r4
        asl     r3
        mov     row_at(r3), r3
        cmp     r3, r4
        ble     next_polygon            ; between two lines
        mov     r4, end_row
        mov     r3, row
        mov     r3, right_row           ; both sides come to their first vertex now
        mov     sp, right_next
tap_vertex_top:
        jmp     left_begins

        .if ne full
; A part. In: r1 minus the number of vertices.
begin_part:
        neg     r1
        mov     r1, vertex_count
tap_polygon_part:
        .include "scan.s"

        part_rows r3, r4
        asl     r4
        mov     row_below(r4), r4
        asl     r3
        mov     row_at(r3), r3
        cmp     r3, r4
        bgt     part_begins
        jmp     next_polygon            ; between two lines
part_begins:
        begin_between
        mov     sp, right_next
tap_vertex_top_part:
        jmp     left_distance
        .endc

        .else

; In: a digested polygon in `message`.
tap_polygon:
        mov     message_lowest, r4
        asl     r4
        mov     row_below(r4), r4
        mov     #message_left, r5
        .if ne full
        mov     message_highest, r3
        .iff
        mov     (r5), r3
        .endc
        asl     r3
        mov     row_at(r3), r3
        cmp     r3, r4
        bgt     1$
        jmp     next_polygon            ; between two lines
1$:     mov     message_right, r0
        add     #message-at_x, r0
        mov     r0, right_next
        .if ne full
        cmp     message_highest, (r5)
        bne     part_begins
        .endc
        mov     r4, end_row
        mov     r3, row
        mov     r3, right_row
tap_vertex_top:
        jmp     left_begins
        .if ne full
part_begins:
        begin_between
tap_vertex_top_part:
        jmp     left_distance
        .endc

        .endc
