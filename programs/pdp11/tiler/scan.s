; SPDX-License-Identifier: MIT
; Looks through the polygon in `message` for its ends.
; In: r1 the number of vertices, 1 or more. Out: r5 and sp the leftmost and the rightmost of the topmost vertices, r3 their y,
; r4 the lowest y; vertices_end. Clobbers r0, r1, r2.

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
