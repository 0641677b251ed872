; SPDX-License-Identifier: MIT
; A polygon's set-up: the leftmost and the rightmost of its topmost vertices, the lowest y, and the rows between.
; In: r1 the number of vertices, 1 or more.

tap_polygon:
        mov     r1, r0
        ash     #3, r0
        add     #first_y, r0
        mov     r0, vertices_end
        sub     #vertex_size, r0        ; the last vertex
        mov     r0, r5                  ; top of the left side
        mov     r0, sp                  ; top of the right side
        mov     (r0), r3                ; highest y
        mov     r3, r4                  ; lowest y
        br      5$

1$:     mov     r2, r3                  ; a new top
        mov     r0, r5
        mov     r0, sp
        br      5$
2$:     cmp     at_x(r0), at_x(r5)      ; as high: leftmost and rightmost
        bgt     3$
        mov     r0, r5
3$:     cmp     at_x(r0), at_x(sp)
        blt     5$
        mov     r0, sp
        br      5$

4$:     sub     #vertex_size, r0
        mov     (r0), r2
        cmp     r2, r3
        bgt     1$
        beq     2$
        cmp     r2, r4
        bge     5$
        mov     r2, r4
5$:     sob     r1, 4$

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
